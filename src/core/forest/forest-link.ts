import { nearest } from '../file/nearest.ts';
import { STAGES } from '../link/document.ts';
import { type LinkFault, LinkReader } from '../link/reader.ts';
import { allowed, type NumberRule, readNumber } from '../link/rule.ts';
import { SEASONS } from '../species/season.ts';
import type { DensitySpec, ForestCamera, ForestDocument, TerrainSpec } from './forest.ts';
import {
  CAMERA_NUMBERS,
  CLEARING_NUMBERS,
  FOREST_NUMBERS,
  HILLS_NUMBERS,
  LONGEST_NAME,
  MAP_NUMBERS,
} from './forest-numbers.ts';
import { decodeMix, encodeMix } from './mix-link.ts';
import { roundForest, type Shipped } from './parse-forest.ts';

/** The keys of a forest's link, each with what it holds of the document. */
const NUMBER_KEYS = {
  seed: 'seed',
  size: 'size',
  trees: 'count',
  gap: 'spacing',
  turn: 'windTurn',
  ms: 'budget',
} as const;

const rulesOf = (rules: Readonly<Record<string, NumberRule>>): NumberRule[] => Object.values(rules);
const listed = (rules: Readonly<Record<string, NumberRule>>, values: object): string =>
  Object.keys(rules)
    .map((key) => (values as Readonly<Record<string, number>>)[key])
    .join();

/** A list of a link as the numbers that it stands for. */
const named = <Key extends string>(
  rules: Readonly<Record<Key, NumberRule>>,
  numbers: readonly number[],
): Record<Key, number> =>
  Object.fromEntries(Object.keys(rules).map((key, i) => [key, numbers[i]!])) as Record<Key, number>;

/**
 * The forest as `key=value` pairs for an address. Pictures that were put in are not in it: a link says what they were called, and
 * `decodeForest` that they are missing.
 */
export function encodeForest(document: ForestDocument): string {
  const d = roundForest(document);
  const pairs: [string, string][] = [['name', d.name]];
  const put = (key: string, value: string | number): void => void pairs.push([key, String(value)]);
  for (const [key, of] of Object.entries(NUMBER_KEYS)) put(key, d[of]);
  put('mix', encodeMix(d.mix));
  const { terrain, density } = d;
  if (terrain.kind === 'hills') put('hills', listed(HILLS_NUMBERS, terrain));
  else put('ground', `${listed(MAP_NUMBERS, terrain)},${terrain.name}`);
  if (density.kind === 'clearings') put('clear', listed(CLEARING_NUMBERS, density));
  else put('cover', density.name);
  put('season', d.season);
  put('stage', d.stage);
  if (d.hour !== null) put('hour', d.hour);
  put('wind', d.wind);
  if (d.windSpeed !== null) put('speed', d.windSpeed);
  if (d.camera) put('cam', listed(CAMERA_NUMBERS, d.camera));
  const text = (value: string): string =>
    encodeURIComponent(value.replace(/\p{Surrogate}/gu, '\ufffd'))
      .replaceAll('%2C', ',')
      .replaceAll('%3A', ':');
  return pairs.map(([key, value]) => `${key}=${text(value)}`).join('&');
}

export interface DecodedForest {
  readonly document: ForestDocument;
  /** Each value that could not be used, and each key that no link has. */
  readonly faults: readonly LinkFault[];
  /** Names of the pictures that the forest had and the link has not. */
  readonly missing: readonly string[];
}

/**
 * Reads what `encodeForest` wrote, or a person typed: each value that is wrong gives a fault and its default, the rest applies. Never
 * throws.
 */
export function decodeForest(link: string, defaults: ForestDocument, shipped: Required<Shipped>): DecodedForest {
  const reader = new LinkReader(new Map(new URLSearchParams(link.replace(/^[#?]/, ''))));
  const number = (key: keyof typeof NUMBER_KEYS): number =>
    reader.number(key, FOREST_NUMBERS[NUMBER_KEYS[key]], defaults[NUMBER_KEYS[key]]);
  // Hour, speed and camera are null where a link that says what forest it is leaves them out.
  const whole = reader.has('mix');
  const numberOrNull = (key: string, rule: NumberRule, fallback: number | null): number | null =>
    reader.read<number | null>(key, whole ? null : fallback, allowed(rule), (text) => readNumber(rule, text));
  const missing: string[] = [];
  const document = roundForest({
    name: reader.read('name', defaults.name, `a name of 1 to ${LONGEST_NAME} letters`, nameIn),
    seed: number('seed'),
    size: number('size'),
    count: number('trees'),
    spacing: number('gap'),
    mix: decodeMix(reader, defaults.mix, shipped.species),
    terrain: terrain(reader, defaults.terrain, missing),
    density: density(reader, defaults.density, missing),
    season: reader.choice('season', defaults.season, SEASONS),
    stage: reader.choice('stage', defaults.stage, STAGES),
    hour: numberOrNull('hour', FOREST_NUMBERS.hour, defaults.hour),
    wind: reader.choice('wind', defaults.wind, shipped.winds),
    windSpeed: numberOrNull('speed', FOREST_NUMBERS.windSpeed, defaults.windSpeed),
    windTurn: number('turn'),
    budget: number('ms'),
    camera: camera(reader, whole ? null : defaults.camera),
  });
  unknown(reader);
  return { document, faults: reader.faults, missing };
}

const nameIn = (text: string): string | undefined =>
  text.trim() === '' || text.length > LONGEST_NAME ? undefined : text;

function unknown(reader: LinkReader): void {
  const known = [...reader.known];
  for (const [key, value] of reader.values) {
    const near = nearest(key.slice(0, 40), known);
    reader.fault(key, value, near ? `${near}, if that was meant` : 'nothing of this name');
  }
}

function terrain(reader: LinkReader, fallback: TerrainSpec, missing: string[]): TerrainSpec {
  const map = reader.take('ground');
  const hills = reader.take('hills');
  if (map !== undefined) {
    const [black = '', white = '', ...rest] = map.split(',');
    const name = nameIn(rest.join());
    const heights = reader.list('ground', `${black},${white}`, rulesOf(MAP_NUMBERS));
    if (heights && name !== undefined) {
      missing.push(name);
      return { kind: 'map', name, ...named(MAP_NUMBERS, heights) };
    }
    if (name === undefined) reader.fault('ground', map, 'the heights of black and white, and the name of a picture');
    return fallback;
  }
  if (hills === undefined) return fallback;
  const numbers = reader.list('hills', hills, rulesOf(HILLS_NUMBERS));
  return numbers ? { kind: 'hills', ...named(HILLS_NUMBERS, numbers) } : fallback;
}

function density(reader: LinkReader, fallback: DensitySpec, missing: string[]): DensitySpec {
  const name = reader.read<string | null>('cover', null, 'the name of a picture', nameIn);
  const clear = reader.take('clear');
  if (name !== null) {
    missing.push(name);
    return { kind: 'map', name };
  }
  if (clear === undefined) return fallback;
  const numbers = reader.list('clear', clear, rulesOf(CLEARING_NUMBERS));
  return numbers ? { kind: 'clearings', ...named(CLEARING_NUMBERS, numbers) } : fallback;
}

function camera(reader: LinkReader, fallback: ForestCamera | null): ForestCamera | null {
  const text = reader.take('cam');
  if (text === undefined) return fallback;
  const numbers = reader.list('cam', text, rulesOf(CAMERA_NUMBERS));
  return numbers && named(CAMERA_NUMBERS, numbers);
}
