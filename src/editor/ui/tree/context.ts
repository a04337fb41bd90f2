import { type ParameterValue, PLACES, sameValue, valueAt } from '../../../core/species/edits.ts';
import type { Species } from '../../../core/species/species.ts';
import type { Editor } from '../../editor.ts';
import { treeWords } from '../../words/tree.ts';
import type { Range } from './comfort.ts';
import type { Why } from './no-effect.ts';
import type { Silhouette } from './silhouette.ts';

/** What the controls of parameters are drawn from. */
export interface Context {
  readonly editor: Editor;
  /** Without the edits. */
  readonly base: Species;
  /** With them. */
  readonly species: Species;
  readonly locks: ReadonlySet<string>;
  /** The parameter in whose box something was typed that it may not be, or null. */
  readonly wrong: string | null;
  /** Why a parameter does nothing at present. */
  why(path: string): Why | undefined;
  /** What its slider reaches: never less than it did. */
  reach(path: string): Range;
  set(path: string, value: ParameterValue): void;
  setAll(values: Readonly<Record<string, ParameterValue>>): void;
  setWrong(path: string | null): void;
  /** The tree on the screen from the side; null before there is one. */
  silhouette(): Silhouette | null;
  /** The half width that a drawing shows: as wished, but never less than it did while it is open. */
  stretch(drawing: 'crown' | 'envelope', half: number): number;
  /** Opens what explains a parameter, beside `anchor`. */
  explain(path: string, anchor: HTMLElement): void;
}

/** What a parameter has now, had at first, and what is to be said of it. */
export interface State {
  readonly value: ParameterValue;
  readonly first: ParameterValue;
  readonly changed: boolean;
  readonly locked: boolean;
}

export function stateOf(c: Context, path: string): State {
  const value = valueAt(c.species, path);
  const first = valueAt(c.base, path);
  return { value, first, changed: !sameValue(value, first), locked: c.locks.has(path) };
}

/** Id of the control of a parameter. */
export const idOf = (path: string): string => `p-${path.replaceAll('.', '-')}`;

/** What a parameter is called beside its control: 'Down angle'. */
export const labelOf = (path: string): string => treeWords.labels[path] ?? PLACES.get(path)!.parameter.label;

/** What screen readers call a control: 'Limbs: Down angle'. */
export function spokenName(path: string): string {
  const { level } = PLACES.get(path)!;
  return treeWords.control(labelOf(path), level === undefined ? undefined : treeWords.levels[level]);
}
