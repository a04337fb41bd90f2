import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { grow } from '../../../src/core/grow/grow.ts';
import type { Tree } from '../../../src/core/grow/tree.ts';
import { parseSpecies } from '../../../src/core/species/parse.ts';
import type { LevelParameters, Species } from '../../../src/core/species/species.ts';

export const folder = join(import.meta.dirname, '../../../public/species');
export const names = ['quaking-aspen', 'black-tupelo', 'weeping-willow', 'california-black-oak'] as const;

export function shipped(name: (typeof names)[number]): Species {
  const { species, faults } = parseSpecies(readFileSync(join(folder, `${name}.json`), 'utf8'));
  if (faults) throw new Error(JSON.stringify(faults));
  return species;
}

export interface Edit {
  readonly tree?: Partial<Species['tree']>;
  readonly levels?: Readonly<Record<number, Partial<LevelParameters>>>;
  readonly leaves?: Partial<Species['leaves']>;
  readonly pruning?: Partial<Species['pruning']>;
  readonly switches?: Partial<Species['switches']>;
  readonly foliage?: Partial<Species['foliage']>;
  readonly organ?: Partial<Species['organ']>;
}

export const edit = (species: Species, changes: Edit): Species => ({
  ...species,
  tree: { ...species.tree, ...changes.tree },
  levels: species.levels.map((level, n) => ({ ...level, ...changes.levels?.[n] })),
  leaves: { ...species.leaves, ...changes.leaves },
  pruning: { ...species.pruning, ...changes.pruning },
  switches: { ...species.switches, ...changes.switches },
  foliage: { ...species.foliage, ...changes.foliage },
  organ: { ...species.organ, ...changes.organ },
});

/** The species without its random variation; negative variations are modes and stay. */
export function withoutVariation(species: Species): Species {
  const still = edit(species, { tree: { scaleV: 0, zScaleV: 0 } });
  return {
    ...still,
    levels: still.levels.map((p) => ({
      ...p,
      scaleV: 0,
      lengthV: 0,
      splitAngleV: 0,
      rotateV: 0,
      curveSideV: 0,
      curveV: Math.min(p.curveV, 0),
      downAngleV: Math.min(p.downAngleV, 0),
    })),
  };
}

/** A plain species to which a test adds what it is about: a straight trunk of 10 m, straight children, no leaves. */
export const plain: Species = edit(withoutVariation(shipped('quaking-aspen')), {
  tree: { shape: 3, baseSize: 0, scale: 10, levels: 1, flare: 0, lobeDepth: 0, attractionUp: 0 },
  levels: {
    0: { curveRes: 4 },
    1: { curveRes: 4, curve: 0, downAngle: 90, downAngleV: 0, rotate: 140, branches: 20, length: 0.3 },
    2: { curveRes: 4, curve: 0, downAngle: 45, downAngleV: 0, rotate: 140, branches: 10, length: 0.5 },
    3: { curveRes: 1, curve: 0, downAngle: 45, downAngleV: 0, rotate: 140, branches: 5, length: 0.5 },
  },
  leaves: { count: 0 },
});

/** Indices of the stems of a level, without clones. */
export function stemsOf({ stems }: Tree, level: number): number[] {
  const found: number[] = [];
  for (let i = 0; i < stems.count; i++) if (stems.level[i] === level && stems.clone[i] === 0) found.push(i);
  return found;
}

export const mean = (values: readonly number[]): number => values.reduce((a, b) => a + b, 0) / values.length;

/** Axis 0, 1 or 2 (x, y, z) of the frame at the k-th node of a stem. */
export function axisAt({ stems }: Tree, stem: number, node: number, axis: number): [number, number, number] {
  const at = 9 * (stems.nodeStart[stem] + node) + 3 * axis;
  return [stems.nodeFrame[at], stems.nodeFrame[at + 1], stems.nodeFrame[at + 2]];
}

export function nodeAt({ stems }: Tree, stem: number, node: number): [number, number, number] {
  const at = 3 * (stems.nodeStart[stem] + node);
  return [stems.nodePosition[at], stems.nodePosition[at + 1], stems.nodePosition[at + 2]];
}

export const nodesOf = ({ stems }: Tree, stem: number): number => stems.nodeStart[stem + 1] - stems.nodeStart[stem];

/** The angle between two vectors in degrees. */
export function angleDeg(a: readonly number[], b: readonly number[]): number {
  const dot = a.reduce((sum, value, i) => sum + value * b[i], 0);
  return (Math.acos(Math.min(Math.max(dot / Math.hypot(...a) / Math.hypot(...b), -1), 1)) * 180) / Math.PI;
}

/** The angle of a stem's first segment to the segment of its parent that it grows on, in degrees. */
export function downAngleOf(tree: Tree, stem: number): number {
  const { stems } = tree;
  const parent = stems.parent[stem];
  const segments = nodesOf(tree, parent) - 1;
  const at = (stems.parentZ[stem] - stems.zStart[parent]) / (1 - stems.zStart[parent]);
  const segment = Math.min(Math.floor(at * segments), segments - 1);
  return angleDeg(axisAt(tree, stem, 0, 2), axisAt(tree, parent, segment, 2));
}

/** Every tree of a list of seeds. */
export const trees = (species: Species, seeds: number, options?: Parameters<typeof grow>[2]): Tree[] =>
  Array.from({ length: seeds }, (_, seed) => grow(species, seed, options));
