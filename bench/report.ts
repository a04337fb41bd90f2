/** A table of figures, as a bench prints it and the report shows it. */
export interface Table {
  /** What was measured, in one line. */
  readonly caption: string;
  readonly columns: readonly string[];
  readonly rows: readonly (readonly (string | number)[])[];
}

/** What one bench hands over: a page as JSON in `#report`, a Node bench as JSON on its last line. */
export interface BenchReport {
  readonly title: string;
  readonly tables: readonly Table[];
  /** Sentences under the tables: how it was measured, what to make of it. */
  readonly notes?: readonly string[];
  /** Renderer string of the page's context, where there is one. */
  readonly renderer?: string;
}

/** A report that is an error: the page's or the bench's own words. */
export interface FailedReport {
  readonly error: string;
}

/** A number with three figures that count, a text as it is. */
export function cell(value: string | number): string {
  if (typeof value === 'string') return value.replaceAll('|', '\\|');
  if (Number.isInteger(value)) return String(value).replace(/\B(?=(\d{3})+$)/g, ' ');
  return value >= 100 ? value.toFixed(0) : value.toPrecision(3);
}

/** A table as Markdown, under its caption. */
export function tableText({ caption, columns, rows }: Table): string {
  const line = (cells: readonly string[]): string => `| ${cells.join(' | ')} |`;
  const rule = columns.map((_, i) => (rows.every((row) => typeof row[i] === 'number') ? '--:' : '---'));
  return [`**${caption}**`, '', line(columns), line(rule), ...rows.map((row) => line(row.map(cell)))].join('\n');
}

/** A section of the report, between marks by which a later run of this bench alone replaces it. */
export function sectionText(name: string, report: BenchReport, circumstances: string): string {
  const parts = [
    `<!-- ${name} -->`,
    `## ${report.title}`,
    `*${circumstances}${report.renderer ? ` Renderer: ${report.renderer}.` : ''}*`,
    ...report.tables.map(tableText),
    ...(report.notes ?? []),
    `<!-- /${name} -->`,
  ];
  return parts.join('\n\n');
}

/** The report with the section of that name replaced, or added at the end. */
export function withSection(text: string, name: string, section: string): string {
  const start = text.indexOf(`<!-- ${name} -->`);
  const mark = `<!-- /${name} -->`;
  const end = text.indexOf(mark);
  if (start < 0 || end < 0) return `${text.trimEnd()}\n\n${section}\n`;
  return text.slice(0, start) + section + text.slice(end + mark.length);
}
