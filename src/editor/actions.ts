import {
  type CameraPose,
  type LinkDocument,
  roundCamera,
  roundTime,
  type Theme,
  type ViewMode,
} from '../core/link/link.ts';
import { LINK_NUMBERS, roundTo, type WaveNumber } from '../core/link/numbers.ts';
import { roundWind, withNumber } from '../core/link/waves.ts';
import { presets } from '../core/wind/presets.ts';
import { rebaseWave } from '../core/wind/rebase.ts';
import type { Wave, Wind } from '../core/wind/wind.ts';
import type { DocumentStore } from './document-store.ts';
import { type Preferences, savePreferences } from './preferences.ts';
import type { Detent, Notice, Panel, SessionStore } from './session.ts';

/** What the actions need of the clock. */
export interface Time {
  readonly time: number;
  play(): void;
  pause(): void;
  step(steps: number): void;
  seek(seconds: number): void;
  rate: number;
}

/** What needs the rest of the page. */
export interface Services {
  /** Copies the link of the document. */
  share(): Promise<void>;
  cancelGrowing(): void;
}

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
  const setWind = (change: Partial<Wind>): void => set({ wind: roundWind({ ...document.getState().wind, ...change }) });
  const setWave = (index: number, change: (wave: Wave) => Wave): void =>
    setWind({ waves: document.getState().wind.waves.map((wave, i) => (i === index ? change(wave) : wave)) });
  const say = (spoken: string): void => session.setState({ spoken });

  return {
    setSpecies: (species: string) => set({ species, ownSpecies: null }),
    openSpecies: (text: string) => set({ ownSpecies: text }),
    setSeed: (seed: number) => set({ seed: roundTo(LINK_NUMBERS.seed, seed) }),
    rollSeed: () => set({ seed: crypto.getRandomValues(new Uint32Array(1))[0]! % 10_000 }),
    setLevels: (levelsShown: number) => set({ levelsShown }),
    setShowLeaves: (showLeaves: boolean) => set({ showLeaves }),
    setView: (view: ViewMode) => set({ view }),

    setTheme(theme: Theme): void {
      preferences.theme = theme;
      savePreferences(preferences);
      set({ theme });
    },

    setBlowing(blowing: boolean): void {
      set({ blowing });
      say(blowing ? 'Wind on' : 'Wind off');
    },
    setPreset: (preset: string) => set({ preset, wind: roundWind(presets[preset]!), blowing: true }),
    setStrength: (strength: number) => setWind({ strength }),
    setPose: (pose: Wind['pose']) => setWind({ pose }),
    setPaper: (paper: boolean) => setWind({ paper }),
    setForceExponent: (forceExponent: number) => setWind({ forceExponent }),
    setLengthExponent: (lengthExponent: number) => setWind({ lengthExponent }),
    setWaveOn: (index: number, on: boolean) => setWave(index, (wave) => ({ ...wave, on })),
    setWaveNumber: (index: number, number: WaveNumber, shown: number) =>
      setWave(index, (wave) => {
        const next = withNumber(wave, number, shown);
        return number.key === 'phase' ? next : rebaseWave(wave, next, clock.time);
      }),

    play(): void {
      clock.play();
      set({ paused: false });
      say('Playing');
    },
    pause(): void {
      clock.pause();
      set({ paused: true, time: roundTime(clock.time) });
      say('Paused');
    },
    toggle(): void {
      if (document.getState().paused) this.play();
      else this.pause();
    },
    step(steps: number): void {
      if (!document.getState().paused) this.pause();
      clock.step(steps);
      set({ time: roundTime(clock.time) });
    },
    seek(seconds: number): void {
      clock.seek(roundTime(seconds));
      set({ time: roundTime(clock.time) });
    },
    setRate(rate: number): void {
      clock.rate = roundTo(LINK_NUMBERS.rate, rate);
      set({ rate: clock.rate });
    },
    setCamera: (camera: CameraPose | null) => set({ camera: camera && roundCamera(camera) }),

    notify(kind: Notice['kind'], title: string, lines: readonly string[] = []): void {
      const notice = { id: ++notices, kind, title, lines };
      // A message about the same thing takes the place of the last one.
      const others = session.getState().notices.filter((n) => n.title !== title);
      session.setState({ notices: [...others, notice].slice(-MOST_NOTICES) });
    },
    dismiss(id: number): void {
      session.setState({ notices: session.getState().notices.filter((n) => n.id !== id) });
    },
    /** Takes back a message whose cause is gone. */
    retract(title: string): void {
      session.setState({ notices: session.getState().notices.filter((n) => n.title !== title) });
    },
    say,
    time: () => clock.time,
    share: services.share,
    cancelGrowing: services.cancelGrowing,
    setHelp: (help: boolean) => session.setState({ help }),
    setTab: (tab: Panel) => session.setState({ tab }),
    setDetent: (detent: Detent) => session.setState({ detent }),
    hideHint(): void {
      if (session.getState().hint) session.setState({ hint: '' });
    },
    setFold(name: string, open: boolean): void {
      preferences.folds[name] = open;
      savePreferences(preferences);
    },
    setShortcuts(on: boolean): void {
      preferences.shortcuts = on;
      savePreferences(preferences);
    },
  };
}
