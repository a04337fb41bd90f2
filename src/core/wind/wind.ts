/** One wave of the wind (Skjermo 2007, equation 11, corrected). */
export interface Wave {
  on: boolean;
  /** Heard alone: where any wave that is on is solo, only those blow. */
  solo: boolean;
  /** Displacement in metres that the crest gives to the tip edge of a stem of 3 m and stiffness 1 at right angles to it; >= 0. */
  amplitude: number;
  /** Direction towards which it travels and pushes, radians from x to y in tree space. */
  direction: number;
  /** Metres, > 0. */
  wavelength: number;
  /** Metres a second, >= 0. */
  speed: number;
  /** Exponent k of ((1 + sin)/2)^k, > 0: the larger, the shorter the gust. */
  sharpness: number;
  /** Phase in turns at time 0 and at the origin: changing `speed` at time t changes it, so that nothing jumps. */
  phase: number;
}

/** One gust: a front that crosses the meadow, once or again and again. World metres, seconds, radians. */
export interface Gust {
  /** When the front passes (x, y) for the first time, seconds. */
  start: number;
  x: number;
  y: number;
  /** Direction towards which it travels and pushes, radians from x to y. */
  direction: number;
  /** Of the front, metres a second, > 0. */
  speed: number;
  /** Peak push in metres, as a wave's amplitude; >= 0. */
  amplitude: number;
  /** Seconds from the front to the peak, and from the peak to nothing; > 0. */
  rise: number;
  fall: number;
  /** Width of the front in metres, at which it has half its force to either side; 0: without end. */
  width: number;
  /** Seconds after which it comes again, for ever; at least 5, and its rise and fall; 0: it comes once. */
  repeat: number;
}

/** How the wind grows with height; a factor of 1 at `height`. The paper's wind is the same at all heights (`none`). */
export interface HeightProfile {
  kind: 'none' | 'log' | 'power';
  /** Metres, > 0. */
  height: number;
  /** Roughness length z0 in metres, > 0; of `log`. */
  roughness: number;
  /** Exponent, 0..1; of `power`. */
  exponent: number;
}

/** What overrides a branch's own oscillation on one level of stems; null: as grown. */
export interface SpringLevel {
  /** Natural frequency in hertz, > 0. */
  frequency: number | null;
  /** Damping ratio, > 0. */
  damping: number | null;
}

/** The bend model `spring`. */
export interface SpringSettings {
  /** Factor on every natural frequency, > 0. */
  frequency: number;
  /** Damping ratio of a branch, > 0; 1 is critical. */
  damping: number;
  /** How much of its parent's acceleration shakes a branch, 0..1; 1 is a rigid rod's. */
  inertia: number;
  /** Levels 0 to 3; deeper ones use the last. Fewer entries: the rest is as grown. */
  levels: SpringLevel[];
}

/** The bend model `sway` (Weber & Penn 1995, 4.7). */
export interface SwaySettings {
  /** Wind speed and gust, in the paper's own numbers (0 to 50). */
  speed: number;
  gust: number;
  /** What the frequency goes by: `ratio`, the paper's radius/length, or `cantilever`, radius/length^2. */
  reading: 'ratio' | 'cantilever';
  /** Radians a second that a ratio of 1 gives, > 0 (for `cantilever` metres times radians a second); the paper prints 1/15. */
  rate: number;
}

/** A wind that was measured: speed and direction at equal steps; it plays around and around. */
export interface WindRecord {
  name: string;
  /** Seconds from sample to sample, > 0. */
  step: number;
  /** Metres a second, >= 0; as many as `direction`, at least 2. */
  speed: number[];
  /** Direction towards which it blows, radians from x to y in tree space. */
  direction: number[];
}

export type BendModelName = 'direct' | 'spring' | 'sway';

/** A wind document: what the wind is, without time. */
export interface Wind {
  /** Name to show. */
  name: string;
  /** One sentence: what it looks and feels like. */
  description: string;
  /** Factor on all of the wind, 0 (still) to 1. */
  strength: number;
  /** Up to eight; the paper has four. */
  waves: Wave[];
  /** Up to sixteen. */
  gusts: Gust[];
  profile: HeightProfile;
  /** Takes its mean push from every wave: trees sway about their rest, and do not lean (erratum E26). */
  zeroMean: boolean;
  /** A measured wind that blows beside the waves, or null. */
  record: WindRecord | null;
  /** Factor on the stiffness of the whole tree, > 0. */
  stiffness: number;
  /** Bend model. */
  model: BendModelName;
  spring: SpringSettings;
  sway: SwaySettings;
  /** `exact`: depth by depth without lag. `lagged`: the paper, parents from the last step. */
  pose: 'exact' | 'lagged';
  /** Exponent p of the force (equation 16 prints 1.8; 1 is dimensionally sound). */
  forceExponent: number;
  /**
   * Exponent m of the length (a third of the stem's, metres) that divides the force (equations.md 5.3): 2 is the literal paper, 1 makes
   * amplitudes displacements, 0.6 is a cantilever's and the presets'.
   */
  lengthExponent: number;
  /** The printed forms that make sense, for teaching: waves that travel upwind, no length kept, projected frames. */
  paper: boolean;
}

/** Most waves and gusts of one document. */
export const MOST_WAVES = 8;
export const MOST_GUSTS = 16;

/** Shortest time in seconds after which a gust comes again. */
export const SHORTEST_REPEAT = 5;

/** Seconds after which a gust comes again, 0 where it does not: never before the last one is over, whatever the document says. */
export const gustRepeat = ({ repeat, rise, fall }: Pick<Gust, 'repeat' | 'rise' | 'fall'>): number =>
  repeat > 0 ? Math.max(repeat, rise + fall, SHORTEST_REPEAT) : 0;

/** Most levels that `SpringSettings.levels` tells apart. */
export const SPRING_LEVELS = 4;

/** A wave as a mixer adds it. */
export const DEFAULT_WAVE: Readonly<Wave> = {
  on: true,
  solo: false,
  amplitude: 0.05,
  direction: 0,
  wavelength: 20,
  speed: 5,
  sharpness: 2,
  phase: 0,
};

/** A gust as a click throws it. */
export const DEFAULT_GUST: Readonly<Gust> = {
  start: 0,
  x: 0,
  y: 0,
  direction: 0,
  speed: 8,
  amplitude: 0.15,
  rise: 0.8,
  fall: 2.5,
  width: 30,
  repeat: 0,
};

/** No wind at all, with every setting at its default: what other winds say of themselves is what differs from it. */
export const STILL: Readonly<Wind> = {
  name: 'Still',
  description: 'No air moves: the tree as it grew.',
  strength: 1,
  waves: [],
  gusts: [],
  profile: { kind: 'none', height: 10, roughness: 0.1, exponent: 0.2 },
  zeroMean: false,
  record: null,
  stiffness: 1,
  model: 'spring',
  spring: { frequency: 1, damping: 0.12, inertia: 0.5, levels: [] },
  sway: { speed: 5, gust: 2, reading: 'ratio', rate: 67 },
  pose: 'exact',
  forceExponent: 1,
  // A cantilever whose radius grows with its length to the power 1.2, as the paper's branches do, bends by an angle that falls with
  // the length to the power 0.6 (equations.md 5.3). With 1, twigs flapped by 60 degrees before a main branch moved by 2.
  lengthExponent: 0.6,
  paper: false,
};

/** The waves that blow: those that are on, and where one of them is solo, only such. */
export function blowingWaves({ waves }: Wind): Wave[] {
  const on = waves.filter((wave) => wave.on);
  return on.some((wave) => wave.solo) ? on.filter((wave) => wave.solo) : on;
}
