import { LINK_NUMBERS, roundTo } from '../core/link/numbers.ts';
import { mayBe, type ParameterValue, PLACES, type SpeciesEdits } from '../core/species/edits.ts';
import { parseSpecies } from '../core/species/parse.ts';
import { roundValue } from '../core/species/round-value.ts';
import { treeNameOf } from '../core/species/tree-name.ts';
import type { Doing } from './doing.ts';
import { baseOf, presentValue, withEdits } from './edited-tree.ts';
import { loadedSpecies } from './species-source.ts';

/** Seeds that a roll gives: short enough to be told by voice. */
const ROLLED = 10_000;

/** What a reader can do to the tree: its species, the numbers of the species, its seed and its name. */
export function treeActions({ document, session, set }: Doing) {
  const base = () => baseOf(document, session);
  const put = (edits: SpeciesEdits): void => {
    // Pieces are counted anew: what the probe stuck to is another one.
    if (edits !== document.getState().edits) set({ edits, probe: null });
  };
  /** The locked values of the tree that is there, for the next one. */
  const locked = (): Readonly<Record<string, ParameterValue>> => {
    const of = base();
    const { edits } = document.getState();
    return Object.fromEntries(
      [...session.getState().locks]
        .filter((path) => PLACES.has(path) && (of || Object.hasOwn(edits, path)))
        .map((path) => [path, of ? presentValue(of, edits, path) : edits[path]!]),
    );
  };
  const setParameters = (values: Readonly<Record<string, unknown>>): boolean => {
    const rounded: Record<string, ParameterValue> = {};
    for (const [path, value] of Object.entries(values)) {
      if (!mayBe(path, value)) return false;
      rounded[path] = roundValue(PLACES.get(path)!.parameter, value);
    }
    put(withEdits(base(), document.getState().edits, rounded));
    return true;
  };

  return {
    /** Sets a number of the species; false, and nothing changes, where it may not be that. Paths are those of `PLACES`. */
    setParameter: (path: string, value: ParameterValue): boolean => setParameters({ [path]: value }),
    /** Sets several at once; false, and none changes, where one of them may not be that. */
    setParameters,
    /** Gives a parameter the value of the species again. */
    resetParameter(path: string): void {
      const { [path]: _, ...others } = document.getState().edits;
      if (_ !== undefined) put(others);
    },
    /** Takes all edits back, save what is locked. */
    resetAll(): void {
      const { locks } = session.getState();
      const { edits } = document.getState();
      const kept = Object.fromEntries(Object.entries(edits).filter(([path]) => locks.has(path)));
      if (Object.keys(kept).length < Object.keys(edits).length) put(kept);
    },
    /** Shows a species that ships; locked parameters keep their values. */
    setSpecies(species: string): void {
      const edits = withEdits(loadedSpecies(species), {}, locked());
      set({ species, ownSpecies: null, treeName: null, edits, probe: null });
    },
    /** Shows a species of the reader's own: the text of its file; locked parameters keep their values. */
    openSpecies(text: string): void {
      const edits = withEdits(parseSpecies(text).species ?? null, {}, locked());
      set({ ownSpecies: text, treeName: null, edits, probe: null });
    },
    setSeed: (seed: number) => set({ seed: roundTo(LINK_NUMBERS.seed, seed), probe: null }),
    rollSeed: () => set({ seed: crypto.getRandomValues(new Uint32Array(1))[0]! % ROLLED, probe: null }),
    /** Calls the tree something else than its species; an empty name takes that back. */
    setName(name: string): void {
      const called = treeNameOf(name);
      const treeName = called === base()?.name ? null : called;
      if (treeName !== document.getState().treeName) set({ treeName });
    },
    /** A control is being dragged: trees may be drafts until it is let go. */
    holdEdit(): void {
      if (!session.getState().editing) session.setState({ editing: true });
    },
    releaseEdit(): void {
      if (session.getState().editing) session.setState({ editing: false });
    },
    /** Shows the species without the edits, as long as it is on. */
    setPeek(peek: boolean): void {
      if (session.getState().peek !== peek) session.setState({ peek });
    },
  };
}
