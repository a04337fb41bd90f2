import type { Check, Report } from './report.ts';

const number = (value: number): string => (value === -1 ? 'not a number' : value === 0 ? '0' : value.toExponential(1));

/** One row; all that is shown is text. */
function row(check: Check): HTMLTableRowElement {
  const tr = document.createElement('tr');
  tr.className = check.pass ? 'pass' : 'fail';
  const name = document.createElement('th');
  name.scope = 'row';
  name.textContent = check.name;
  tr.append(name);
  const cell = (title: string, text: string, isNumber: boolean) => {
    const td = document.createElement('td');
    td.dataset.name = title;
    td.textContent = text;
    if (isNumber) td.className = 'number';
    tr.append(td);
  };
  cell('Result', check.pass ? 'passes' : 'FAILS', false);
  cell('Largest error', number(check.maxError), true);
  cell('Tolerance', number(check.tolerance), true);
  cell('Samples', String(check.samples), true);
  cell('The error is', check.note, false);
  return tr;
}

const element = (id: string): HTMLElement => {
  const found = document.getElementById(id);
  if (!found) throw new Error(`The page has no element #${id}.`);
  return found;
};

/** Adds checks to the page's table while the run goes on. */
export function showChecks(checks: readonly Check[]): void {
  element('checks').append(...checks.map(row));
}

/** Names the GPU that is checked. */
export function showRenderer(name: string): void {
  element('renderer').textContent = `GPU: ${name}`;
}

/** The verdict in words and the report as JSON: whoever waits for `#report` waits for the end. */
export function showReport(report: Report): void {
  const failed = report.checks.filter((check) => !check.pass).length;
  const verdict = element('verdict');
  verdict.className = report.pass ? 'pass' : 'fail';
  verdict.textContent =
    report.reason ??
    (report.pass
      ? `This GPU agrees with the reference in all ${report.checks.length} checks (${(report.milliseconds / 1000).toFixed(1)} s).`
      : `This GPU disagrees with the reference in ${failed} of ${report.checks.length} checks.`);
  element('report').textContent = JSON.stringify(report, null, 1);
}
