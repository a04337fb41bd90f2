import { forceOfSpeed, speedOfForce } from '../wind/speed.ts';
import type { Wind } from '../wind/wind.ts';

const PHASES = 48;

/** Mean of ((1 + sin)/2)^k over a turn. */
function meanOfWave(k: number): number {
  let sum = 0;
  for (let i = 0; i < PHASES; i++) sum += (0.5 + 0.5 * Math.sin((2 * Math.PI * (i + 0.5)) / PHASES)) ** k;
  return sum / PHASES;
}

/** The speed in metres a second that stands for a whole wind: its mean push where it has one, else the size of what goes to and fro. */
export function windSpeedOf({ strength, waves, gusts, record, model, sway }: Wind): number {
  if (model === 'sway') return strength * sway.speed;
  const pushes = [0, 0, 0];
  for (const { on, amplitude, direction, sharpness } of waves) {
    if (!on) continue;
    const push = amplitude * meanOfWave(sharpness);
    pushes[0]! += push * Math.cos(direction);
    pushes[1]! += push * Math.sin(direction);
    pushes[2]! += push * push;
  }
  const steady = Math.max(Math.hypot(pushes[0]!, pushes[1]!), Math.sqrt(pushes[2]!));
  const gusty = gusts.reduce((most, { amplitude }) => Math.max(most, amplitude), 0) / 4;
  const measured = record ? record.speed.reduce((sum, speed) => sum + speed, 0) / record.speed.length : 0;
  return Math.max(speedOfForce(strength * Math.max(steady, gusty)), strength * measured);
}

/**
 * A wind as it blows over a forest: brought to `speed` metres a second (null: as it is), and turned by `turn` degrees about the middle.
 * A still wind stays still.
 */
export function forestWind(wind: Wind, speed: number | null, turn: number): Wind {
  const own = windSpeedOf(wind);
  const angle = (turn * Math.PI) / 180;
  if ((speed === null || own === 0) && angle === 0) return wind;
  const times = speed === null || own === 0 ? 1 : speed / own;
  const louder = speed === null || own === 0 ? 1 : forceOfSpeed(speed) / forceOfSpeed(own);
  const [c, s] = [Math.cos(angle), Math.sin(angle)];
  return {
    ...wind,
    waves: wind.waves.map((wave) => ({
      ...wave,
      amplitude: wave.amplitude * louder,
      direction: wave.direction + angle,
    })),
    gusts: wind.gusts.map((gust) => ({
      ...gust,
      amplitude: gust.amplitude * louder,
      direction: gust.direction + angle,
      x: c * gust.x - s * gust.y,
      y: s * gust.x + c * gust.y,
    })),
    record: wind.record && {
      ...wind.record,
      speed: wind.record.speed.map((each) => each * times),
      direction: wind.record.direction.map((each) => each + angle),
    },
    sway: { ...wind.sway, speed: wind.sway.speed * times, gust: wind.sway.gust * times },
  };
}
