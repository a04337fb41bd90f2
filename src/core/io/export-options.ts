import { allowedValues, foundText, isAllowed } from '../file/allowed.ts';
import type { Fault } from '../file/fault.ts';
import { type ChoiceParameter, type FlagParameter, type NumberParameter, number } from '../file/parameter.ts';
import { SEASONS, type Season } from '../species/season.ts';

/** What a tree can be written as. */
export const EXPORT_FORMATS = ['glb', 'obj', 'swc', 'species', 'channels'] as const;
export type ExportFormat = (typeof EXPORT_FORMATS)[number];

/** A file that an export makes: bare name with its ending, contents, media type. */
export interface ExportFile {
  readonly name: string;
  readonly bytes: Uint8Array<ArrayBuffer>;
  readonly type: string;
}

/** How finely the mesh follows the stems and the leaves' outline. */
export type MeshDetail = 'low' | 'medium' | 'high';

/** What an export is asked for; `EXPORT_PARAMETERS` says what each means and what it may be. */
export interface ExportOptions {
  readonly format: ExportFormat;
  readonly detail: MeshDetail;
  readonly levels: number;
  readonly leaves: 'none' | 'instances' | 'expanded';
  readonly mostLeaves: number;
  readonly season: Season;
  readonly lods: 'none' | 'named' | 'MSFT_lod';
  readonly textures: 'none' | '128' | '256' | '512';
  readonly clip: boolean;
  readonly boneLevels: number;
  readonly start: number;
  readonly seconds: number;
  readonly rate: number;
  readonly quantize: boolean;
  readonly engine: 'attributes' | 'godot' | 'unreal';
  /** Link that opens the tree again, '' for none: it is written into files that have room for it. No row of the table. */
  readonly link: string;
}

/** A row of the table, and the formats that read it. */
export type ExportParameter = (NumberParameter | FlagParameter | ChoiceParameter) & {
  readonly key: Exclude<keyof ExportOptions, 'link'>;
  readonly formats: readonly ExportFormat[];
};

const MESHES: readonly ExportFormat[] = ['glb', 'obj', 'channels'];
const GLB: readonly ExportFormat[] = ['glb'];

type Key = ExportParameter['key'];

const choice = (
  key: Key,
  formats: readonly ExportFormat[],
  label: string,
  help: string,
  choices: readonly string[],
  value: string,
): ExportParameter => ({
  kind: 'choice',
  group: 'export',
  key,
  label,
  help,
  symbol: '',
  section: '',
  choices,
  default: value,
  formats,
});

const flag = (key: Key, label: string, help: string, value: boolean): ExportParameter => ({
  kind: 'flag',
  group: 'export',
  key,
  label,
  help,
  symbol: '',
  section: '',
  default: value,
  formats: GLB,
});

const amount = (
  key: Key,
  formats: readonly ExportFormat[],
  label: string,
  help: string,
  range: readonly [number, number, number],
  row: { unit?: string; integer?: true; default: number },
): ExportParameter => ({ ...number('export', key, label, help, range, row), key, formats });

/** The table of the export: the dialog, the command and the documents read it from here. */
export const EXPORT_PARAMETERS: readonly ExportParameter[] = [
  choice('format', EXPORT_FORMATS, 'Format', 'What the tree is written as.', EXPORT_FORMATS, 'glb'),
  choice('detail', MESHES, 'Detail', 'How finely the mesh follows the stems.', ['low', 'medium', 'high'], 'medium'),
  amount('levels', [...MESHES, 'swc'], 'Levels', 'Levels of stems that are written, from the trunk on.', [1, 8, 1], {
    integer: true,
    default: 8,
  }),
  choice(
    'leaves',
    MESHES,
    'Leaves',
    'No leaves, one leaf that is placed many times (small file, fewer programs read it), or every leaf as triangles.',
    ['none', 'instances', 'expanded'],
    'expanded',
  ),
  amount(
    'mostLeaves',
    MESHES,
    'Leaves at most',
    'Where a tree has more, fewer and larger ones cover as much.',
    [100, 600_000, 100],
    { integer: true, default: 40_000 },
  ),
  choice('season', MESHES, 'Season', 'How leaves, blossom and fruit look.', SEASONS, 'summer'),
  choice(
    'lods',
    GLB,
    'Levels of detail',
    'One mesh, three meshes as nodes named _LOD0 to _LOD2, or three that the extension MSFT_lod switches between.',
    ['none', 'named', 'MSFT_lod'],
    'none',
  ),
  choice(
    'textures',
    ['glb', 'obj'],
    'Textures',
    'Texels along each side of the images of the bark.',
    ['none', '128', '256', '512'],
    '512',
  ),
  flag('clip', 'Wind as a clip', 'Bones in the stems, and a clip of the wind that loops.', false),
  amount(
    'boneLevels',
    GLB,
    'Levels with bones',
    'Levels of stems that have bones of their own; what is thinner rides on them.',
    [1, 8, 1],
    { integer: true, default: 2 },
  ),
  amount('start', GLB, 'Start of the clip', 'Time of the wind at which the clip begins.', [0, 3600, 0.1], {
    unit: 's',
    default: 0,
  }),
  amount('seconds', GLB, 'Length of the clip', 'Time after which the clip begins again.', [1, 60, 0.5], {
    unit: 's',
    default: 6,
  }),
  amount('rate', GLB, 'Keys a second', 'Poses a second that the clip is made of.', [5, 60, 1], {
    integer: true,
    unit: 'Hz',
    default: 30,
  }),
  flag('quantize', 'Short numbers', 'Positions, normals and texture places in 16 bits: half the size.', false),
  choice(
    'engine',
    ['channels'],
    'Channels for',
    'Attributes of our own, colours as Godot reads them, or textures of Unreal’s Pivot Painter 2.',
    ['attributes', 'godot', 'unreal'],
    'attributes',
  ),
];

/** Every option at its default, as `format` is written where nobody chose anything. */
export const DEFAULT_EXPORT: ExportOptions = {
  ...(Object.fromEntries(EXPORT_PARAMETERS.map((p) => [p.key, p.default])) as unknown as ExportOptions),
  link: '',
};

/** The rows that a format reads, in the order of the table. */
export const exportParametersOf = (format: ExportFormat): ExportParameter[] =>
  EXPORT_PARAMETERS.filter(({ key, formats }) => key !== 'format' && formats.includes(format));

/** Options with defaults for what is left out; or what is wrong with them, one fault a row. Unknown names are faults. */
export function readExportOptions(
  given: Readonly<Record<string, unknown>>,
): { options: ExportOptions; faults?: undefined } | { options?: undefined; faults: Fault[] } {
  const faults: Fault[] = [];
  const rows = new Map<string, ExportParameter>(EXPORT_PARAMETERS.map((row) => [row.key, row]));
  for (const [path, value] of Object.entries(given)) {
    if (value === undefined || (path === 'link' && typeof value === 'string')) continue;
    const row = rows.get(path);
    if (!row) faults.push({ path, found: foundText(value), allowed: [...rows.keys()].join(', ') });
    else if (!isAllowed(row, value)) faults.push({ path, found: foundText(value), allowed: allowedValues(row) });
  }
  if (faults.length > 0) return { faults };
  const known = Object.entries(given).filter(([, value]) => value !== undefined);
  return { options: { ...DEFAULT_EXPORT, ...Object.fromEntries(known) } };
}
