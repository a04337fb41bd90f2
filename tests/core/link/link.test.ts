import fc from 'fast-check';
import { deflateSync } from 'fflate';
import { describe, expect, it } from 'vitest';
import {
  ALL_LEVELS,
  decodeLink,
  encodeLink,
  isLinkKey,
  LAYOUTS,
  type LinkDocument,
  OVERLAYS,
  OWN_WIND,
  roundDocument,
  STAGES,
  THEMES,
  VIEW_MODES,
} from '../../../src/core/link/link.ts';
import { bytesToBase64 } from '../../../src/core/link/text.ts';
import { PLACES, type SpeciesEdits } from '../../../src/core/species/edits.ts';
import { SEASONS } from '../../../src/core/species/season.ts';
import { type Gust, STILL, type Wave, type Wind, type WindRecord } from '../../../src/core/wind/wind.ts';
import { anyEdits } from '../species/any-edits.ts';

const wave = (amplitude: number): Wave => ({
  on: true,
  solo: false,
  amplitude,
  direction: 0.3,
  wavelength: 12,
  speed: 3,
  sharpness: 2,
  phase: 0.25,
});
const record: WindRecord = { name: 'A mast', step: 1, speed: [1, 2], direction: [0, 0.1] };
const gust: Gust = {
  start: 3,
  x: 0,
  y: 1,
  direction: 0,
  speed: 8,
  amplitude: 0.15,
  rise: 0.8,
  fall: 2.5,
  width: 30,
  repeat: 0,
};
const wind = (name: string, more: Partial<Wind> = {}): Wind => ({
  ...STILL,
  name,
  waves: [0.4, 0.3, 0.2, 0.1].map(wave),
  lengthExponent: 1,
  ...more,
});
const winds = {
  breeze: wind('Breeze'),
  gale: wind('Gale', { waves: [0.5, 0.4, 0.3, 0.2, 0.1, 0.05].map(wave), gusts: [gust], zeroMean: true }),
  recorded: wind('Recorded', { waves: [], record }),
};
const defaults: LinkDocument = roundDocument({
  species: 'quaking-aspen',
  ownSpecies: null,
  edits: {},
  treeName: null,
  seed: 1,
  time: 0,
  paused: false,
  rate: 1,
  camera: null,
  levelsShown: ALL_LEVELS,
  showLeaves: true,
  view: 'shaded',
  theme: 'auto',
  season: 'summer',
  stage: 'meadow',
  hour: null,
  overlays: OVERLAYS,
  probe: null,
  blowing: true,
  preset: 'breeze',
  wind: winds.breeze,
  compare: null,
});
const options = { defaults, species: ['quaking-aspen', 'black-tupelo'], winds };

const number = (min: number, max: number) => fc.double({ min, max, noNaN: true });
const anyWave: fc.Arbitrary<Wave> = fc.record({
  on: fc.boolean(),
  solo: fc.boolean(),
  amplitude: number(0, 10),
  direction: number(-7, 7),
  wavelength: number(0.1, 500),
  speed: number(0, 100),
  sharpness: number(0.1, 40),
  phase: number(-2, 2),
});
const anyGust: fc.Arbitrary<Gust> = fc.record({
  start: number(-3600, 1e6),
  x: number(-1e4, 1e4),
  y: number(-1e4, 1e4),
  direction: number(-7, 7),
  speed: number(0.1, 100),
  amplitude: number(0, 10),
  rise: number(0.01, 600),
  fall: number(0.01, 600),
  width: number(0, 1e4),
  repeat: fc.oneof(fc.constant(0), number(0, 3600)),
});
const orNull = (value: fc.Arbitrary<number>) => fc.option(value, { nil: null });
const anyWind: fc.Arbitrary<Wind> = fc.record({
  name: fc.string({ unit: 'binary', maxLength: 100 }),
  description: fc.string({ unit: 'grapheme', maxLength: 240 }),
  strength: number(0, 1),
  waves: fc.array(anyWave, { maxLength: 8 }),
  gusts: fc.array(anyGust, { maxLength: 16 }),
  profile: fc.record({
    kind: fc.constantFrom('none', 'log', 'power'),
    height: number(0.1, 1000),
    roughness: number(1e-4, 10),
    exponent: number(0, 1),
  }),
  zeroMean: fc.boolean(),
  record: fc.constantFrom(null, record),
  stiffness: number(0.05, 20),
  model: fc.constantFrom('direct', 'spring', 'sway'),
  spring: fc.record({
    frequency: number(0.05, 20),
    damping: number(0.005, 10),
    inertia: number(0, 1),
    levels: fc.array(fc.record({ frequency: orNull(number(0.05, 20)), damping: orNull(number(0.005, 10)) }), {
      maxLength: 4,
    }),
  }),
  sway: fc.record({
    speed: number(0, 100),
    gust: number(0, 100),
    reading: fc.constantFrom('ratio', 'cantilever'),
    rate: number(0.001, 1e4),
  }),
  pose: fc.constantFrom('exact', 'lagged'),
  forceExponent: number(0.1, 4),
  lengthExponent: number(0, 4),
  paper: fc.boolean(),
});
/** A wind under the id of one that ships has its name and description; one of the reader's own brings them along. */
const named = (preset: string, of: Wind): { preset: string; wind: Wind } => {
  const base = Object.entries(winds).find(([id]) => id === preset)?.[1];
  return { preset, wind: base ? { ...of, name: base.name, description: base.description } : of };
};
const anyNamed = fc
  .tuple(fc.constantFrom('breeze', 'gale', 'recorded', OWN_WIND), anyWind)
  .map(([preset, of]) => named(preset, of));
const anyDocument: fc.Arbitrary<LinkDocument> = fc
  .record({
    species: fc.constantFrom('quaking-aspen', 'black-tupelo'),
    ownSpecies: fc.constant(null),
    edits: anyEdits,
    treeName: fc.option(fc.string({ unit: 'binary', maxLength: 100 }), { nil: null }),
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
    season: fc.constantFrom(...SEASONS),
    stage: fc.constantFrom(...STAGES),
    hour: orNull(number(0, 24)),
    overlays: fc.record({ arrows: fc.boolean(), fronts: fc.boolean(), handle: fc.boolean() }),
    probe: orNull(fc.nat(4294967295)),
    blowing: fc.boolean(),
    first: anyNamed,
    compare: fc.option(
      fc
        .record({ layout: fc.constantFrom(...LAYOUTS), at: number(0, 1), other: anyNamed })
        .map(({ other, ...rest }) => ({ ...rest, ...other })),
    ),
  })
  .map(({ first, ...rest }) => ({ ...rest, ...first }));

describe('link', () => {
  it('gives back the document, rounded, and rounding again changes nothing', () => {
    fc.assert(
      fc.property(anyDocument, (document) => {
        const rounded = roundDocument(document);
        const back = decodeLink(encodeLink(document), options);
        expect(back.faults).toEqual([]);
        expect(back.document).toEqual(rounded);
        expect(roundDocument(rounded)).toEqual(rounded);
        expect(encodeLink(back.document)).toBe(encodeLink(document));
      }),
    );
  });

  it('reads like a sentence', () => {
    const link = encodeLink({ ...defaults, seed: 7, time: 12.5, paused: true });
    expect(link).toBe(
      's=quaking-aspen&seed=7&t=12.5&paused=1&wind=breeze&strength=1&w1=0.4,17.2,12,3,2,0.25&w2=0.3,17.2,12,3,2,0.25' +
        '&w3=0.2,17.2,12,3,2,0.25&w4=0.1,17.2,12,3,2,0.25&model=spring&p=1&m=1',
    );
  });

  it('says what was changed of the species, and what the tree is called', () => {
    const edits: SpeciesEdits = {
      'foliage.outline': null,
      'levels.1.downAngle': 0.1 + 0.2 + 44.7,
      'wind.stiffness': [2, 0.8],
      'bark.colour': '#ABC123',
      'bark.kind': 'smooth',
      'switches.paper': true,
    };
    const link = encodeLink({ ...defaults, edits, treeName: 'Grandmother\u2019s & mine' });
    expect(link).toMatch(
      /^s=quaking-aspen&seed=1&levels.1.downAngle=45&switches.paper=1&bark.kind=smooth&bark.colour=abc123&foliage.outline=none&wind.stiffness=2,0.8&called=Grandmother%E2%80%99s%20%26%20mine&t=0/,
    );
    const { document, faults } = decodeLink(link, options);
    expect(faults).toEqual([]);
    expect(document.treeName).toBe('Grandmother\u2019s & mine');
    expect(document.edits).toEqual({ ...edits, 'levels.1.downAngle': 45, 'bark.colour': '#abc123' });
    expect(Object.keys(document.edits)[0]).toBe('levels.1.downAngle');
  });

  it('packs a link that would be too long, and reads it again', () => {
    const every: SpeciesEdits = Object.fromEntries(
      [...PLACES].map(([path, { parameter: p }]) => [
        path,
        p.kind === 'number'
          ? p.max
          : p.kind === 'numbers'
            ? [p.min, p.max]
            : ((p.default as string | boolean | undefined) ?? null),
      ]),
    );
    const long = { ...defaults, edits: every };
    const link = encodeLink(long);
    expect(link).toMatch(/^z=[\w-]+$/);
    expect(link.length).toBeLessThan(1500);
    expect(decodeLink(link, options)).toEqual({ document: roundDocument(long), faults: [] });
    // What is typed beside it goes before what is in it.
    const typed = decodeLink(`seed=77&${link}&tree.scale=12`, options).document;
    expect([typed.seed, typed.edits['tree.scale']]).toEqual([77, 12]);
  });

  it('packs a species file of the reader, whatever letters it has', () => {
    const ownSpecies = `{"name":"Łąka & <b>träd</b> 🌳","source":"${'a long story, '.repeat(200)}"}`;
    const link = encodeLink({ ...defaults, ownSpecies });
    expect(link.length).toBeLessThan(800);
    expect(decodeLink(link, options).document.ownSpecies).toBe(ownSpecies);
  });

  it('does not unpack more than a link can be', () => {
    const bomb = bytesToBase64(deflateSync(new Uint8Array(50_000_000)));
    const { document, faults } = decodeLink(`z=${bomb}&seed=4`, options);
    expect(faults.map((f) => f.key)).toEqual(['z']);
    expect(document.seed).toBe(4);
  });

  it('has keys that an address knows from those of others', () => {
    fc.assert(
      fc.property(anyDocument, (document) => {
        const keys = [...new URLSearchParams(encodeLink(document)).keys()];
        expect(keys.filter((key) => !isLinkKey(key))).toEqual([]);
      }),
    );
    expect(['utm_source', 'levels.9.curve', 'toString', 'w9'].filter(isLinkKey)).toEqual([]);
  });

  it('says which key was meant where it is plain', () => {
    const allowed = (link: string) => decodeLink(link, options).faults.map((f) => f.allowed);
    expect(allowed('levels.1.downangle=45')).toEqual(['levels.1.downAngle, if that was meant']);
    expect(allowed('levels.7.downAngle=45')).toEqual(['levels.0.downAngle, if that was meant']);
    expect(allowed('tiger=45')).toEqual(['nothing of this name']);
    expect(allowed('tree.scale=none')).toEqual(['a number from 0.05 to 150 metres']);
    expect(allowed('bark.colour=red')).toEqual(['a colour as rrggbb']);
  });

  it('reads links from the time of four waves and one model as they were meant, whatever the winds are now', () => {
    const old =
      's=quaking-aspen&seed=7&t=2&wind=gale&strength=0.8&w1=0.4,17.2,12,3,2,0.25&w2=0.3,0,12,3,2,0.25,off' +
      '&w3=0.2,0,12,3,2,0&w4=0.1,90,12,3,2,0.5&p=1.8&m=2&pose=lagged&paper=1';
    const { document, faults } = decodeLink(old, options);
    expect(faults).toEqual([]);
    const { wind } = document;
    expect(wind).toMatchObject({ model: 'direct', strength: 0.8, forceExponent: 1.8, lengthExponent: 2 });
    expect(wind).toMatchObject({ pose: 'lagged', paper: true, zeroMean: false, gusts: [], record: null, stiffness: 1 });
    expect(wind.profile).toEqual(STILL.profile);
    expect(wind.waves.map((w) => [w.amplitude, w.on, w.solo])).toEqual([
      [0.4, true, false],
      [0.3, false, false],
      [0.2, true, false],
      [0.1, true, false],
    ]);
    expect(document.compare).toBeNull();
    expect(document.overlays).toEqual(OVERLAYS);
  });

  it('takes a line that somebody typed as a change of the wind that it names', () => {
    const { document, faults } = decodeLink('wind=gale&stiff=2&w2=0.9,0,5,1,1,0,solo', options);
    expect(faults).toEqual([]);
    expect(document.wind).toMatchObject({ model: 'spring', stiffness: 2, zeroMean: true, gusts: [gust] });
    expect(document.wind.waves).toHaveLength(6);
    expect(document.wind.waves[1]).toMatchObject({ amplitude: 0.9, solo: true });
    expect(decodeLink('wind=recorded', options).document.wind.record).toBe(record);
    expect(decodeLink('rec=sample', options).document.wind.record).toBe(record);
  });

  it('reads gusts with a repeat and without one, and lets none come again before it is over', () => {
    const gustsOf = (link: string) => {
      const { document, faults } = decodeLink(link, options);
      expect(faults).toEqual([]);
      return document.wind.gusts;
    };
    const g = '3,0,1,0,8,0.15,0.8,2.5,30';
    expect(gustsOf(`g1=${g}`)).toEqual([gust]);
    expect(gustsOf(`g1=${g},40&g2=${g}`)).toEqual([{ ...gust, repeat: 40 }, gust]);
    expect(gustsOf(`g1=${g},2`)).toEqual([{ ...gust, repeat: 5 }]);
    const of = (gusts: Gust[]) => encodeLink({ ...defaults, wind: { ...defaults.wind, gusts } });
    expect(of([gust, { ...gust, repeat: 40 }])).toContain(`g1=${g}&g2=${g},40&`);
  });

  it('says that a measured wind of the reader is not in a link', () => {
    const own = { ...defaults, wind: { ...defaults.wind, record: { ...record, name: 'mine.csv' } } };
    const { document, faults } = decodeLink(encodeLink(own), options);
    expect(faults.map((f) => [f.key, f.found])).toEqual([['rec', 'mine.csv']]);
    expect(faults[0]!.allowed).toContain('open a record of your own again');
    expect(document.wind).toEqual(defaults.wind);
  });

  it('compares a wind with one of which little is said', () => {
    const { document, faults } = decodeLink('wind=gale&compare=side,0.3&b.model=direct&b.wind=breeze', options);
    expect(faults).toEqual([]);
    expect(document.compare).toMatchObject({ layout: 'side', at: 0.3, preset: 'breeze' });
    expect(document.compare!.wind.model).toBe('direct');
    expect(document.preset).toBe('gale');
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
    ['w1=0.4,17.2,12,3,2,0.25,loud', 'w1', '0.4,17.2,12,3,2,0.25,loud'],
    ['w9=0.4,17.2,12,3,2,0.25', 'w9', '0.4,17.2,12,3,2,0.25'],
    ['waves=9', 'waves', '9'],
    ['g1=1,2,3', 'g1', '1,2,3'],
    ['g1=3,0,1,0,8,0.15,0.8,2.5,30,-1', 'g1', '3,0,1,0,8,0.15,0.8,2.5,30,-1'],
    ['model=rubber', 'model', 'rubber'],
    ['profile=steep,1,1,1', 'profile', 'steep,1,1,1'],
    ['profile=log,10,-1,0.2', 'profile roughness', '-1'],
    ['levelhz=grown,fast', 'levelhz level 1', 'fast'],
    ['sway=ratio,1,2', 'sway', 'ratio,1,2'],
    ['rec=tornado', 'rec', 'tornado'],
    ['compare=split', 'compare', 'split'],
    ['compare=split,2', 'compare place of the line', '2'],
    ['b.w1=0', 'b.w1', '0'],
    ['probe=-1', 'probe', '-1'],
    ['arrows=maybe', 'arrows', 'maybe'],
    ['own=%%%', 'own', '%%%'],
    ['own=gICA', 'own', 'gICA'],
    ['tree.scale=1e300', 'tree.scale', '1e300'],
    ['tree.levels=2.5', 'tree.levels', '2.5'],
    ['levels.1.downAngle=NaN', 'levels.1.downAngle', 'NaN'],
    ['levels.4.downAngle=1', 'levels.4.downAngle', '1'],
    ['switches.paper=yes', 'switches.paper', 'yes'],
    ['bark.kind=scaly', 'bark.kind', 'scaly'],
    ['bark.colour=%3Cb%3E', 'bark.colour', '<b>'],
    ['wind.stiffness=1,,2', 'wind.stiffness', '1,,2'],
    ['wind.stiffness=1,1,1,1,1,1,1,1,1', 'wind.stiffness', '1,1,1,1,1,1,1,1,1'],
    ['tree.__proto__=1', 'tree.__proto__', '1'],
    ['called=%20', 'called', ' '],
    ['z=', 'z', ''],
    ['z=%%', 'z', '%%'],
    ['z=AAAA', 'z', 'AAAA'],
    ['tiger=1', 'tiger', '1'],
  ])('%s: says what is wrong and applies the rest', (bad, key, found) => {
    const { document, faults } = decodeLink(`${bad}&leaves=0`, options);
    expect(faults.map((f) => [f.key, f.found])).toEqual([[key, found]]);
    expect(faults[0]!.allowed).not.toBe('');
    const on = !bad.endsWith('off');
    const waves = defaults.wind.waves.map((w, i) => (i === 2 ? { ...w, on } : w));
    expect({
      ...document,
      compare: null,
      wind: { ...document.wind, profile: STILL.profile, spring: STILL.spring },
    }).toEqual({
      ...defaults,
      showLeaves: false,
      wind: { ...defaults.wind, waves },
    });
  });

  it('never throws', () => {
    fc.assert(
      fc.property(
        fc.string(),
        fc.constantFrom(
          '',
          's=',
          'cam=',
          'w1=',
          'g1=',
          'own=e',
          'file=e',
          'z=',
          'z=S7c',
          'tree.scale=',
          'wind.stiffness=',
          'called=',
          't=1',
          'wind=own&name=',
          'profile=log',
          'levelhz=',
          'b.w1=',
        ),
        (text, start) => {
          expect(encodeLink(decodeLink(start + text, options).document)).toBeTypeOf('string');
        },
      ),
    );
  });
});

it('what is no number becomes one that a link can hold', () => {
  const odd = {
    ...defaults,
    time: Number.NaN,
    wind: {
      ...defaults.wind,
      stiffness: Number.NaN,
      waves: [{ ...wave(0.1), direction: Number.NaN, speed: Number.POSITIVE_INFINITY }],
    },
  };
  const link = encodeLink(odd);
  expect(link).not.toMatch(/NaN|Infinity/);
  expect(decodeLink(link, options)).toEqual({ document: roundDocument(odd), faults: [] });
});
