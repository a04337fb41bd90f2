import { foundText } from '../file/allowed.ts';
import { type Fault, readJson } from '../file/fault.ts';
import { type Fields, fieldsOf, hasFormat, listOf, unknownKeys } from '../file/read.ts';
import { STAGES } from '../link/document.ts';
import { kept, type NumberRule } from '../link/rule.ts';
import { FieldReader } from '../project/fields.ts';
import { SEASONS } from '../species/season.ts';
import { DEFAULT_CLEARINGS, DEFAULT_FOREST, DEFAULT_HILLS } from './default-forest.ts';
import type { DensitySpec, ForestCamera, ForestDocument, ForestSpecies, Habitat, TerrainSpec } from './forest.ts';
import {
  CAMERA_NUMBERS,
  CLEARING_NUMBERS,
  FOREST_NUMBERS,
  HABITAT_NUMBERS,
  HILLS_NUMBERS,
  LONGEST_NAME,
  MAP_NUMBERS,
  MOST_SPECIES,
  SHARE,
} from './forest-numbers.ts';

export type ParsedForest =
  | { readonly forest: ForestDocument; readonly faults?: undefined }
  | { readonly forest?: undefined; readonly faults: readonly Fault[] };

/** Ids of what ships, where the caller knows them: others are faults then. */
export interface Shipped {
  readonly species?: readonly string[];
  readonly winds?: readonly string[];
}

/** A forest file has some kilobytes; this much is something else. */
export const LONGEST_FOREST = 100_000;

export const ID = /^[a-z0-9]+(-[a-z0-9]+)*$/;

const PLAIN_KEYS = ['name', 'mix', 'terrain', 'density', 'season', 'stage', 'wind', 'camera'];

/**
 * A forest from the text of a file, or from what JSON.parse made of it; every fault where there are any, each with its path.
 *
 * Whatever is left out is as in `DEFAULT_FOREST`, but for format, version and mix. Never throws.
 */
export function parseForest(file: unknown, shipped: Shipped = {}): ParsedForest {
  if (typeof file !== 'string') return readForest(file, shipped);
  const { value, fault } = readJson(file, 'a forest', LONGEST_FOREST);
  return fault ? { faults: [fault] } : readForest(value, shipped);
}

function readForest(value: unknown, shipped: Shipped): ParsedForest {
  const faults: Fault[] = [];
  const file = fieldsOf(value, '', faults);
  if (!file || !hasFormat(file, 'windgrove-forest', faults)) return { faults };
  unknownKeys(file, '', ['format', 'version', '$schema', ...PLAIN_KEYS, ...Object.keys(FOREST_NUMBERS)], faults);
  const read = new FieldReader(file, '', faults);
  const base = DEFAULT_FOREST;
  const numberOrNull = (key: 'hour' | 'windSpeed'): number | null =>
    read.value(key) === null || read.value(key) === undefined ? null : read.number(key, FOREST_NUMBERS[key], 0);
  const forest: ForestDocument = {
    name: read.text('name', LONGEST_NAME, base.name),
    seed: read.number('seed', FOREST_NUMBERS.seed, base.seed),
    size: read.number('size', FOREST_NUMBERS.size, base.size),
    count: read.number('count', FOREST_NUMBERS.count, base.count),
    spacing: read.number('spacing', FOREST_NUMBERS.spacing, base.spacing),
    mix: readMix(file.mix, shipped.species, faults),
    terrain: readTerrain(file.terrain, faults),
    density: readDensity(file.density, faults),
    season: read.choice('season', SEASONS, base.season),
    stage: read.choice('stage', STAGES, base.stage),
    hour: numberOrNull('hour'),
    wind: idAt(read, 'wind', shipped.winds, base.wind),
    windSpeed: numberOrNull('windSpeed'),
    windTurn: read.number('windTurn', FOREST_NUMBERS.windTurn, base.windTurn),
    budget: read.number('budget', FOREST_NUMBERS.budget, base.budget),
    camera: readCamera(file.camera, faults),
  };
  return faults.length > 0 ? { faults } : { forest };
}

function idAt(read: FieldReader, key: string, known: readonly string[] | undefined, fallback: string): string {
  const value = read.value(key);
  if (value === undefined && fallback !== '') return fallback;
  if (typeof value === 'string' && (known ? known.includes(value) : ID.test(value))) return value;
  read.fault(key, known ? `one of ${known.join(', ')}` : 'an id: small letters and digits with hyphens between');
  return fallback;
}

function readMix(value: unknown, known: readonly string[] | undefined, faults: Fault[]): readonly ForestSpecies[] {
  const entries = listOf(value, [1, MOST_SPECIES], 'mix', `a list of 1 to ${MOST_SPECIES} species`, faults) ?? [];
  const before = faults.length;
  const mix = entries.flatMap((entry, i) => {
    const path = `mix[${i}]`;
    const fields = fieldsOf(entry, path, faults);
    if (!fields) return [];
    unknownKeys(fields, `${path}.`, ['species', 'share', 'where'], faults);
    const read = new FieldReader(fields, `${path}.`, faults);
    const where = fields.where === undefined ? undefined : readHabitat(fields.where, `${path}.where`, faults);
    return [
      { species: idAt(read, 'species', known, ''), share: read.number('share', SHARE, 1), ...(where && { where }) },
    ];
  });
  mix.forEach(({ species }, i) => {
    const first = mix.findIndex((other) => other.species === species);
    if (species === '' || first === i) return;
    faults.push({
      path: `mix[${i}].species`,
      found: foundText(species),
      allowed: `a species other than that of mix[${first}]`,
    });
  });
  if (faults.length === before && mix.length > 0 && mix.every(({ share }) => share === 0))
    faults.push({ path: 'mix', found: 'no share above 0', allowed: 'at least one species with a share' });
  return mix;
}

function readHabitat(value: unknown, path: string, faults: Fault[]): Habitat | undefined {
  const fields = fieldsOf(value, path, faults);
  if (!fields) return undefined;
  const keys = Object.keys(HABITAT_NUMBERS) as (keyof typeof HABITAT_NUMBERS)[];
  unknownKeys(fields, `${path}.`, keys, faults);
  const habitat: { -readonly [Key in keyof Habitat]: Habitat[Key] } = {};
  for (const key of keys) {
    if (fields[key] === undefined) continue;
    const at = `${path}.${key}`;
    const range = fieldsOf(fields[key], at, faults);
    if (!range) continue;
    unknownKeys(range, `${at}.`, ['least', 'most', 'soft'], faults);
    const rule = HABITAT_NUMBERS[key];
    const read = new FieldReader(range, `${at}.`, faults);
    const least = read.number('least', rule, rule.min);
    const most = read.number('most', rule, rule.max);
    if (most < least) read.fault('most', `at least ${at}.least, ${least}`);
    habitat[key] = { least, most, soft: read.number('soft', { ...rule, min: 0 }, 0) };
  }
  return Object.keys(habitat).length > 0 ? habitat : undefined;
}

/** All numbers of a part of the file by their rules. */
function numbersOf<Key extends string>(
  fields: Fields,
  prefix: string,
  rules: Readonly<Record<Key, NumberRule>>,
  base: Readonly<Record<NoInfer<Key>, number>>,
  faults: Fault[],
): Record<Key, number> {
  const read = new FieldReader(fields, prefix, faults);
  const entries = Object.entries(rules) as [Key, NumberRule][];
  return Object.fromEntries(entries.map(([key, rule]) => [key, read.number(key, rule, base[key])])) as Record<
    Key,
    number
  >;
}

/** The kind of a part, and its fields: `map` where it says so. */
function kindOf<Kind extends string>(value: unknown, path: string, procedural: Kind, faults: Fault[]) {
  const fields = value === undefined ? {} : (fieldsOf(value, path, faults) ?? {});
  const read = new FieldReader(fields, `${path}.`, faults);
  const kind = read.choice('kind', [procedural, 'map'] as const, procedural);
  return { fields, read, kind };
}

function readTerrain(value: unknown, faults: Fault[]): TerrainSpec {
  const { fields, read, kind } = kindOf(value, 'terrain', 'hills', faults);
  if (kind === 'map') {
    unknownKeys(fields, 'terrain.', ['kind', 'name', ...Object.keys(MAP_NUMBERS)], faults);
    const name = read.text('name', LONGEST_NAME, 'height map');
    return { kind, name, ...numbersOf(fields, 'terrain.', MAP_NUMBERS, { black: 0, white: 100 }, faults) };
  }
  unknownKeys(fields, 'terrain.', ['kind', ...Object.keys(HILLS_NUMBERS)], faults);
  return { kind, ...numbersOf(fields, 'terrain.', HILLS_NUMBERS, DEFAULT_HILLS, faults) };
}

function readDensity(value: unknown, faults: Fault[]): DensitySpec {
  const { fields, read, kind } = kindOf(value, 'density', 'clearings', faults);
  if (kind === 'map') {
    unknownKeys(fields, 'density.', ['kind', 'name'], faults);
    return { kind, name: read.text('name', LONGEST_NAME, 'density map') };
  }
  unknownKeys(fields, 'density.', ['kind', ...Object.keys(CLEARING_NUMBERS)], faults);
  return { kind, ...numbersOf(fields, 'density.', CLEARING_NUMBERS, DEFAULT_CLEARINGS, faults) };
}

function readCamera(value: unknown, faults: Fault[]): ForestCamera | null {
  if (value === undefined || value === null) return null;
  const fields = fieldsOf(value, 'camera', faults);
  if (!fields) return null;
  unknownKeys(fields, 'camera.', Object.keys(CAMERA_NUMBERS), faults);
  const read = new FieldReader(fields, 'camera.', faults);
  for (const key of Object.keys(CAMERA_NUMBERS)) if (read.value(key) === undefined) read.fault(key, 'a number');
  return numbersOf(fields, 'camera.', CAMERA_NUMBERS, { x: 0, y: 0, z: 0, yaw: 0, pitch: 0 }, faults);
}

const roundAll = <Part extends object>(part: Part, rules: Readonly<Record<string, NumberRule>>): Part => {
  const round = ([key, value]: [string, unknown]) => [
    key,
    rules[key] && typeof value === 'number' ? kept(rules[key], value) : value,
  ];
  return Object.fromEntries(Object.entries(part).map(round)) as Part;
};

const roundRange = (where: Habitat): Habitat =>
  Object.fromEntries(
    Object.entries(where).map(([key, range]) => {
      const rule = HABITAT_NUMBERS[key as keyof Habitat];
      return [key, roundAll(range, { least: rule, most: rule, soft: { ...rule, min: 0 } })];
    }),
  );

/** The forest with the digits that links and files keep. */
export const roundForest = (forest: ForestDocument): ForestDocument => ({
  ...roundAll(forest, FOREST_NUMBERS),
  mix: forest.mix.map(({ species, share, where }) => ({
    species,
    share: kept(SHARE, share),
    ...(where && { where: roundRange(where) }),
  })),
  terrain: roundAll(forest.terrain, forest.terrain.kind === 'hills' ? HILLS_NUMBERS : MAP_NUMBERS),
  density: roundAll(forest.density, forest.density.kind === 'clearings' ? CLEARING_NUMBERS : {}),
  camera: forest.camera && roundAll(forest.camera, CAMERA_NUMBERS),
});
