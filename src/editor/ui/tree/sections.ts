import { PLACES } from '../../../core/species/edits.ts';
import { MOST_LEVELS } from '../../../core/species/parameters.ts';

/** Sections of the panel, in the order in which one builds a tree; `level-0` is the trunk. */
export const SECTION_IDS = [
  'tree',
  'level-0',
  'level-1',
  'level-2',
  'level-3',
  'leaves',
  'pruning',
  'bark',
  'foliage',
  'organ',
  'spring',
  'autumn',
  'winter',
  'wind',
  'switches',
] as const;
export type SectionId = (typeof SECTION_IDS)[number];

/** A parameter, and beside it how much it varies. */
export interface Row {
  readonly path: string;
  /** Path of the variation, `levels.1.downAngleV`. */
  readonly variation?: string;
}

/** Names of the groups of rows; the words are in words/tree.ts. */
export type GroupId =
  | 'size'
  | 'crown'
  | 'thickness'
  | 'bulges'
  | 'trunks'
  | 'children'
  | 'place'
  | 'curve'
  | 'splits'
  | 'ridges'
  | 'foot'
  | 'amount'
  | 'blade'
  | 'stance'
  | 'envelope'
  | 'all';

export interface RowGroup {
  readonly group: GroupId;
  readonly rows: readonly Row[];
}

export interface Section {
  readonly id: SectionId;
  /** Of a section of stems. */
  readonly level?: number;
  readonly groups: readonly RowGroup[];
}

/** Keys of the groups, by section; what stands in none goes to the last one of its section. */
const GROUPS_OF: Readonly<Record<string, readonly (readonly [GroupId, readonly string[]])[]>> = {
  tree: [
    ['size', ['tree.scale', 'tree.zScale', 'tree.levels']],
    ['crown', ['tree.shape', 'tree.crown', 'tree.baseSize', 'tree.attractionUp']],
    ['thickness', ['tree.ratio', 'tree.ratioPower']],
    ['bulges', ['tree.bulges', 'tree.bulgeDepth']],
    ['trunks', ['tree.disc']],
  ],
  // The paper's sections: 4.3 how many and how long, 4.3 where they stand, 4.1 curve, 4.2 splits, 4.4 radius.
  levels: [
    ['children', ['branches', 'length']],
    ['place', ['downAngle', 'rotate']],
    ['curve', ['curve', 'curveBack', 'curveRes', 'curveSideV', 'helixTurns']],
    ['splits', ['baseSplits', 'segSplits', 'splitAngle']],
    ['thickness', ['taper', 'scale']],
    ['ridges', ['lobes', 'lobeDepth', 'tree.lobes', 'tree.lobeDepth']],
  ],
  leaves: [
    ['amount', ['leaves.count', 'leaves.quality']],
    ['blade', ['leaves.shape', 'leaves.scale', 'leaves.scaleX', 'leaves.petiole']],
    ['stance', ['leaves.bend', 'leaves.flat', 'leaves.downAngle', 'leaves.rotate']],
  ],
  pruning: [['envelope', ['pruning.ratio', 'pruning.width', 'pruning.widthPeak']]],
};

/** What the table keeps with the tree and one looks for at its trunk. */
const FOOT = ['tree.flare', 'tree.lobes', 'tree.lobeDepth'];

/** The path of the parameter of which this one is the variation: same name with a V, in the same part. */
const varied = (path: string): string | undefined => {
  const base = path.endsWith('V') ? path.slice(0, -1) : '';
  return PLACES.has(base) && PLACES.get(path)!.parameter.kind === 'number' ? base : undefined;
};

function sectionOf(path: string): SectionId {
  if (FOOT.includes(path)) return 'level-0';
  const { level, parameter } = PLACES.get(path)!;
  return level === undefined ? (parameter.group as SectionId) : (`level-${level}` as SectionId);
}

function groupsOf(id: SectionId, level: number | undefined): RowGroup[] {
  const own = [...PLACES.keys()].filter((path) => sectionOf(path) === id && varied(path) === undefined);
  const row = (path: string): Row => {
    const variation = `${path}V`;
    return PLACES.has(variation) && varied(variation) === path ? { path, variation } : { path };
  };
  const listed: (readonly [GroupId, readonly string[]])[] = [...(GROUPS_OF[level === undefined ? id : 'levels'] ?? [])];
  if (id === 'level-0') listed.push(['foot', ['tree.flare']]);
  if (listed.length === 0) return [{ group: 'all', rows: own.map(row) }];
  const named = listed.map(([group, keys]) => ({
    group,
    paths: keys.map((key) => (PLACES.has(key) ? key : `levels.${level}.${key}`)).filter((path) => own.includes(path)),
  }));
  const placed = new Set(named.flatMap((each) => each.paths));
  const left = own.filter((path) => !placed.has(path));
  if (left.length > 0) named.at(-1)!.paths.push(...left);
  return named.filter((each) => each.paths.length > 0).map(({ group, paths }) => ({ group, rows: paths.map(row) }));
}

/** All parameters of a species as the panel lists them: each path of PLACES once. */
export const SECTIONS: readonly Section[] = SECTION_IDS.map((id) => {
  const level = id.startsWith('level-') ? Number(id.slice(6)) : undefined;
  return { id, ...(level === undefined ? {} : { level }), groups: groupsOf(id, level) };
});

/** The section in which a path stands. */
export const sectionOfPath = (path: string): Section =>
  SECTIONS.find((s) => s.groups.some((g) => g.rows.some((r) => r.path === path || r.variation === path)))!;

/** The row in which a path stands, be it the value or the variation. */
export const rowOf = (path: string): Row =>
  sectionOfPath(path)
    .groups.flatMap((g) => g.rows)
    .find((r) => r.path === path || r.variation === path)!;

/** The paths of a row, of a section. */
export const pathsOfRow = (row: Row): readonly string[] => (row.variation ? [row.path, row.variation] : [row.path]);
export const pathsOfSection = (section: Section): readonly string[] =>
  section.groups.flatMap((g) => g.rows.flatMap(pathsOfRow));

/** A row of the table of levels: the same parameter at each level, undefined where a level has none. */
export interface LevelRow {
  readonly group: GroupId;
  readonly cells: readonly (Row | undefined)[];
}

/** The levels side by side: the rows of all, in the order of the panel. */
export const LEVEL_ROWS: readonly LevelRow[] = levelRows();

function levelRows(): LevelRow[] {
  const levels = SECTIONS.filter((s) => s.level !== undefined);
  const key = (row: Row): string => row.path.split('.').at(-1)!;
  const groups = new Map<GroupId, Set<string>>();
  // A level below the trunk has every group but the trunk's own.
  for (const section of [...levels.slice(1), ...levels.slice(0, 1)])
    for (const { group, rows } of section.groups) {
      const keys = groups.get(group) ?? new Set();
      for (const row of rows) keys.add(key(row));
      groups.set(group, keys);
    }
  return [...groups].flatMap(([group, keys]) =>
    [...keys].map((k) => ({
      group,
      cells: Array.from({ length: MOST_LEVELS }, (_, level) =>
        levels[level]!.groups.flatMap((g) => g.rows).find((row) => key(row) === k),
      ),
    })),
  );
}
