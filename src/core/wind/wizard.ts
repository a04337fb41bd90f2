import { combine, hashUnit } from '../math/hash.ts';
import { meanPush } from './force.ts';
import { BEAUFORT, forceOfSpeed, speedOfBeaufort } from './speed.ts';
import { STILL, type Wave, type Wind } from './wind.ts';

/** What one says of a wind without knowing its waves. */
export interface WizardChoice {
  /** Beaufort number, 0..11, fractions allowed. */
  readonly beaufort: number;
  /** 0: gusts and lulls; 1: the same hour after hour. */
  readonly steadiness: number;
  /** 0: smooth air; 1: as behind houses and woods, small eddies from either side. */
  readonly turbulence: number;
  /** Of the tree, as `Wind.stiffness`. */
  readonly stiffness: number;
  /** Towards which it blows, radians from x to y. */
  readonly direction: number;
  /** Unsigned 32-bit integer: another one gives other phases and slightly other waves, no other character. */
  readonly seed: number;
}

/** One of the waves that fluctuate. Lengths as parts of the longest one, directions in degrees off the mean one. */
interface Part {
  readonly length: number;
  readonly off: number;
  /** Speed as a part of the mean wind's: eddies near the ground are carried more slowly. */
  readonly speed: number;
}

/**
 * Gusts, then eddies. No two lengths are in a ratio of small whole numbers, so that the pattern does not come back in sight; the powers of
 * a golden section are as far from that as numbers can be.
 */
const GUSTS: readonly Part[] = [
  { length: 1, off: 5, speed: 1 },
  { length: 0.618 ** 2, off: -9, speed: 0.92 },
];
const EDDIES: readonly Part[] = [
  { length: 0.618 ** 3, off: 34, speed: 0.85 },
  { length: 0.618 ** 4, off: -46, speed: 0.9 },
  { length: 0.618 ** 5, off: 58, speed: 0.8 },
];

/** Deviation of the gusts, and of the eddies, as parts of the mean: together 0.39, as in a town on a gusty day. */
const MOST_GUSTING = 0.32;
const MOST_EDDYING = 0.22;

/** A wave that stands still and is nearly flat is a mean wind: on its crest at the origin, within 5 % for 100 m around. */
const STANDING = { wavelength: 500, speed: 0, sharpness: 0.1, phase: 0.75 } as const;

const radians = (degrees: number): number => (degrees * Math.PI) / 180;

/** Deviation of ((1 + sin)/2)^k about its mean (equations.md 5.2). */
const deviation = (k: number): number => Math.sqrt(meanPush(2 * k) - meanPush(k) ** 2);

/**
 * A wind of six waves: one that stands still and gives what is missing to the mean, two gusts, three eddies. Its mean at the tree is that of
 * the Beaufort number (`speedOfBeaufort`), exactly, and towards `direction`; its deviation is the same part of it at every number, so that
 * all grows with Beaufort. Amplitudes follow the power -5/3 of turbulence: a third of the exponent of their length (Kolmogorov 1941).
 */
export function wizardWind({ beaufort, steadiness, turbulence, stiffness, direction, seed }: WizardChoice): Wind {
  const speed = speedOfBeaufort(beaufort);
  const force = forceOfSpeed(speed);
  const unrest = 1 - steadiness;
  const longest = 18 + 2.2 * speed;
  const gust = { deviation: MOST_GUSTING * unrest * force, sharpness: 1.4 + unrest };
  // Even a steady wind trembles a little where the air is rough.
  const eddy = { deviation: MOST_EDDYING * turbulence * (0.2 + 0.8 * unrest) * force, sharpness: 1.6 };

  const wavesOf = (parts: readonly Part[], kind: typeof gust, wider: number, first: number): Wave[] => {
    const shares = parts.map(({ length }) => length ** (1 / 3));
    const all = Math.hypot(...shares);
    return parts.map((part, i) => {
      const draw = (name: number): number => hashUnit(combine(combine(seed, first + i), name));
      return {
        on: true,
        solo: false,
        amplitude: ((shares[i] / all) * kind.deviation) / deviation(kind.sharpness),
        direction: direction + radians(part.off * wider),
        wavelength: longest * part.length * (0.96 + 0.08 * draw(0)),
        // Light airs crawl; slower still would look like a stopped clock.
        speed: Math.max(1.2, speed) * part.speed * (0.97 + 0.06 * draw(1)),
        sharpness: kind.sharpness,
        phase: draw(2),
      };
    });
  };
  const fluctuating = [...wavesOf(GUSTS, gust, 1, 0), ...wavesOf(EDDIES, eddy, 0.5 + 0.5 * turbulence, GUSTS.length)];
  const { number, seen } = BEAUFORT[Math.round(beaufort)];
  return {
    ...STILL,
    name: `Beaufort ${number}`,
    description: seen,
    stiffness,
    waves: [meanWave(force, direction, fluctuating), ...fluctuating],
  };
}

/** What the fluctuating waves leave of the mean wind; they push to one side only, and so have a mean of their own (erratum E26). */
function meanWave(force: number, direction: number, fluctuating: readonly Wave[]): Wave {
  let x = force * Math.cos(direction);
  let y = force * Math.sin(direction);
  for (const wave of fluctuating) {
    const mean = wave.amplitude * meanPush(wave.sharpness);
    x -= mean * Math.cos(wave.direction);
    y -= mean * Math.sin(wave.direction);
  }
  return {
    on: true,
    solo: false,
    amplitude: Math.hypot(x, y),
    direction: force > 0 ? Math.atan2(y, x) : direction,
    ...STANDING,
  };
}
