import { allowed, type Control, digitsOf, isChoice, isNumber, type NumberControl, type Value } from './controls.ts';
import { words } from './words.ts';

/** One control of a figure, as the page has it. */
export interface ControlRow {
  readonly element: HTMLElement;
  show(value: Value): void;
}

/** Called with what the reader chose; `done` is false while a slider is still held. */
export type Told = (value: Value, done: boolean) => void;

function made<Name extends keyof HTMLElementTagNameMap>(
  name: Name,
  className = '',
  text = '',
): HTMLElementTagNameMap[Name] {
  const element = document.createElement(name);
  if (className) element.className = className;
  if (text) element.textContent = text;
  return element;
}

/** A slider with the number beside it, which can be typed; a double click on its name or on the slider sets it back. */
function numberRow(control: NumberControl, id: string, told: Told): ControlRow {
  const { min, max, step, label, unit } = control;
  const element = made('div', 'control number');
  const name = made('label', 'name', label);
  name.htmlFor = id;
  const slider = made('input');
  slider.type = 'range';
  slider.id = id;
  const typed = made('input', 'typed');
  typed.type = 'number';
  typed.setAttribute('aria-label', words.typed(label));
  for (const input of [slider, typed]) {
    input.min = String(min);
    input.max = String(max);
    input.step = String(step);
  }
  typed.step = 'any';
  const tell = (text: string, done: boolean): void => {
    const value = allowed(control, text);
    if (value !== undefined) told(value, done);
  };
  slider.addEventListener('input', () => tell(slider.value, false));
  slider.addEventListener('change', () => tell(slider.value, true));
  typed.addEventListener('change', () => tell(typed.value, true));
  const back = (): void => told(control.value, true);
  slider.addEventListener('dblclick', back);
  name.addEventListener('dblclick', back);
  element.append(name, slider, typed, made('span', 'unit', unit ?? ''));
  return {
    element,
    show(value) {
      slider.value = String(value);
      if (unit) slider.setAttribute('aria-valuetext', `${Number(value).toFixed(digitsOf(step))} ${unit}`);
      if (document.activeElement !== typed || allowed(control, typed.value) !== value)
        typed.value = Number(value).toFixed(digitsOf(step));
    },
  };
}

/** The row of any control; `id` is unique in the page. */
export function controlRow(control: Control, id: string, told: Told): ControlRow {
  if (isNumber(control)) return numberRow(control, id, told);
  const element = made('div', 'control');
  const name = made('label', 'name', control.label);
  name.htmlFor = id;
  if (isChoice(control)) {
    const select = made('select');
    select.id = id;
    select.append(...control.options.map(({ value, label }) => new Option(label, value)));
    select.addEventListener('change', () => told(select.value, true));
    element.append(name, select);
    return {
      element,
      show: (value) => {
        select.value = String(value);
      },
    };
  }
  const box = made('input');
  box.type = 'checkbox';
  box.id = id;
  box.addEventListener('change', () => told(box.checked, true));
  element.classList.add('switch');
  element.append(box, name);
  return {
    element,
    show: (value) => {
      box.checked = value === true;
    },
  };
}
