/** Metres of force that a wind of 1 m/s is: so that a gentle breeze of 4.4 m/s pushes a stem of 3 m and stiffness 1 aside by 0.1 m. */
const FORCE_AT_1 = 0.0146;

/**
 * Exponent of the speed: 2 as drag has it, less 0.7, Vogel's exponent of broad-leaved trees, whose leaves and twigs fold in the wind.
 * Source: Vogel 1989, "Drag and reconfiguration of broad leaves in high winds", Journal of Experimental Botany 40.
 */
export const DRAG_EXPONENT = 1.3;

/** The force in metres of amplitude of a wind of `speed` metres a second, >= 0: 0.0146 speed^1.3. */
export const forceOfSpeed = (speed: number): number => FORCE_AT_1 * speed ** DRAG_EXPONENT;

/** The speed in metres a second of a wind whose force is `force` metres of amplitude, >= 0. */
export const speedOfForce = (force: number): number => (force / FORCE_AT_1) ** (1 / DRAG_EXPONENT);

/**
 * Metres a second for each metre of a force of size `force`, 0 where that is 0: a component of a force times this is that component of
 * the wind, whose size, not its parts, is raised to a power.
 */
export const speedPerForce = (force: number): number => (force > 0 ? speedOfForce(force) / force : 0);

/** One force of the Beaufort scale. */
export interface BeaufortForce {
  /** 0 to 12. */
  number: number;
  name: string;
  /** Mean speed at 10 m over open ground in metres a second: from `from` up to, not with, `to` (Infinity for 12). */
  from: number;
  to: number;
  /** What is seen on land. */
  seen: string;
}

/** Upper ends of the forces 0 to 11, metres a second: the limits of the World Meteorological Organization's code table 1100. */
const LIMITS = [0.3, 1.6, 3.4, 5.5, 8, 10.8, 13.9, 17.2, 20.8, 24.5, 28.5, 32.7];

const WORDS: readonly (readonly [name: string, seen: string])[] = [
  ['Calm', 'Smoke rises straight up; no leaf moves.'],
  ['Light air', 'Smoke drifts; single leaves stir.'],
  ['Light breeze', 'Leaves rustle; wind is felt on the face.'],
  ['Gentle breeze', 'Leaves and small twigs move all the time.'],
  ['Moderate breeze', 'Small branches move; dust and paper fly up.'],
  ['Fresh breeze', 'Small trees in leaf begin to sway.'],
  ['Strong breeze', 'Large branches move; wires whistle.'],
  ['Near gale', 'Whole trees move; walking is hard.'],
  ['Gale', 'Twigs break off; cars are pushed aside.'],
  ['Strong gale', 'Branches break; tiles come off roofs.'],
  ['Storm', 'Trees are uprooted; houses are damaged.'],
  ['Violent storm', 'Damage far and wide.'],
  ['Hurricane', 'Devastation.'],
];

/** The Beaufort scale, force 0 to 12. */
export const BEAUFORT: readonly BeaufortForce[] = WORDS.map(([name, seen], number) => ({
  number,
  name,
  seen,
  from: LIMITS[number - 1] ?? 0,
  to: LIMITS[number] ?? Number.POSITIVE_INFINITY,
}));

/** The Beaufort force of a mean wind of `speed` metres a second (below 0: 0). */
export function beaufortOf(speed: number): BeaufortForce {
  const number = LIMITS.findIndex((limit) => speed < limit);
  return BEAUFORT[number < 0 ? BEAUFORT.length - 1 : number] as BeaufortForce;
}

/**
 * The mean speed in metres a second of a Beaufort number, fractions allowed: 0.836 B^1.5, the scale's own law; within the range
 * of every whole number from 0 to 12.
 */
export const speedOfBeaufort = (number: number): number => 0.836 * Math.max(0, number) ** 1.5;
