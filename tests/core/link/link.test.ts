import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import {
  ALL_LEVELS,
  decodeLink,
  encodeLink,
  type LinkDocument,
  roundDocument,
  THEMES,
  VIEW_MODES,
} from '../../../src/core/link/link.ts';
import type { Wave, Wind } from '../../../src/core/wind/wind.ts';

const wave = (amplitude: number): Wave => ({
  on: true,
  amplitude,
  direction: 0.3,
  wavelength: 12,
  speed: 3,
  sharpness: 2,
  phase: 0.25,
});
const wind = (name: string): Wind => ({
  name,
  strength: 1,
  waves: [0.4, 0.3, 0.2, 0.1].map(wave),
  model: 'direct',
  pose: 'exact',
  forceExponent: 1,
  lengthExponent: 1,
  paper: false,
});
const winds = { breeze: wind('Breeze'), gale: wind('Gale') };
const defaults: LinkDocument = roundDocument({
  species: 'quaking-aspen',
  ownSpecies: null,
  seed: 1,
  time: 0,
  paused: false,
  rate: 1,
  camera: null,
  levelsShown: ALL_LEVELS,
  showLeaves: true,
  view: 'shaded',
  theme: 'auto',
  blowing: true,
  preset: 'breeze',
  wind: winds.breeze,
});
const options = { defaults, species: ['quaking-aspen', 'black-tupelo'], winds };

const number = (min: number, max: number) => fc.double({ min, max, noNaN: true });
const anyWave = fc.record({
  on: fc.boolean(),
  amplitude: number(0, 10),
  direction: number(-7, 7),
  wavelength: number(0.1, 500),
  speed: number(0, 100),
  sharpness: number(0.1, 40),
  phase: number(-2, 2),
});
const anyDocument: fc.Arbitrary<LinkDocument> = fc.record({
  species: fc.constantFrom('quaking-aspen', 'black-tupelo'),
  ownSpecies: fc.constant(null),
  seed: fc.nat(4294967295),
  time: number(0, 1e6),
  paused: fc.boolean(),
  rate: number(0.1, 2),
  camera: fc.option(
    fc.record({
      azimuth: number(-400, 400),
      elevation: number(-90, 90),
      distance: number(0.01, 1e4),
      target: fc.tuple(number(-1e4, 1e4), number(-1e4, 1e4), number(-1e4, 1e4)),
    }),
  ),
  levelsShown: fc.integer({ min: 1, max: 9 }),
  showLeaves: fc.boolean(),
  view: fc.constantFrom(...VIEW_MODES),
  theme: fc.constantFrom(...THEMES),
  blowing: fc.boolean(),
  preset: fc.constantFrom('breeze', 'gale'),
  wind: fc
    .record({
      strength: number(0, 1),
      waves: fc.tuple(anyWave, anyWave, anyWave, anyWave),
      p: number(0.1, 4),
      m: number(0, 4),
    })
    .chain(({ strength, waves, p, m }) =>
      fc.record({ pose: fc.constantFrom('exact' as const, 'lagged' as const), paper: fc.boolean() }).map((rest) => ({
        ...winds.breeze,
        ...rest,
        strength,
        waves: [...waves],
        forceExponent: p,
        lengthExponent: m,
      })),
    ),
});

describe('link', () => {
  it('gives back the document, rounded, and rounding again changes nothing', () => {
    fc.assert(
      fc.property(anyDocument, (document) => {
        const rounded = roundDocument(document);
        const back = decodeLink(encodeLink(document), options);
        expect(back.faults).toEqual([]);
        // The name of the wind is the preset's: the link holds its id.
        expect(back.document).toEqual({
          ...rounded,
          wind: { ...rounded.wind, name: winds[rounded.preset as 'gale'].name },
        });
        expect(roundDocument(rounded)).toEqual(rounded);
        expect(encodeLink(back.document)).toBe(encodeLink(document));
      }),
    );
  });

  it('reads like a sentence', () => {
    const link = encodeLink({ ...defaults, seed: 7, time: 12.5, paused: true });
    expect(link).toBe(
      's=quaking-aspen&seed=7&t=12.5&paused=1&wind=breeze&strength=1&w1=0.4,17.2,12,3,2,0.25&w2=0.3,17.2,12,3,2,0.25' +
        '&w3=0.2,17.2,12,3,2,0.25&w4=0.1,17.2,12,3,2,0.25&p=1&m=1',
    );
  });

  it('carries a species file of the reader, whatever letters it has', () => {
    const ownSpecies = '{"name":"Łąka & <b>träd</b> 🌳"}';
    const { document, faults } = decodeLink(encodeLink({ ...defaults, ownSpecies }), options);
    expect(faults).toEqual([]);
    expect(document.ownSpecies).toBe(ownSpecies);
  });

  it('takes its defaults from an empty link', () => {
    expect(decodeLink('', options)).toEqual({ document: defaults, faults: [] });
    expect(decodeLink('#', options)).toEqual({ document: defaults, faults: [] });
  });

  it.each([
    ['s=../../etc', 's', '../../etc'],
    ['seed=-1', 'seed', '-1'],
    ['seed=1.5', 'seed', '1.5'],
    ['seed=4294967296', 'seed', '4294967296'],
    ['seed=', 'seed', ''],
    ['t=NaN', 't', 'NaN'],
    ['t=1e3', 't', '1e3'],
    ['t=Infinity', 't', 'Infinity'],
    ['paused=yes', 'paused', 'yes'],
    ['rate=0', 'rate', '0'],
    ['cam=1,2,3', 'cam', '1,2,3'],
    ['cam=1,2,x,0,0,0', 'cam', '1,2,x,0,0,0'],
    ['levels=0', 'levels', '0'],
    ['view=<b>', 'view', '<b>'],
    ['wind=hurricane', 'wind', 'hurricane'],
    ['wind=__proto__', 'wind', '__proto__'],
    ['strength=2', 'strength', '2'],
    ['w1=', 'w1', ''],
    ['w2=0.3,17.2,12,-3,2,0.25', 'w2 speed', '-3'],
    ['w3=0.2,17.2,0,3,2,0.25,off', 'w3 wavelength', '0'],
    ['own=%%%', 'own', '%%%'],
    ['own=gICA', 'own', 'gICA'],
    ['tiger=1', 'tiger', '1'],
  ])('%s: says what is wrong and applies the rest', (bad, key, found) => {
    const { document, faults } = decodeLink(`${bad}&leaves=0`, options);
    expect(faults.map((f) => [f.key, f.found])).toEqual([[key, found]]);
    expect(faults[0]!.allowed).not.toBe('');
    const on = !bad.endsWith('off');
    const waves = defaults.wind.waves.map((w, i) => (i === 2 ? { ...w, on } : w));
    expect(document).toEqual({ ...defaults, showLeaves: false, wind: { ...defaults.wind, waves } });
  });

  it('never throws', () => {
    fc.assert(
      fc.property(
        fc.string(),
        fc.constantFrom('', 's=', 'seed=', 'cam=', 'w1=', 'own=', 'own=e', 't=1'),
        (text, start) => {
          expect(encodeLink(decodeLink(start + text, options).document)).toBeTypeOf('string');
        },
      ),
    );
  });
});
