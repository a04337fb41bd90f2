import { html, nothing, type TemplateResult } from 'lit';
import { live } from 'lit/directives/live.js';
import { PLACES } from '../../../core/species/edits.ts';
import type { ChoiceParameter, NumberParameter, NumbersParameter } from '../../../core/species/parameter.ts';
import { treeWords } from '../../words/tree.ts';
import { toggle } from '../choice.ts';
import { icon } from '../icons.ts';
import { amount } from '../number-field.ts';
import { unlessTyping } from '../unless-typing.ts';
import { type Context, idOf, type State, spokenName } from './context.ts';
import { crownEditor } from './crown-editor.ts';
import { marginEditor } from './margin-editor.ts';
import { shapePicker } from './shape-picker.ts';
import { standIn } from './stand-in.ts';
import { numberText, unitOf, valueText } from './value-text.ts';

/** The control of a parameter that is no plain number: a name, a switch, a choice, a colour, a list, a curve. */
export function otherControl(path: string, c: Context, state: State): TemplateResult {
  const { parameter } = PLACES.get(path)!;
  if (path === 'tree.shape') return shapePicker(path, c, state);
  if (path === 'tree.crown') return crownEditor(path, c, state);
  if (path === 'foliage.margin') return marginEditor(path, c, state);
  switch (parameter.kind) {
    case 'number':
      return named(path, parameter, c, state);
    case 'choice':
      return choices(path, parameter, c, state);
    case 'flag':
      return html`<span class="amounts">${toggle(
        idOf(path),
        html`<span class="spoken">${parameter.label}</span>`,
        state.value === true,
        (on) => c.set(path, on),
        { name: spokenName(path), title: parameter.help },
      )}</span>`;
    case 'colour':
      return colour(path, c, state);
    case 'numbers':
      return list(path, parameter, c, state);
  }
}

/** One of a few, or none of them where it may be absent. */
function choices(path: string, parameter: ChoiceParameter, c: Context, state: State): TemplateResult {
  const options = parameter.choices.map((choice) => ({ value: choice, label: choice }));
  if (parameter.default === undefined) options.unshift({ value: '', label: valueText(path, null) });
  return select(path, options, state.value === null ? '' : String(state.value), (value) =>
    c.set(path, value === '' ? null : value),
  );
}

/** An id that stands for something: its names to choose from. */
function named(path: string, parameter: NumberParameter, c: Context, state: State): TemplateResult {
  const options = parameter.names!.map((name, id) => ({ value: String(id), label: name }));
  if (parameter.default === undefined) options.unshift({ value: '', label: valueText(path, null) });
  return select(path, options, state.value === null ? '' : String(state.value), (value) =>
    c.set(path, value === '' ? null : Number(value)),
  );
}

const select = (
  path: string,
  options: readonly { readonly value: string; readonly label: string }[],
  value: string,
  onChoose: (value: string) => void,
): TemplateResult => html`<span class="amounts wide"><select id=${idOf(path)} aria-label=${spokenName(path)} .value=${live(value)}
    @change=${(e: Event) => onChoose((e.target as HTMLSelectElement).value)}>${options.map(
      (o) => html`<option value=${o.value} ?selected=${o.value === value}>${o.label}</option>`,
    )}</select></span>`;

/** With which a colour begins that nothing else stands in for: that of turned leaves and young bark. */
const FIRST_COLOUR = '#b8863b';

/** A colour to pick, and to type as #rrggbb; where it may be absent, to add and to take out. */
function colour(path: string, c: Context, state: State): TemplateResult {
  const mayGo = PLACES.get(path)!.parameter.default === undefined;
  if (state.value === null) {
    const instead = standIn(c.species, path);
    return html`<span class="amounts wide colours">${
      typeof instead === 'string' ? html`<span class="swatch" style="background: ${instead}"></span>` : nothing
    }<button type="button" class="quiet add-colour" aria-label=${treeWords.addColour(spokenName(path))}
      @click=${() => c.set(path, typeof instead === 'string' ? instead : FIRST_COLOUR)}>${valueText(path, null)}${icon('plus')}</button></span>`;
  }
  const value = String(state.value);
  const typed = (event: Event): void => {
    const box = event.target as HTMLInputElement;
    const found = /^#?([0-9a-f]{6}|[0-9a-f]{3})$/i.exec(box.value.trim())?.[1];
    if (found === undefined) {
      box.value = value;
      c.setWrong(path);
      return;
    }
    c.set(path, `#${found.length === 3 ? [...found].map((x) => x + x).join('') : found}`.toLowerCase());
  };
  return html`<span class="amounts wide colours">${
    mayGo
      ? html`<button type="button" class="round take-out" aria-label=${treeWords.takeOut(spokenName(path))} title=${valueText(path, null)}
          @click=${() => c.set(path, null)}>${icon('close')}</button>`
      : nothing
  }<input type="text" class="hex" id="${idOf(path)}-text" aria-label="${spokenName(path)}, ${treeWords.hex}"
      spellcheck="false" autocomplete="off" maxlength="9" .value=${unlessTyping(value)} @change=${typed}><input type="color" data-drag id=${idOf(path)} aria-label=${spokenName(path)}
      .value=${live(value)} @input=${(e: Event) => c.set(path, (e.target as HTMLInputElement).value)}></span>`;
}

/** A number for each level, the last for all deeper ones. */
function list(path: string, parameter: NumbersParameter, c: Context, state: State): TemplateResult {
  const values = Array.isArray(state.value) ? (state.value as readonly number[]) : (parameter.default ?? []);
  const levels = Math.max(4, values.length);
  const at = (level: number): number => values[Math.min(level, values.length - 1)] ?? parameter.min;
  const set = (level: number, value: number): void => {
    const filled = Array.from({ length: Math.max(values.length, level + 1) }, (_, i) => (i === level ? value : at(i)));
    c.set(path, filled);
  };
  return html`<span class="list">${Array.from({ length: levels }, (_, level) => {
    const name = treeWords.levels[level] ?? String(level);
    return html`<span class="of-level"><span class="level-name" aria-hidden="true"><span class="chip" data-level=${Math.min(level, 3)}></span>${name}</span>
      ${amount({
        id: `${idOf(path)}-${level}`,
        name: treeWords.ofLevel(spokenName(path), name),
        unit: unitOf(parameter),
        shown: numberText(at(level), parameter.step),
        min: parameter.min,
        max: parameter.max,
        step: parameter.step,
        onTyped: (value) => set(level, value),
        onWrong: () => c.setWrong(path),
      })}</span>`;
  })}</span>`;
}
