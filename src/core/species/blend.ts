import { isAllowed } from '../file/allowed.ts';
import type { NumberParameter } from '../file/parameter.ts';
import { crownCurve } from '../grow/crown-curve.ts';
import { shapeRatio } from '../grow/stem-shape.ts';
import { editSpecies, type ParameterPlace, type ParameterValue, PLACES, valueAt } from './edits.ts';
import { mixColours } from './oklab.ts';
import { clampTo } from './round-number.ts';
import type { LeafParameters, LevelParameters, Species } from './species.ts';
import { SIGN_IS_A_FLAG } from './widths.ts';

/** Directions about a stem, in degrees: from one to another the short way around. */
const TURNS: ReadonlySet<string> = new Set(['levels.rotate', 'leaves.rotate']);

/** Numbers that multiply each other: mixed as products are, so that no blend has more stems and leaves than both of its parents. */
const FACTORS: ReadonlySet<string> = new Set(['levels.branches', 'leaves.count', 'leaves.quality']);

/** Longest texts of a species file. */
const LONGEST = { name: 80, latin: 80, source: 400 } as const;

/** Number of a list of levels that a place of a deeper level reads. */
const listed = (species: Species, level: number): LevelParameters =>
  species.levels[Math.min(level, species.levels.length - 1)]!;

/**
 * The species `t` of the way (0..1) from `a` to `b`: at 0 it is `a`, at 1 it is `b`.
 *
 * Numbers are mixed, whole numbers rounded, turns go the short way around, counts are mixed as factors; shapes, choices, flags and what a negative
 * number means are those of `a` below 1/2 and those of `b` from there. Colours are mixed in OKLab. Levels are aligned by number; one that only one
 * of the two grows is that one's, with fewer stems the nearer the other is.
 */
export function blend(a: Species, b: Species, t: number): Species {
  if (t <= 0) return a;
  if (t >= 1) return b;
  const base = t < 0.5 ? a : b;
  const deepest = Math.max(a.levels.length, b.levels.length);
  const values: Record<string, ParameterValue> = {};
  for (const place of PLACES.values()) {
    if (place.level !== undefined && place.level >= deepest) continue;
    const value = mixed(a, b, t, place);
    if (value !== null) values[place.path] = value;
    else if (valueAt(base, place.path) !== null) values[place.path] = null;
  }
  const deeper = a.tree.levels > b.tree.levels ? a : b;
  values['leaves.count'] = leavesForTwigs(deeper === a ? 1 - t : t, deeper, values);
  const { facts: _, ...mix } = editSpecies(base, values);
  return {
    ...mix,
    name: blendName(a.name, b.name, t),
    latin: cut(a.latin && b.latin ? `${a.latin} × ${b.latin}` : a.latin || b.latin, LONGEST.latin),
    description: '',
    source: cut(`A blend of ${a.name} (${a.source}) and ${b.name} (${b.source})`, LONGEST.source),
  };
}

/** "Aspen × Oak 30 %": how much of the second is in it. */
export function blendName(a: string, b: string, t: number): string {
  const share = ` ${Math.round(100 * t)} %`;
  const room = LONGEST.name - share.length - 3;
  const [one, two] =
    a.length + b.length <= room ? [a, b] : [cut(a, Math.floor(room / 2)), cut(b, Math.floor(room / 2))];
  return `${one} × ${two}${share}`;
}

const cut = (text: string, longest: number): string =>
  text.length <= longest ? text : `${text.slice(0, longest - 1).trimEnd()}…`;

function mixed(a: Species, b: Species, t: number, place: ParameterPlace): ParameterValue {
  const { path, parameter, level } = place;
  if (path === 'tree.crown') return mixedCrown(a, b, t);
  const [from, to] = [found(a, b, path), found(b, a, path)];
  const nearer = t < 0.5 ? from : to;
  if (from === null || to === null) return nearer;
  switch (parameter.kind) {
    case 'colour':
      return mixColours(from as string, to as string, t);
    case 'numbers': {
      const [one, two] = [from as readonly number[], to as readonly number[]];
      const length = Math.max(one.length, two.length);
      return Array.from({ length }, (_, i) =>
        clampTo(parameter, line(one[Math.min(i, one.length - 1)]!, two[Math.min(i, two.length - 1)]!, t)),
      );
    }
    case 'number':
      if (parameter.names) return nearer;
      return mixedNumber(parameter, from as number, to as number, t, ownLevel(a, b, level));
    default:
      return nearer;
  }
}

/** Most numbers of a crown curve. */
const CROWN = 8;

/** A crown that only one of the two draws as a curve meets the other's shape as a curve. */
function mixedCrown(a: Species, b: Species, t: number): ParameterValue {
  const [one, two] = [a.tree.crown, b.tree.crown];
  if (!one && !two) return null;
  const length = one && two ? Math.max(one.length, two.length) : CROWN;
  const at = ({ tree, pruning }: Species, height: number): number =>
    tree.crown ? crownCurve(tree.crown, height) : shapeRatio(tree.shape, 1 - height, pruning);
  return Array.from({ length }, (_, i) => {
    const height = i / (length - 1);
    return Number(line(at(a, height), at(b, height), t).toFixed(3));
  });
}

const line = (from: number, to: number, t: number): number => from + t * (to - from);

/** Which of the two alone grows stems of this level: 'a', 'b', or undefined where both do or neither does. */
function ownLevel(a: Species, b: Species, level: number | undefined): 'a' | 'b' | undefined {
  if (level === undefined) return undefined;
  const [inA, inB] = [level < a.tree.levels, level < b.tree.levels];
  return inA === inB ? undefined : inA ? 'a' : 'b';
}

function mixedNumber(
  parameter: NumberParameter,
  from: number,
  to: number,
  t: number,
  only: 'a' | 'b' | undefined,
): number {
  const key = `${parameter.group}.${parameter.key}`;
  const nearer = t < 0.5 ? from : to;
  if (only) {
    const own = only === 'a' ? from : to;
    // No stems of a level are as one in the place of each.
    if (FACTORS.has(key) && own > 1) return clampTo(parameter, own ** (only === 'a' ? 1 - t : t));
    return own;
  }
  if (SIGN_IS_A_FLAG.has(key) && from < 0 !== to < 0) return nearer;
  if (FACTORS.has(key) && from * to > 0) {
    return clampTo(parameter, Math.sign(from) * Math.abs(from) ** (1 - t) * Math.abs(to) ** t);
  }
  if (TURNS.has(key) && from >= 0 && to >= 0) {
    const turn = line(from, from + shortWay(to - from), t);
    return clampTo(parameter, ((turn % 360) + 360) % 360);
  }
  return clampTo(parameter, line(from, to, t));
}

/** Degrees of a turn, -180..180. */
const shortWay = (degrees: number): number => degrees - 360 * Math.round(degrees / 360);

/**
 * The value at a path, or what holds in its place where the species leaves it out: the leaves' angles are then those of the level after the last.
 * null where both species leave it out and grow as many levels.
 */
function found(species: Species, other: Species, path: string): ParameterValue {
  const value = valueAt(species, path);
  if (value !== null) return value;
  const [group, key] = path.split('.');
  if (path === 'foliage.outline') return valueAt(other, path) === null ? null : species.leaves.shape;
  if (group !== 'leaves' || !PLACES.get(path)?.parameter.optional) return null;
  if (valueAt(other, path) === null && species.tree.levels === other.tree.levels) return null;
  const angle = listed(species, Math.min(species.tree.levels, 3))[key as keyof LevelParameters & keyof LeafParameters];
  return isAllowed(PLACES.get(path)!.parameter, angle) ? angle : null;
}

/** Leaves of a stem where the blend has not the twigs of the deeper parent: it bears what those would have borne. */
function leavesForTwigs(share: number, deeper: Species, values: Readonly<Record<string, ParameterValue>>): number {
  const place = PLACES.get('leaves.count')!;
  const count = values[place.path] as number;
  let twigs = 1;
  for (let level = values['tree.levels'] as number; level < deeper.tree.levels; level++) {
    twigs *= Math.max(1, listed(deeper, level).branches) ** share;
  }
  return count > 0 ? clampTo(place.parameter as NumberParameter, count * twigs) : count;
}
