import { oneLine } from '../core/file/one-line.ts';
import { GrowthBudgetError } from '../core/grow/budget.ts';
import { NothingGrownError } from '../core/grow/nothing-grown.ts';
import type { TreeStats } from '../core/grow/stats.ts';
import { growPacked } from '../core/pack/grow-packed.ts';
import type { Species } from '../core/species/species.ts';
import { Failure } from './failure.ts';

/** A tree's figures, and how far its curves run beside its stems at most, by level, as a part of a stem's length. */
export interface Measured {
  readonly stats: TreeStats;
  readonly deviation: readonly number[];
}

/** Grows, fits and packs a tree, as the browser does, and counts it. */
export function measure(species: Species, seed: number): Measured {
  try {
    const { stats, pieces } = growPacked(species, seed, { now: () => performance.now() });
    return { stats, deviation: [...pieces.deviation] };
  } catch (error) {
    const foreseen = error instanceof GrowthBudgetError || error instanceof NothingGrownError;
    throw foreseen ? new Failure(error.message) : error;
  }
}

const digits = (value: number, places: number): string => value.toFixed(places);

/** The figures as a person reads them. */
export function statsText({ stats, deviation }: Measured): string {
  const heads = [
    'level',
    'stems',
    'clones',
    'segments',
    'pieces',
    'length, m: sum',
    'mean',
    'min',
    'max',
    'base radius, mm: mean',
    'min',
    'max',
    'declination, deg',
    'curve off stem, %',
  ];
  const rows = stats.levels.map((level) => [
    String(level.level),
    String(level.stems),
    String(level.clones),
    String(level.segments),
    String(level.pieces),
    digits(level.length.sum, 1),
    digits(level.length.mean, 3),
    digits(level.length.min, 3),
    digits(level.length.max, 3),
    digits(1000 * level.baseRadius.mean, 2),
    digits(1000 * level.baseRadius.min, 2),
    digits(1000 * level.baseRadius.max, 2),
    digits(level.declinationDeg.mean, 1),
    digits(100 * (deviation[level.level] ?? 0), 2),
  ]);
  const widths = heads.map((head, i) => Math.max(head.length, ...rows.map((row) => row[i].length)));
  const line = (cells: readonly string[]) => cells.map((cell, i) => cell.padStart(widths[i])).join('  ');
  return [
    `${oneLine(stats.species, 80)}, seed ${stats.seed}`,
    `height ${digits(stats.height, 2)} m, radius ${digits(stats.radius, 2)} m`,
    '',
    line(heads),
    ...rows.map(line),
    '',
    `${stats.leaves} leaves, ${stats.pieces} pieces up to ${stats.maxDepth} deep, ${stats.bytes} bytes on the GPU, ${digits(stats.milliseconds, 1)} ms`,
  ].join('\n');
}
