import fc from 'fast-check';
import { DEFAULT_WAVE, type Gust, STILL, type Wave, type Wind, type WindRecord } from '../../../src/core/wind/wind.ts';

const wave = (
  amplitude: number,
  direction: number,
  wavelength: number,
  speed: number,
  sharpness: number,
  phase = 0,
): Wave => ({ ...DEFAULT_WAVE, amplitude, direction, wavelength, speed, sharpness, phase });

/** Winds of the tests of the force: fixed, whatever becomes of those that people choose from. */
export const breeze: Wind = {
  ...STILL,
  name: 'breeze',
  model: 'direct',
  waves: [
    wave(0.07, 0.26, 34, 4.6, 2.4),
    wave(0.035, -0.42, 15, 4.1, 1.8, 0.37),
    wave(0.022, 0.9, 8.5, 3.7, 1.6, 0.71),
  ],
};

export const gale: Wind = {
  ...breeze,
  name: 'gale',
  waves: [
    wave(0.22, 0.26, 60, 14.5, 2),
    wave(0.1, -0.28, 26, 12, 1.8, 0.37),
    wave(0.055, 0.59, 13, 9.4, 1.6, 0.71),
    wave(0.035, -0.73, 8, 10.3, 1.5, 0.18),
  ],
};

export const gust: Gust = {
  start: 10,
  x: 0,
  y: 0,
  direction: 0,
  speed: 8,
  amplitude: 0.2,
  rise: 1,
  fall: 3,
  width: 0,
  repeat: 0,
};

const real = (min: number, max: number) => fc.double({ min, max, noNaN: true });

const anyWave: fc.Arbitrary<Wave> = fc.record({
  on: fc.boolean(),
  solo: fc.integer({ min: 0, max: 3 }).map((n) => n === 0),
  amplitude: real(0, 0.3),
  direction: real(0, 6.28),
  wavelength: real(6, 60),
  speed: real(0, 15),
  sharpness: real(1, 4),
  phase: real(0, 1),
});

const anyGust: fc.Arbitrary<Gust> = fc.record({
  start: real(95, 110),
  x: real(-30, 30),
  y: real(-30, 30),
  direction: real(0, 6.28),
  speed: real(4, 20),
  amplitude: real(0, 0.3),
  rise: real(0.5, 2),
  fall: real(0.5, 4),
  width: fc.oneof(fc.constant(0), real(10, 60)),
  repeat: fc.oneof(fc.constant(0), real(6, 15)),
});

/** A record of up to a minute, whose speed and direction change by less than a fifth and a third of a radian from sample to sample. */
const anyRecord: fc.Arbitrary<WindRecord> = fc
  .tuple(real(1, 10), real(0, 6.28), fc.integer({ min: 2, max: 600 }))
  .map(([mean, to, count]) => ({
    name: 'record',
    step: 0.1,
    speed: Array.from({ length: count }, (_, i) => mean * (1 + 0.2 * Math.sin(i * 0.9))),
    direction: Array.from({ length: count }, (_, i) => to + 0.3 * Math.sin(i * 0.37)),
  }));

/** A wind of any parameters and parts; it changes little within a millisecond. */
export const anyWind: fc.Arbitrary<Wind> = fc
  .record({
    strength: real(0, 1),
    waves: fc.array(anyWave, { maxLength: 8 }),
    gusts: fc.array(anyGust, { maxLength: 6 }),
    profile: fc.record({
      kind: fc.constantFrom('none' as const, 'log' as const, 'power' as const),
      height: real(2, 30),
      roughness: real(0.01, 1),
      exponent: real(0, 0.5),
    }),
    zeroMean: fc.boolean(),
    record: fc.option(anyRecord),
    stiffness: real(0.3, 4),
    model: fc.constantFrom('direct' as const, 'spring' as const, 'sway' as const),
    sway: fc.record({
      speed: real(0, 50),
      gust: real(0, 50),
      reading: fc.constantFrom('ratio' as const, 'cantilever' as const),
      rate: fc.constantFrom(1 / 15, 67),
    }),
    forceExponent: real(1, 2),
    lengthExponent: real(0, 2),
  })
  .map((rest) => ({ ...STILL, name: 'any', ...rest }));
