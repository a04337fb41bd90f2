import { type CameraPose, type LinkDocument, roundCamera, type Theme, type ViewMode } from '../core/link/link.ts';
import { LINK_NUMBERS, roundTo } from '../core/link/numbers.ts';
import { fileActions } from './actions-files.ts';
import { gustActions } from './actions-gusts.ts';
import { timeActions } from './actions-time.ts';
import { waveActions } from './actions-waves.ts';
import { windActions } from './actions-wind.ts';
import type { DocumentStore } from './document-store.ts';
import type { Doing, Services, Time } from './doing.ts';
import { type Preferences, savePreferences } from './preferences.ts';
import type { Detent, Notice, Panel, SessionStore } from './session.ts';

/** Messages that stand at one time: more would cover the picture, and the oldest have been seen. */
const MOST_NOTICES = 4;

export type Actions = ReturnType<typeof createActions>;

/** Everything a reader can do to the document and to the session; the interface, the keys and the tests call these alone. */
export function createActions(
  document: DocumentStore,
  session: SessionStore,
  preferences: Preferences,
  clock: Time,
  services: Services,
) {
  let notices = 0;
  const set = (change: Partial<LinkDocument>): void => document.setState(change);
  const say = (spoken: string): void => session.setState({ spoken });
  const notify = (kind: Notice['kind'], title: string, lines: readonly string[] = []): void => {
    const notice = { id: ++notices, kind, title, lines };
    // A message about the same thing takes the place of the last one.
    const others = session.getState().notices.filter((n) => n.title !== title);
    session.setState({ notices: [...others, notice].slice(-MOST_NOTICES) });
  };
  const doing: Doing = { document, session, preferences, clock, services, set, say, notify };
  const gusts = gustActions(doing);

  return {
    ...timeActions(doing),
    ...windActions(doing),
    ...waveActions(doing),
    ...gusts,
    ...fileActions(doing),

    setSpecies: (species: string) => set({ species, ownSpecies: null, edits: {}, probe: null }),
    openSpecies: (text: string) => set({ ownSpecies: text, edits: {}, probe: null }),
    setSeed: (seed: number) => set({ seed: roundTo(LINK_NUMBERS.seed, seed), probe: null }),
    rollSeed: () => set({ seed: crypto.getRandomValues(new Uint32Array(1))[0]! % 10_000, probe: null }),
    setLevels: (levelsShown: number) => set({ levelsShown }),
    setShowLeaves: (showLeaves: boolean) => set({ showLeaves }),
    setView: (view: ViewMode) => set({ view }),
    setCamera: (camera: CameraPose | null) => set({ camera: camera && roundCamera(camera) }),
    setTheme(theme: Theme): void {
      preferences.theme = theme;
      savePreferences(preferences);
      set({ theme });
    },

    notify,
    dismiss(id: number): void {
      session.setState({ notices: session.getState().notices.filter((n) => n.id !== id) });
    },
    /** Takes back a message whose cause is gone. */
    retract(title: string): void {
      session.setState({ notices: session.getState().notices.filter((n) => n.title !== title) });
    },
    say,
    share: services.share,
    cancelGrowing: services.cancelGrowing,
    setHelp: (help: boolean) => session.setState({ help }),
    setTab: (tab: Panel) => session.setState({ tab }),
    setDetent: (detent: Detent) => session.setState({ detent }),
    hideHint(): void {
      if (session.getState().hint) session.setState({ hint: '' });
    },
    /** Leaves the mode that the page is in; false where it is in none. */
    leave(): boolean {
      const { throwing, gust } = session.getState();
      if (throwing) gusts.setThrowing(false);
      else if (gust !== null) session.setState({ gust: null });
      else return false;
      return true;
    },
    setFold(name: string, open: boolean): void {
      preferences.folds[name] = open;
      savePreferences(preferences);
    },
    /** Pixels; null: as it is at first. */
    setStudioHeight(height: number | null): void {
      preferences.studioHeight = height;
      savePreferences(preferences);
    },
    setShortcuts(on: boolean): void {
      preferences.shortcuts = on;
      savePreferences(preferences);
    },
  };
}
