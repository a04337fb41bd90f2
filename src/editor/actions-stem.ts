import type { StemTable } from '../core/pack/stem-table.ts';
import { watch } from './document-store.ts';
import type { Doing } from './doing.ts';
import type { SessionStore } from './session.ts';
import { stemWords } from './words/stem.ts';

/** Levels that a panel shows; deeper stems have the last one's numbers. */
const LAST_LEVEL = 3;

/** What a reader can do to stems, and to the panel that shows their numbers. */
export function stemActions({ session, say }: Doing) {
  const setLevel = (level: number): void => {
    const shown = Math.min(Math.max(Math.round(level), 0), LAST_LEVEL);
    if (session.getState().level !== shown) session.setState({ level: shown });
  };
  return {
    /** Selects a stem of the tree on the screen, and shows its level in the panel; null: none. */
    selectStem(stem: number | null): void {
      const stems = session.getState().tree?.stems;
      if (stem === null || !stems || !(stem >= 0 && stem < stems.count)) {
        if (session.getState().stem !== null) session.setState({ stem: null, stemPath: null });
        return;
      }
      session.setState({ stem, stemPath: stems.path[stem]! });
      setLevel(stems.level[stem]!);
      say(stemName(stems, stem));
    },
    hoverStem(hoveredStem: number | null): void {
      if (session.getState().hoveredStem !== hoveredStem) session.setState({ hoveredStem });
    },
    setLevel,
    /** A locked parameter keeps its value when the species changes and when trees are varied. */
    toggleLock(path: string): void {
      const locks = new Set(session.getState().locks);
      if (!locks.delete(path)) locks.add(path);
      session.setState({ locks });
    },
    clearLocks(): void {
      if (session.getState().locks.size > 0) session.setState({ locks: new Set() });
    },
    /** The pruning envelope stands around the tree in the scene. */
    showEnvelope(envelopeShown: boolean): void {
      if (session.getState().envelopeShown !== envelopeShown) session.setState({ envelopeShown });
    },
  };
}

/** What a stem is called: 'Limb 7 of 32'. */
export const stemName = (stems: StemTable, stem: number): string => {
  const level = stems.level[stem]!;
  return stemWords.name(level, stems.numberInLevel[stem]!, stems.countOfLevel[level]!, stems.clone[stem] === 1);
};

/** Lets the selection find its stem in every tree that takes the last one's place; it goes with a stem that is gone. */
export function followStem(session: SessionStore): void {
  watch(
    session,
    (s) => s.tree?.stems,
    (stems) => {
      const { stemPath, stem, hoveredStem } = session.getState();
      const found = stems && stemPath !== null ? stems.path.indexOf(stemPath) : -1;
      const now = found >= 0 ? found : null;
      // A draft may lack the stem; the whole tree after it has it again.
      const gone = now === null && session.getState().tree?.draft !== true;
      if (now !== stem || hoveredStem !== null)
        session.setState({ stem: now, stemPath: gone ? null : stemPath, hoveredStem: null });
    },
  );
}
