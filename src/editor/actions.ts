import {
  type CameraPose,
  type LinkDocument,
  roundCamera,
  type StageId,
  type Theme,
  type ViewMode,
} from '../core/link/link.ts';
import type { Season } from '../core/species/season.ts';
import type { Quality } from '../view/picture/quality.ts';
import { exportActions } from './actions-export.ts';
import { fileActions } from './actions-files.ts';
import { galleryActions } from './actions-gallery.ts';
import { gustActions } from './actions-gusts.ts';
import { historyActions } from './actions-history.ts';
import { projectActions } from './actions-project.ts';
import { snapshotActions } from './actions-snapshots.ts';
import { stemActions } from './actions-stem.ts';
import { timeActions } from './actions-time.ts';
import { treeActions } from './actions-tree.ts';
import { waveActions } from './actions-waves.ts';
import { windActions } from './actions-wind.ts';
import { asSteps } from './as-steps.ts';
import type { DocumentStore } from './document-store.ts';
import type { Doing, Services, Time } from './doing.ts';
import { type Preferences, savePreferences } from './preferences.ts';
import type { Detent, Dialog, Notice, Panel, SessionStore } from './session.ts';

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
  const notify: Doing['notify'] = (kind, title, lines = [], offer) => {
    const notice: Notice = { id: ++notices, kind, title, lines, ...(offer ? { offer } : {}) };
    // A message about the same thing takes the place of the last one.
    const others = session.getState().notices.filter((n) => n.title !== title);
    session.setState({ notices: [...others, notice].slice(-MOST_NOTICES) });
  };
  const doing: Doing = { document, session, preferences, clock, services, set, say, notify };
  const gusts = gustActions(doing);
  const readers = { ...fileActions(doing), ...treeActions(doing), ...snapshotActions(doing) };

  return asSteps(document.history, {
    ...timeActions(doing),
    ...windActions(doing),
    ...waveActions(doing),
    ...gusts,
    ...readers,
    ...historyActions(doing),
    ...projectActions(doing, readers),
    ...stemActions(doing),
    ...exportActions(doing),
    ...galleryActions(doing, readers),

    setLevels: (levelsShown: number) => set({ levelsShown }),
    setShowLeaves: (showLeaves: boolean) => set({ showLeaves }),
    setView: (view: ViewMode) => set({ view }),
    setSeason: (season: Season) => set({ season }),
    setStage: (stage: StageId) => set({ stage }),
    /** Hour of the day by the sun, 0..24; null: the stage's own. */
    setHour: (hour: number | null) => set({ hour }),
    setCamera: (camera: CameraPose | null) => set({ camera: camera && roundCamera(camera) }),
    setTheme(theme: Theme): void {
      preferences.theme = theme;
      savePreferences(preferences);
      set({ theme });
    },

    setQuality(quality: Quality): void {
      preferences.quality = quality;
      savePreferences(preferences);
      session.setState({ quality });
    },
    /** Photo mode, in and out. */
    setPhoto: (photo: boolean) =>
      session.setState({ photo, ...(photo ? { dialog: null, stem: null, stemPath: null } : {}) }),

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
    openDialog: (dialog: Dialog) => session.setState({ dialog }),
    closeDialog: () => session.setState({ dialog: null }),
    setTab: (tab: Panel) => session.setState({ tab }),
    setDetent: (detent: Detent) => session.setState({ detent }),
    hideHint(): void {
      if (session.getState().hint) session.setState({ hint: '' });
    },
    /** Leaves the mode that the page is in; false where it is in none. */
    leave(): boolean {
      const { throwing, gust, photo, stem } = session.getState();
      if (photo) session.setState({ photo: false });
      else if (throwing) gusts.setThrowing(false);
      else if (gust !== null) session.setState({ gust: null });
      else if (stem !== null) session.setState({ stem: null, stemPath: null });
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
    /** Pixels; null: as it is at first. */
    setGrowWidth(width: number | null): void {
      preferences.growWidth = width;
      savePreferences(preferences);
    },
    setShortcuts(on: boolean): void {
      preferences.shortcuts = on;
      savePreferences(preferences);
    },
  });
}
