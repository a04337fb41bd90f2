import { type Comparison, type OverlayChoice, OWN_WIND } from '../core/link/link.ts';
import { LINK_NUMBERS, roundTo } from '../core/link/numbers.ts';
import type { LoopedWind, loopWind } from '../core/wind/loop.ts';
import type { SpringLevel, Wind, WindRecord } from '../core/wind/wind.ts';
import { SPRING_LEVELS } from '../core/wind/wind.ts';
import { type WizardChoice, wizardWind } from '../core/wind/wizard.ts';
import { windDirection } from '../view/wind-direction.ts';
import type { Doing } from './doing.ts';
import { editedWind, putWind } from './edited-wind.ts';
import type { Side } from './session.ts';
import { turnedWind } from './turned-wind.ts';
import { windMessages } from './words/messages.ts';

const AS_GROWN: SpringLevel = { frequency: null, damping: null };

/** What a reader can do to the wind as a whole. */
export function windActions({ document, session, clock, set, say }: Doing) {
  const edited = () => editedWind(document, session);
  const put = (change: Partial<Wind>, preset?: string): void => putWind(document, session, change, preset);
  const setCompare = (compare: Comparison | null): void => {
    set({ compare: compare && { ...compare, at: roundTo(LINK_NUMBERS.at, compare.at) } });
    if (!compare) session.setState({ side: 'A' });
  };

  return {
    edited,
    setBlowing(blowing: boolean): void {
      set({ blowing });
      say(blowing ? windMessages.on : windMessages.off);
    },
    setPreset(id: string): void {
      const found = session.getState().winds.find((w) => w.id === id);
      if (!found) return;
      put(found.wind, id);
      session.setState({ gust: null });
      if (!document.getState().blowing) set({ blowing: true });
    },
    /** A whole wind that is none of those that ship. */
    setOwnWind(wind: Wind): void {
      put(wind, OWN_WIND);
      session.setState({ gust: null });
      if (!document.getState().blowing) set({ blowing: true });
    },
    /** Makes all values anew from what one says of a wind; how branches answer stays. */
    useWizard(change: Partial<WizardChoice>): void {
      const wizard = { ...session.getState().wizard, ...change };
      session.setState({ wizard, gust: null });
      const { model, spring, sway, pose } = edited().wind;
      put({ ...wizardWind(wizard), model, spring, sway, pose }, OWN_WIND);
      if (!document.getState().blowing) set({ blowing: true });
    },
    /** Nudges speeds so that the wind comes around every `seconds`; says how much that took and what stays open. `nudge` comes with who asks: nobody else loads it. */
    loopEvery(seconds: number, nudge: typeof loopWind): LoopedWind {
      const looped = nudge(edited().wind, seconds, clock.time);
      put(looped.wind);
      say(windMessages.loops(seconds, looped.open));
      return looped;
    },
    setStrength: (strength: number) => put({ strength }),
    /** Turns all waves together, so that the whole of the wind pushes in `direction` (radians); and its strength, where given. */
    turnWind(direction: number, strength?: number): void {
      const { wind } = edited();
      const by = direction - (windDirection(wind) ?? direction);
      // All directions are kept to the same tenth of a degree: they round alike, and many small turns pull no two waves apart.
      put({ ...turnedWind(wind, by), strength: strength ?? wind.strength });
    },
    setModel: (model: Wind['model']) => put({ model }),
    setSpring: (change: Partial<Wind['spring']>) => put({ spring: { ...edited().wind.spring, ...change } }),
    /** What overrides a level's own swing; null: as grown. */
    setSpringLevel(level: number, change: Partial<SpringLevel>): void {
      const { spring } = edited().wind;
      const levels = Array.from({ length: SPRING_LEVELS }, (_, i) => ({
        ...(spring.levels[i] ?? AS_GROWN),
        ...(i === level ? change : {}),
      }));
      const last = levels.findLastIndex((l) => l.frequency !== null || l.damping !== null);
      put({ spring: { ...spring, levels: levels.slice(0, last + 1) } });
    },
    setSway: (change: Partial<Wind['sway']>) => put({ sway: { ...edited().wind.sway, ...change } }),
    setProfile(change: Partial<Wind['profile']>): void {
      const profile = { ...edited().wind.profile, ...change };
      // The logarithmic law has no wind at the roughness length, and none to measure by below it.
      if (profile.roughness > profile.height / 2) profile.roughness = profile.height / 2;
      put({ profile });
    },
    setZeroMean: (zeroMean: boolean) => put({ zeroMean }),
    setStiffness: (stiffness: number) => put({ stiffness }),
    setPose: (pose: Wind['pose']) => put({ pose }),
    setPaper: (paper: boolean) => put({ paper }),
    setForceExponent: (forceExponent: number) => put({ forceExponent }),
    setLengthExponent: (lengthExponent: number) => put({ lengthExponent }),
    /** A measured wind beside the waves, or null. */
    setRecord: (record: WindRecord | null) => put({ record }),

    /** A second wind beside the first; null: one alone. */
    setCompare,
    /** Compares the wind with itself as it is now: B can then be changed. */
    startCompare(layout: Comparison['layout'] = 'split'): void {
      const { wind, preset } = document.getState();
      setCompare({ wind, preset, layout, at: 0.5 });
      session.setState({ side: 'B' });
      say(windMessages.two);
    },
    setCompareAt(at: number): void {
      const { compare } = document.getState();
      if (compare) setCompare({ ...compare, at });
    },
    /** A becomes B, and B becomes A. */
    swapCompare(): void {
      const { wind, preset, compare } = document.getState();
      if (!compare) return;
      set({ wind: compare.wind, preset: compare.preset, compare: { ...compare, wind, preset } });
      say(windMessages.swapped(compare.wind.name, wind.name));
    },
    setSide(side: Side): void {
      if (document.getState().compare) session.setState({ side, gust: null });
    },
    setProbe: (probe: number | null) => set({ probe }),
    setOverlays: (change: Partial<OverlayChoice>) => set({ overlays: { ...document.getState().overlays, ...change } }),
    setHandling(handling: boolean): void {
      if (session.getState().handling !== handling) session.setState({ handling });
    },
    setHighlight(highlight: number | null): void {
      if (session.getState().highlight !== highlight) session.setState({ highlight });
    },
  };
}
