import { withReadings } from '../species/readings.ts';
import type { Species } from '../species/species.ts';
import type { GrowthBudget } from './budget.ts';
import { BYTES, DEFAULT_BUDGET, GrowthBudgetError, GrowthCancelled } from './budget.ts';
import { ChildGrower } from './children.ts';
import { DRAW, draw, spread, streamOf, trunkPath } from './draws.ts';
import { turnX, turnZ } from './frame.ts';
import { LeafGrower } from './leaves.ts';
import type { LevelPlan } from './plan.ts';
import { parametersOf, planLevel } from './plan.ts';
import { trunkRadius } from './radius.ts';
import { StemGrower } from './stem-grower.ts';
import { stretchStems } from './stretch.ts';
import type { Tree } from './tree.ts';
import { treeSize } from './tree-size.ts';

/** What has been grown so far. */
export interface GrowthCounts {
  readonly stems: number;
  readonly leaves: number;
}

export interface GrowOptions {
  /** Grow no more than this many levels; leaves grow only where all levels do. Default: all. */
  readonly levels?: number;
  /** Whether leaves grow. Default: true. */
  readonly leaves?: boolean;
  /** Factor on the species' own leaf quality, > 0: more and smaller leaves (row 41). Default: 1. */
  readonly quality?: number;
  /** Limits; what is not given is that of DEFAULT_BUDGET. */
  readonly budget?: Partial<GrowthBudget>;
  /** Told a few hundred times how far growing is, 0..1. */
  readonly onProgress?: (fraction: number, counts: GrowthCounts) => void;
  /** Asked as often; growing stops with GrowthCancelled where it says yes. */
  readonly shouldCancel?: () => boolean;
}

/** Stems between two reports of progress. */
const REPORT_EVERY = 512;

/** Turn between neighbouring trunks of a shrub: the golden angle fills a disc evenly. */
const GOLDEN_ANGLE = Math.PI * (3 - Math.sqrt(5));

/**
 * Grows the tree of a species and a seed (Weber & Penn 1995, section 4; the readings of weber-penn.md, section 2).
 *
 * The same species, seed and options give the same arrays bit for bit on every machine. Stems stand level by level, parents before children, each
 * stem directly before its clones. Throws GrowthBudgetError where the tree would go over the budget, GrowthCancelled where the caller stops it.
 */
export function grow(given: Species, seed: number, options: GrowOptions = {}): Tree {
  const species = withReadings(given);
  const budget = { ...DEFAULT_BUDGET, ...options.budget };
  const { tree } = species;
  const { scale, stretch } = treeSize(species, seed);
  const all = Math.max(1, Math.round(tree.levels));
  const levels = Math.max(1, Math.min(all, Math.floor(options.levels ?? all)));
  const plans = Array.from({ length: levels }, (_, level) => {
    const { curveRes } = parametersOf(species, level);
    const bytes = curveRes * BYTES.node;
    // Even one stem would be too much, and so would its list of turns.
    if (bytes > budget.bytes)
      throw new GrowthBudgetError('bytes', 0, bytes, budget.bytes, `levels[${Math.min(level, 3)}].curveRes`, curveRes);
    return planLevel(species, level);
  });

  const grower = new StemGrower(species, scale, budget);
  const { stems } = grower;
  growTrunks(species, seed, scale, plans[0], grower);

  const leafy = levels === all && options.leaves !== false && species.leaves.count !== 0;
  const leaves = new LeafGrower(species, stems, budget, species.leaves.quality * (options.quality ?? 1));
  const report = reporter(options, levels, leafy, () => ({ stems: stems.count, leaves: leaves.leaves.count }));

  const children = new ChildGrower(species, grower, budget);
  let from = 0;
  for (let level = 1; level < levels; level++) {
    const to = stems.count;
    children.foresee(plans[level], from, to);
    for (let i = from; i < to; i++) {
      if ((i - from) % REPORT_EVERY === 0) report(level, (i - from) / (to - from));
      children.bear(plans[level], plans[level - 1], i);
    }
    from = to;
  }

  if (leafy) {
    leaves.foresee(from, stems.count);
    for (let i = from; i < stems.count; i++) {
      if ((i - from) % REPORT_EVERY === 0) report(levels, (i - from) / (stems.count - from));
      leaves.bear(i);
    }
  }
  report(levels + 1, 0);

  const finished = stems.finish();
  if (stretch !== 1) stretchStems(finished, stretch);
  return { species, seed, scale, stems: finished, leaves: leaves.leaves.finish(leaves.length) };
}

/** Grows the trunk, or several spread over a disc and leaning out of it by 0DownAngle (row 52). */
function growTrunks(species: Species, seed: number, scale: number, plan: LevelPlan, grower: StemGrower): void {
  const { tree } = species;
  const p = plan.parameters;
  const trunks = Math.max(1, Math.round(Math.abs(p.branches)));
  const { stems } = grower;
  const begin = 2 * Math.PI * draw(streamOf(seed >>> 0), DRAW.disc);
  for (let i = 0; i < trunks; i++) {
    const path = trunkPath(seed, i);
    const own = streamOf(path);
    const azimuth = begin + i * GOLDEN_ANGLE;
    const out = trunks > 1 ? tree.disc * scale * Math.sqrt((i + 0.5) / trunks) : 0;
    grower.frame.set([1, 0, 0, 0, 1, 0, 0, 0, 1]);
    turnZ(grower.frame, azimuth + Math.PI / 2);
    // A frame leans towards its own -y, which now points outwards.
    grower.x = -out * grower.frame[3];
    grower.y = -out * grower.frame[4];
    grower.z = 0;
    turnX(grower.frame, plan.downAngle + spread(own, DRAW.down, plan.downAngleV));
    const relative = Math.max(0, p.length + spread(own, DRAW.length, p.lengthV));
    const first = grower.grow(plan, -1, 0, path, relative * scale);
    if (first < 0) continue;
    const radius = trunkRadius(stems.length[first], tree.ratio, p.scale + spread(own, DRAW.radius, p.scaleV));
    for (let s = first; s < stems.count; s++) {
      stems.baseRadius[s] = radius;
      stems.relative[s] = relative;
    }
  }
}

/** Tells of progress and asks whether to go on; each level counts four times as much as the one before. */
function reporter(
  options: GrowOptions,
  levels: number,
  leafy: boolean,
  counts: () => GrowthCounts,
): (stage: number, part: number) => void {
  const stages = leafy ? levels + 1 : levels;
  const before = (stage: number) => (1 << (2 * Math.min(stage, stages))) - 1;
  return (stage, part) => {
    if (options.shouldCancel?.()) throw new GrowthCancelled();
    const done = before(stage) + part * (before(stage + 1) - before(stage));
    options.onProgress?.(Math.min(done / before(stages), 1), counts());
  };
}
