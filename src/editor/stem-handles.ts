import { PLACES } from '../core/species/edits.ts';
import type { NumberParameter } from '../core/species/parameter.ts';
import type { StemHandle, StemHandleChange } from '../view/picture/picture.ts';
import type { Actions } from './actions.ts';
import type { DocumentStore } from './document-store.ts';
import { baseOf, presentValue } from './edited-tree.ts';
import type { SessionStore } from './session.ts';

/** The parameter of a level that each handle of a stem drags. */
const KEYS: Readonly<Record<StemHandle, string>> = { length: 'length', down: 'downAngle', curve: 'curve' };

const LAST_LEVEL = 3;

/** The value that a change makes of `from`: on the steps of the parameter, within what it allows. */
export function changedBy(parameter: NumberParameter, from: number, change: StemHandleChange): number {
  const { min, max, step } = parameter;
  const to = from * (change.ratio ?? 1) + (change.degrees ?? 0);
  return Math.min(max, Math.max(min, Number((Math.round(to / step) * step).toFixed(6))));
}

/** Handles of the selected stem as edits of its whole level; a drag is one step of the history. */
export function stemHandles(document: DocumentStore, session: SessionStore, actions: Actions) {
  let taken: { readonly path: string; readonly from: number } | null = null;
  return (kind: StemHandle, change: StemHandleChange, done: boolean): void => {
    const base = baseOf(document, session);
    const { stem, tree } = session.getState();
    if (!taken && base && tree && stem !== null) {
      const path = `levels.${Math.min(tree.stems.level[stem]!, LAST_LEVEL)}.${KEYS[kind]}`;
      const from = PLACES.has(path) ? presentValue(base, document.getState().edits, path) : null;
      if (typeof from !== 'number') return;
      taken = { path, from };
    }
    if (!taken) return;
    // Each time: an undo or another window may have ended the hold meanwhile.
    actions.hold();
    actions.holdEdit();
    const parameter = PLACES.get(taken.path)!.parameter as NumberParameter;
    actions.setParameter(taken.path, changedBy(parameter, taken.from, change));
    if (!done) return;
    taken = null;
    actions.releaseEdit();
    actions.release();
  };
}
