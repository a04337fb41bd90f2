/** A table of numbers of equal length; a column's name holds its unit. */
export interface NumberTable {
  readonly name: string;
  readonly columns: readonly { readonly name: string; readonly values: Float64Array }[];
}

/** Seven digits: more than a float32 has, and a file that is read back gives the same plot. */
const cell = (value: number): string => (Number.isFinite(value) ? String(Number(value.toPrecision(7))) : '');

/** The table as CSV (RFC 4180): a header, then one line a row. */
export function csvOf({ columns }: NumberTable): string {
  const quoted = (text: string): string => (/[",\n]/.test(text) ? `"${text.replaceAll('"', '""')}"` : text);
  const rows = Array.from({ length: columns[0]?.values.length ?? 0 }, (_, row) =>
    columns.map(({ values }) => cell(values[row] ?? Number.NaN)).join(','),
  );
  return `${[columns.map((c) => quoted(c.name)).join(','), ...rows].join('\r\n')}\r\n`;
}

/** Gives the reader a file. */
export function download(name: string, text: string): void {
  const url = URL.createObjectURL(new Blob([text], { type: 'text/csv;charset=utf-8' }));
  const link = document.createElement('a');
  link.href = url;
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(url), 10_000);
}
