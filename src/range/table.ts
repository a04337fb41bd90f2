import { html, type TemplateResult } from 'lit';
import { TABLE_2, TABLE_RANGES, TABLE_ROWS } from '../core/lod/table-2.ts';
import type { DrawnElements } from '../view/wind-tree.ts';
import { count, difference, metres, rangeWords as words } from './words.ts';

/** Part of the printed count that ours may be off before it is marked. */
const TOLERATED = 0.04;

/** Table 2, and what was drawn for it: empty until it was. `choose` takes the range of a column. */
export function rangeTable(
  drawn: readonly DrawnElements[],
  chosen: number,
  choose: (range: number) => void,
): TemplateResult {
  const marked = (range: number): string => (range === chosen ? 'chosen' : '');
  return html`
    <div class="scroll" tabindex="0" role="region" aria-label=${words.tableLabel}>
      <table id="table-2">
        <thead>
          <tr>
            <th scope="col">${words.item}</th>
            ${TABLE_RANGES.map(
              (range) => html`<th scope="col" class=${marked(range)}>
                <button type="button" aria-pressed=${range === chosen} @click=${() => choose(range)}>${metres(range)}</button>
              </th>`,
            )}
          </tr>
        </thead>
        <tbody>
          ${TABLE_ROWS.map(
            (row) => html`<tr>
              <th scope="row">${words.rows[row]}</th>
              ${TABLE_RANGES.map((range, k) => {
                const printed = TABLE_2[row][k] ?? 0;
                const ours = drawn[k]?.[row];
                return html`<td class=${marked(range)}>${ours === undefined ? '…' : cell(ours, printed)}</td>`;
              })}
            </tr>`,
          )}
        </tbody>
      </table>
    </div>`;
}

function cell(ours: number, printed: number): TemplateResult {
  if (ours === 0 && printed === 0) return html`<span class="none">0</span>`;
  const wrong = Math.abs(ours - printed) > TOLERATED * Math.max(printed, 1);
  return html`<span class="ours">${count(ours)}</span><small>${count(printed)}${
    ours === printed ? '' : html` <span class=${wrong ? 'far' : 'off'}>${difference(ours, printed)}</span>`
  }</small>`;
}
