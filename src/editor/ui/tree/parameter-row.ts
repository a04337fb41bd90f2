import { html, nothing, type TemplateResult } from 'lit';
import { guard } from 'lit/directives/guard.js';
import { PLACES } from '../../../core/species/edits.ts';
import type { NumberParameter } from '../../../core/species/parameter.ts';
import { treeWords } from '../../words/tree.ts';
import { icon } from '../icons.ts';
import { amount, slider } from '../number-field.ts';
import { type Context, idOf, labelOf, type State, spokenName, stateOf } from './context.ts';
import { otherControl } from './other-controls.ts';
import { allowedText } from './popover-text.ts';
import { pathsOfRow, type Row } from './sections.ts';
import { standIn, standInText } from './stand-in.ts';
import { numberText, unitOf, valueText } from './value-text.ts';

/** A parameter, its variation beside it: drawn again only when something of it has changed. `again`: why it does nothing is said above. */
export function parameterRow(row: Row, c: Context, again = false): unknown {
  const paths = pathsOfRow(row);
  const seen = paths.flatMap((path) => {
    const { value, first, locked } = stateOf(c, path);
    const { min, max } = c.reach(path);
    // What holds where it is absent is drawn, too.
    const whenAbsent = value === null ? standInText(c.species, path) + String(standIn(c.species, path)) : '';
    return [String(value), whenAbsent, String(first), locked, c.why(path), min, max, c.wrong === path];
  });
  // What is drawn over the tree, or with the shape of another parameter, follows that, too.
  if (row.path === 'tree.shape') seen.push(JSON.stringify(c.species.pruning));
  const drawn = row.path === 'tree.crown' && stateOf(c, row.path).value !== null;
  const { baseSize } = c.species.tree;
  const behind = drawn ? [c.silhouette(), baseSize, c.species.levels[1]?.length] : [];
  if (row.path === 'foliage.margin') behind.push(c.species.leaves.scaleX);
  return guard([row.path, again, ...seen, ...behind], () => draw(row, c, again));
}

function draw(row: Row, c: Context, again: boolean): TemplateResult {
  const { path, variation } = row;
  const states = pathsOfRow(row).map((each) => stateOf(c, each));
  const [state, other] = states as [State, State?];
  const why = c.why(path);
  const whyToo = variation === undefined ? undefined : c.why(variation);
  const { parameter } = PLACES.get(path)!;
  const changed = states.some((s) => s.changed);
  const wrong = pathsOfRow(row).find((each) => each === c.wrong);
  const plain = parameter.kind === 'number' && !parameter.names;
  const id = idOf(path);
  return html`<div class="field parameter" data-path=${path} ?data-changed=${changed} ?data-dimmed=${why !== undefined}
      ?data-locked=${states.some((s) => s.locked)}>
    ${heading(row, c, states)}
    ${
      plain
        ? html`<span class="amounts">${numberBox(path, c, state)}${
            variation && other
              ? html`<span class="plus-minus" aria-hidden="true">${treeWords.plusMinus}</span>${numberBox(variation, c, other)}`
              : nothing
          }</span>
          <span class="sliders" ?data-two=${variation !== undefined}>${numberSlider(path, c, state, other)}${
            variation && other ? numberSlider(variation, c, other) : nothing
          }</span>`
        : otherControl(path, c, state)
    }
    ${
      plain && state.value === null
        ? html`<p class="why">${standInText(c.species, path) || treeWords.unsaid}</p>`
        : nothing
    }
    ${wrong === undefined ? nothing : html`<p class="wrong-typed" role="alert">${allowedText(wrong)}</p>`}
    ${why === undefined ? nothing : html`<p class=${again ? 'spoken' : 'why'} id="${id}-why">${treeWords.why[why]}</p>`}
    ${
      why !== undefined || whyToo === undefined
        ? nothing
        : html`<p class="why" id="${idOf(variation!)}-why">${treeWords.plusMinus} ${treeWords.why[whyToo]}</p>`
    }
  </div>`;
}

/** The label, which explains the parameter, and what puts it back. */
export function heading(row: Row, c: Context, states: readonly State[]): TemplateResult {
  const { path } = row;
  const { parameter } = PLACES.get(path)!;
  const first = pathsOfRow(row)
    .map((each, i) => valueText(each, states[i]!.first))
    .join(' ± ');
  const changed = states.some((s) => s.changed);
  const locked = states.some((s) => s.locked);
  const marks = [changed ? treeWords.changed(first) : '', locked ? treeWords.lockedMark : '']
    .filter(Boolean)
    .join(', ');
  const name = spokenName(path);
  const reset = (): void => {
    for (const each of pathsOfRow(row)) c.editor.actions.resetParameter(each);
  };
  return html`<button type="button" class="about" id="${idOf(path)}-about" aria-haspopup="dialog" aria-label=${[name, marks].filter(Boolean).join(', ')} title=${parameter.help}
      @click=${(e: Event) => c.explain(path, e.currentTarget as HTMLElement)}><span class="about-label">${labelOf(path)}</span>${
        locked ? icon('lock') : nothing
      }</button>${
        changed
          ? html`<button type="button" class="reset" aria-label=${treeWords.reset(name, first)} title=${treeWords.resetTo(first)}
              @click=${reset}>${icon('reset')}</button>`
          : nothing
      }`;
}

/** Whether there is a value only where one is given: angles of leaves (weber-penn.md, row 42), what a season changes. */
const isOwn = (parameter: NumberParameter): boolean => !!parameter.optional && parameter.default === undefined;

/** The number that holds where a value is absent. */
const inherited = (c: Context, path: string): number => Number(standIn(c.species, path) ?? 0);

const describedBy = (path: string, c: Context): { readonly describedBy?: string } =>
  c.why(path) === undefined ? {} : { describedBy: `${idOf(path)}-why` };

/** The box of a number; `table`: an id of its own, no text around it. */
export function numberBox(path: string, c: Context, state: State): TemplateResult {
  const parameter = PLACES.get(path)!.parameter as NumberParameter;
  const { min, max, step } = parameter;
  return amount({
    id: `${idOf(path)}-number`,
    name: spokenName(path),
    unit: unitOf(parameter),
    shown: typeof state.value === 'number' ? numberText(state.value, step) : '',
    ...(isOwn(parameter)
      ? { placeholder: numberText(inherited(c, path), step), onEmptied: () => c.set(path, null) }
      : {}),
    min,
    max,
    step,
    ...describedBy(path, c),
    onTyped: (value) => c.set(path, value),
    onWrong: () => c.setWrong(path),
  });
}

function numberSlider(path: string, c: Context, state: State, variation?: State): TemplateResult {
  const parameter = PLACES.get(path)!.parameter as NumberParameter;
  const value = typeof state.value === 'number' ? state.value : inherited(c, path);
  const band = variation && typeof variation.value === 'number' ? { band: variation.value } : {};
  return slider({
    id: idOf(path),
    name: spokenName(path),
    unit: unitOf(parameter),
    value,
    shown: numberText(value, parameter.step),
    ...c.reach(path),
    step: parameter.step,
    ...(typeof state.first === 'number' ? { reset: state.first } : {}),
    marks: { ...(state.changed && typeof state.first === 'number' ? { tick: state.first } : {}), ...band },
    ...describedBy(path, c),
    onInput: (next) => c.set(path, next),
  });
}
