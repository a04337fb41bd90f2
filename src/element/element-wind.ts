import { meanPush } from '../core/wind/force.ts';
import { DRAG_EXPONENT, forceOfSpeed, speedOfForce } from '../core/wind/speed.ts';
import { blowingWaves, type Gust, MOST_GUSTS, type Wind } from '../core/wind/wind.ts';
import { wizardWind } from '../core/wind/wizard.ts';

/** What the attributes say of a wind beside its name; null: as the wind has it. */
export interface WindWishes {
  /** Mean speed, metres a second. */
  readonly windSpeed: number | null;
  /** Towards which it blows, degrees: 0 to the right of the first view, 90 away from the viewer. */
  readonly windDirection: number | null;
  /** 0..1. */
  readonly gust: number | null;
  readonly model: Wind['model'] | null;
}

/** Mean push of a wind, metres of force: its size, and the direction in radians. */
function meanOf(wind: Wind): { readonly force: number; readonly direction: number } {
  let x = 0;
  let y = 0;
  const push = (size: number, direction: number): void => {
    x += size * Math.cos(direction);
    y += size * Math.sin(direction);
  };
  for (const { amplitude, sharpness, direction } of blowingWaves(wind))
    push(wind.strength * amplitude * meanPush(sharpness), direction);
  const { record } = wind;
  record?.speed.forEach((speed, i) => {
    push((wind.strength * forceOfSpeed(speed)) / record.speed.length, record.direction[i] ?? 0);
  });
  return { force: Math.hypot(x, y), direction: Math.atan2(y, x) };
}

/** Below this there is nothing to scale, metres of force: a wind of 0.05 m/s. */
const NOTHING = 3e-4;

/** Mean speed of the air that a gust comes out of where none blows, metres a second. */
const QUIET = 3;

/** A front that comes again: as long before the next as a breath of wind lasts, and its peak in means. */
const GUST: Omit<Gust, 'amplitude' | 'direction'> = {
  start: 3,
  x: 0,
  y: 0,
  speed: 9,
  rise: 1,
  fall: 3,
  width: 0,
  repeat: 9,
};
const PEAK = 2.4;

/** A wind as the attributes want it: scaled to a mean speed, turned to a direction, with gusts, by another model. */
export function elementWind(wind: Wind, { windSpeed, windDirection, gust, model }: WindWishes): Wind {
  let out = wind;
  if (windSpeed !== null) out = atSpeed(out, windSpeed);
  if (windDirection !== null) out = turned(out, (windDirection * Math.PI) / 180 - meanOf(out).direction);
  if (gust !== null) out = withGust(out, gust);
  return model === null ? out : { ...out, model };
}

/** All of it as much stronger as drag makes it, and its waves as much faster. */
function atSpeed(wind: Wind, speed: number): Wind {
  const { force } = meanOf(wind);
  if (force < NOTHING) {
    const { waves } = wizardWind({
      beaufort: (Math.min(speed, 28) / 0.836) ** (2 / 3),
      steadiness: 0.3,
      turbulence: 0.5,
      stiffness: wind.stiffness,
      direction: 0,
      seed: 1,
    });
    return speed > 0 ? { ...wind, waves, strength: 1 } : wind;
  }
  const ratio = speed / speedOfForce(force);
  const push = ratio ** DRAG_EXPONENT;
  const { record } = wind;
  return {
    ...wind,
    waves: wind.waves.map((wave) => ({ ...wave, amplitude: wave.amplitude * push, speed: wave.speed * ratio })),
    gusts: wind.gusts.map((each) => ({
      ...each,
      amplitude: each.amplitude * push,
      speed: Math.min(100, Math.max(0.1, each.speed * ratio)),
    })),
    record: record && { ...record, speed: record.speed.map((each) => each * ratio) },
  };
}

function turned(wind: Wind, angle: number): Wind {
  const [cos, sin] = [Math.cos(angle), Math.sin(angle)];
  const { record } = wind;
  return {
    ...wind,
    waves: wind.waves.map((wave) => ({ ...wave, direction: wave.direction + angle })),
    gusts: wind.gusts.map((each) => ({
      ...each,
      direction: each.direction + angle,
      x: cos * each.x - sin * each.y,
      y: sin * each.x + cos * each.y,
    })),
    record: record && { ...record, direction: record.direction.map((each) => each + angle) },
  };
}

/** Its own gusts give way to a front that comes again: 0 is none. */
function withGust(wind: Wind, gust: number): Wind {
  if (gust <= 0) return { ...wind, gusts: [] };
  const { force, direction } = meanOf(wind);
  const mean = force < NOTHING ? forceOfSpeed(QUIET) : force;
  const front: Gust = { ...GUST, direction, amplitude: (PEAK * gust * mean) / (wind.strength || 1) };
  return { ...wind, gusts: [front].slice(0, MOST_GUSTS) };
}
