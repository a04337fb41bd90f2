import { html, nothing, type TemplateResult } from 'lit';
import { guard } from 'lit/directives/guard.js';
import { PLACES } from '../../../core/species/edits.ts';
import { treeWords } from '../../words/tree.ts';
import { icon } from '../icons.ts';
import { type Context, idOf, spokenName, stateOf } from './context.ts';
import { numberBox } from './parameter-row.ts';
import { LEVEL_ROWS, type LevelRow, pathsOfRow, type Row } from './sections.ts';
import { valueText } from './value-text.ts';

/** The levels of stems side by side: a row a parameter, a column a level. */
export function levelTable(c: Context): TemplateResult {
  const groups = [...new Set(LEVEL_ROWS.map((row) => row.group))];
  return html`<div class="level-scroll" tabindex="0" role="region" aria-label=${treeWords.tableCaption}><table class="level-table">
    <thead><tr><th scope="col">${treeWords.parameter}</th>${treeWords.levels.map(
      (name, level) =>
        html`<th scope="col" ?data-dimmed=${level >= c.species.tree.levels}><span class="chip" data-level=${level}></span>${name}</th>`,
    )}</tr></thead>
    ${groups.map(
      (
        group,
      ) => html`<tbody><tr class="group-row"><th scope="rowgroup" colspan=${1 + treeWords.levels.length}><span>${treeWords.groups[group]}</span></th></tr>
        ${LEVEL_ROWS.filter((row) => row.group === group).map((row) => line(row, c))}</tbody>`,
    )}</table></div>`;
}

function line(row: LevelRow, c: Context): TemplateResult {
  const some = row.cells.find((cell) => cell !== undefined)!;
  const { key, label: named, help } = PLACES.get(some.path)!.parameter;
  const label = key === 'branches' ? treeWords.numberOf : named;
  return html`<tr><th scope="row"><button type="button" class="about" aria-haspopup="dialog" aria-label=${treeWords.about(label)} title=${help}
      @click=${(e: Event) => c.explain(some.path, e.currentTarget as HTMLElement)}><span class="about-label">${label}</span></button></th>
    ${row.cells.map((cell) => html`<td>${cell ? drawnCell(cell, c) : html`<span class="no-cell">–</span>`}</td>`)}</tr>`;
}

function drawnCell(row: Row, c: Context): unknown {
  const seen = pathsOfRow(row).flatMap((path) => {
    const { value, first, locked } = stateOf(c, path);
    return [String(value), String(first), locked, c.why(path), c.wrong === path];
  });
  return guard([row.path, ...seen], () => {
    const { path, variation } = row;
    const states = pathsOfRow(row).map((each) => stateOf(c, each));
    const why = c.why(path);
    const first = pathsOfRow(row)
      .map((each, i) => valueText(each, states[i]!.first))
      .join(' ± ');
    const reset = (): void => {
      for (const each of pathsOfRow(row)) c.editor.actions.resetParameter(each);
    };
    return html`<span class="cell" ?data-dimmed=${why !== undefined} title=${why === undefined ? '' : treeWords.why[why]}>
      ${numberBox(path, c, states[0]!)}${
        variation && states[1]
          ? html`<span class="plus-minus" aria-hidden="true">${treeWords.plusMinus}</span>${numberBox(variation, c, states[1])}`
          : nothing
      }${
        states.some((s) => s.changed)
          ? html`<button type="button" class="reset" aria-label=${treeWords.reset(spokenName(path), first)} title=${treeWords.resetTo(first)}
              @click=${reset}>${icon('reset')}</button>`
          : nothing
      }${why === undefined ? nothing : html`<span class="spoken" id="${idOf(path)}-why">${treeWords.why[why]}</span>`}</span>`;
  });
}
