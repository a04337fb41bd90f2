import { allowedValues } from '../file/allowed.ts';
import type { Fault } from '../file/fault.ts';
import { type Fields, fieldsOf, listOf, unknownKeys } from '../file/read.ts';
import { ALL_LEVELS, LAYOUTS, type LinkDocument, OVERLAYS, OWN_WIND, STAGES, VIEW_MODES } from '../link/document.ts';
import { roundCamera, roundTime } from '../link/encode.ts';
import { roundEdits } from '../link/encode-edits.ts';
import { CAMERA_NUMBERS, LINK_NUMBERS } from '../link/numbers.ts';
import { roundWind } from '../link/round-wind.ts';
import { mayBe, type ParameterValue, PLACES, type SpeciesEdits } from '../species/edits.ts';
import { LONGEST_NAME } from '../species/parse.ts';
import { SEASONS } from '../species/season.ts';
import { treeNameOf } from '../species/tree-name.ts';
import { parseWind } from '../wind/parse-wind.ts';
import { STILL, type Wind } from '../wind/wind.ts';
import { windToFile } from '../wind/wind-file.ts';
import { FieldReader } from './fields.ts';

/** What a project holds of a document besides its species; the theme is the reader's, not the tree's. */
export type ProjectDocument = Omit<LinkDocument, 'species' | 'ownSpecies' | 'theme'>;

/** Letters of the id of a wind that ships. */
const LONGEST_ID = 80;

/** Keys of a project file that hold the document. */
export const DOCUMENT_KEYS = [
  'name',
  'edits',
  'seed',
  'wind',
  'windPreset',
  'blowing',
  'compare',
  'view',
  'camera',
  'time',
  'paused',
  'rate',
] as const;

const VIEW_KEYS = [
  'mode',
  'levels',
  'leaves',
  'season',
  'stage',
  'hour',
  'probe',
  ...(['arrows', 'fronts', 'handle'] as const),
];
const COMPARE_KEYS = ['layout', 'at', 'windPreset', 'wind'];
const CAMERA_KEYS = ['azimuth', 'elevation', 'distance', 'target'];

/** The document as a project file has it, for JSON.stringify: angles of winds in degrees. */
export function documentFields(document: ProjectDocument): Record<(typeof DOCUMENT_KEYS)[number], unknown> {
  const { compare, overlays } = document;
  return {
    name: document.treeName,
    edits: document.edits,
    seed: document.seed,
    wind: windToFile(document.wind),
    windPreset: document.preset,
    blowing: document.blowing,
    compare: compare && {
      layout: compare.layout,
      at: compare.at,
      windPreset: compare.preset,
      wind: windToFile(compare.wind),
    },
    view: {
      mode: document.view,
      levels: document.levelsShown,
      leaves: document.showLeaves,
      season: document.season,
      stage: document.stage,
      hour: document.hour,
      arrows: overlays.arrows,
      fronts: overlays.fronts,
      handle: overlays.handle,
      probe: document.probe,
    },
    camera: document.camera,
    time: document.time,
    paused: document.paused,
    rate: document.rate,
  };
}

/** The document that the fields of a project file say; faults go on the list, and what is wrong has its default. Never throws. */
export function readDocument(file: Fields, faults: Fault[]): ProjectDocument {
  const read = new FieldReader(file, '', faults);
  const windAt = (reader: FieldReader, path: string): Wind => {
    const value = reader.value('wind');
    if (value === undefined) return roundWind(STILL);
    const parsed = parseWind(typeof value === 'string' ? [] : value);
    if (!parsed.wind) {
      for (const fault of parsed.faults) faults.push({ ...fault, path: fault.path ? `${path}.${fault.path}` : path });
    } else if (parsed.recordFile !== null) reader.fault('wind', 'a wind with its record in it');
    else return roundWind(parsed.wind);
    return STILL;
  };
  const view = part(file.view, 'view', VIEW_KEYS, faults);
  return {
    treeName: nameOf(read),
    edits: readEdits(file.edits, faults),
    seed: read.number('seed', LINK_NUMBERS.seed, 1),
    wind: windAt(read, 'wind'),
    preset: read.text('windPreset', LONGEST_ID, OWN_WIND),
    blowing: read.flag('blowing', true),
    compare: file.compare === undefined || file.compare === null ? null : readCompare(),
    view: view.choice('mode', VIEW_MODES, 'shaded'),
    levelsShown: view.number('levels', LINK_NUMBERS.levels, ALL_LEVELS),
    showLeaves: view.flag('leaves', true),
    season: view.choice('season', SEASONS, 'summer'),
    stage: view.choice('stage', STAGES, 'meadow'),
    hour: view.value('hour') === null ? null : numberOrNull(view, 'hour'),
    overlays: {
      arrows: view.flag('arrows', OVERLAYS.arrows),
      fronts: view.flag('fronts', OVERLAYS.fronts),
      handle: view.flag('handle', OVERLAYS.handle),
    },
    probe: view.value('probe') === null ? null : numberOrNull(view, 'probe'),
    camera: readCamera(file.camera, faults),
    time: roundTime(read.number('time', LINK_NUMBERS.t, 0)),
    paused: read.flag('paused', false),
    rate: read.number('rate', LINK_NUMBERS.rate, 1),
  };

  function readCompare(): LinkDocument['compare'] {
    const compare = part(file.compare, 'compare', COMPARE_KEYS, faults);
    return {
      layout: compare.choice('layout', LAYOUTS, 'split'),
      at: compare.number('at', LINK_NUMBERS.at, 0.5),
      preset: compare.text('windPreset', LONGEST_ID, OWN_WIND),
      wind: windAt(compare, 'compare.wind'),
    };
  }
}

/** An object within the file; an empty one where the file says nothing of it. */
function part(value: unknown, path: string, keys: readonly string[], faults: Fault[]): FieldReader {
  const fields = value === undefined ? {} : (fieldsOf(value, path, faults) ?? {});
  unknownKeys(fields, `${path}.`, keys, faults);
  return new FieldReader(fields, `${path}.`, faults);
}

const numberOrNull = (reader: FieldReader, key: 'probe' | 'hour'): number | null =>
  reader.value(key) === undefined ? null : reader.number(key, LINK_NUMBERS[key], 0);

function nameOf(read: FieldReader): string | null {
  const value = read.value('name');
  if (value === undefined || value === null) return null;
  const name = typeof value === 'string' ? treeNameOf(value) : null;
  if (name === null) read.fault('name', `a name of 1 to ${LONGEST_NAME} letters, or null`);
  return name;
}

function readEdits(value: unknown, faults: Fault[]): SpeciesEdits {
  if (value === undefined) return {};
  const fields = fieldsOf(value, 'edits', faults) ?? {};
  unknownKeys(fields, 'edits.', [...PLACES.keys()], faults);
  const edits: Record<string, ParameterValue> = {};
  const reader = new FieldReader(fields, 'edits.', faults);
  for (const key of Object.keys(fields)) {
    const place = PLACES.get(key);
    const found = reader.value(key);
    if (mayBe(key, found)) edits[key] = found;
    else if (place) reader.fault(key, allowedValues(place.parameter));
  }
  return roundEdits(edits);
}

function readCamera(value: unknown, faults: Fault[]): LinkDocument['camera'] {
  if (value === undefined || value === null) return null;
  const fields = fieldsOf(value, 'camera', faults);
  if (!fields) return null;
  unknownKeys(fields, 'camera.', CAMERA_KEYS, faults);
  const before = faults.length;
  const [azimuth, elevation, distance, ...places] = CAMERA_NUMBERS;
  const read = new FieldReader(fields, 'camera.', faults);
  const missing = CAMERA_KEYS.filter((key) => read.value(key) === undefined);
  for (const key of missing) read.fault(key, key === 'target' ? 'a list of 3 numbers' : 'a number');
  const target = listOf(fields.target ?? [0, 0, 0], [3, 3], 'camera.target', 'a list of 3 numbers', faults) ?? [];
  const at = new FieldReader(Object.fromEntries(target.entries()), 'camera.target.', faults);
  const [x, y, z] = places.map((rule, i) => at.number(String(i), rule, 0)) as [number, number, number];
  const camera = {
    azimuth: read.number('azimuth', azimuth!, 0),
    elevation: read.number('elevation', elevation!, 0),
    distance: read.number('distance', distance!, 1),
    target: [x, y, z] as const,
  };
  return faults.length > before ? null : roundCamera(camera);
}
