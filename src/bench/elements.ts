import { cell, type Table } from '../../bench/report.ts';

/** An element with a text and a class. */
export function element<Name extends keyof HTMLElementTagNameMap>(
  name: Name,
  text = '',
  className = '',
): HTMLElementTagNameMap[Name] {
  const it = document.createElement(name);
  if (text) it.textContent = text;
  if (className) it.className = className;
  return it;
}

/** A table that scrolls sideways by itself where the window is narrow. */
export function tableElement({ caption, columns, rows }: Table): HTMLElement {
  const table = element('table');
  table.append(element('caption', caption));
  const head = table.createTHead().insertRow();
  for (const column of columns) {
    const th = element('th', column);
    th.scope = 'col';
    head.append(th);
  }
  const body = table.createTBody();
  for (const row of rows) {
    const line = body.insertRow();
    for (const value of row) {
      const td = element('td', cell(value), typeof value === 'number' ? 'number' : '');
      line.append(td);
    }
  }
  const frame = element('div', '', 'scroll');
  frame.tabIndex = 0;
  frame.setAttribute('role', 'region');
  frame.setAttribute('aria-label', caption);
  frame.append(table);
  return frame;
}
