import { type Table, tableText } from '../../bench/report.ts';

const quoted = (value: string | number): string => {
  const text = String(value);
  return /[",\n]/.test(text) ? `"${text.replaceAll('"', '""')}"` : text;
};

/** Tables one after the other as comma-separated values: each begins with its caption. */
export const csvOf = (tables: readonly Table[], renderer: string): string =>
  [
    quoted(renderer),
    ...tables.flatMap(({ caption, columns, rows }) => [
      '',
      quoted(caption),
      columns.map(quoted).join(),
      ...rows.map((row) => row.map(quoted).join()),
    ]),
    '',
  ].join('\r\n');

/** The same as Markdown. */
export const markdownOf = (tables: readonly Table[], renderer: string): string =>
  [renderer, ...tables.map(tableText), ''].join('\n\n');
