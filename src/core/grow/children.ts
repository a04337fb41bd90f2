import { taperRadius } from '../deform/radius.ts';
import type { Species } from '../species/species.ts';
import type { GrowthBudget } from './budget.ts';
import { GrowthBudgetError } from './budget.ts';
import { childPath, DRAW, draw, spread, streamOf } from './draws.ts';
import { readFrame, turnX, turnY, turnZ } from './frame.ts';
import { locate, Places } from './places.ts';
import type { LevelPlan } from './plan.ts';
import { RADIANS } from './plan.ts';
import { radiusChild } from './radius.ts';
import type { StemBuilder } from './stem-builder.ts';
import type { StemGrower } from './stem-grower.ts';
import { countOnDeeperStem, countOnMainBranch, deeperLength, downAngleAlong, mainBranchLength } from './stem-shape.ts';

/** Children that stem `i` and its clones bear together, before they are shared out; the trunk's count runs over its whole length. */
export function childrenOf(species: Species, stems: StemBuilder, i: number, branches: number): number {
  const family = stems.family[i];
  const parent = stems.parent[family];
  if (parent < 0) {
    // Row 5: 1Branches counts over the whole trunk, bare part included, unless the species wants all of them above it.
    return species.switches.branchesAboveBase ? branches / (1 - species.tree.baseSize) : branches;
  }
  const parentLength = stems.length[parent];
  return stems.level[i] === 1
    ? countOnMainBranch(branches, stems.length[family], parentLength, stems.relative[family])
    : countOnDeeperStem(branches, stems.parentZ[family] * parentLength, parentLength);
}

/** Grows the children of one stem after another (Weber & Penn 1995, 4.3 and 4.4). */
export class ChildGrower {
  private readonly species: Species;
  private readonly grower: StemGrower;
  private readonly budget: GrowthBudget;
  private readonly places = new Places();

  constructor(species: Species, grower: StemGrower, budget: GrowthBudget) {
    this.species = species;
    this.grower = grower;
    this.budget = budget;
  }

  /** Throws where the children of stems `from` to `to` would go over the budget: before a single one is grown. */
  foresee(plan: LevelPlan, from: number, to: number): void {
    const { stems } = this.grower;
    const branches = plan.parameters.branches;
    let asked = stems.count;
    for (let i = from; i < to; i++) {
      const all = stems.clone[i] ? 0 : childrenOf(this.species, stems, i, Math.abs(branches));
      asked +=
        branches < 0 ? Math.floor(-branches) : stems.level[i] === 0 ? all * (1 - this.species.tree.baseSize) : all;
    }
    if (asked > this.budget.stems) {
      const path = `levels[${Math.min(plan.level, 3)}].branches`;
      throw new GrowthBudgetError('stems', stems.count, asked, this.budget.stems, path, branches);
    }
  }

  /** Grows all children of stem (or clone) `i`, each with its clones. */
  bear(plan: LevelPlan, parentPlan: LevelPlan, i: number): void {
    const { stems } = this.grower;
    const { places } = this;
    const { branches } = plan.parameters;
    const stream = streamOf(stems.path[i]);
    if (branches < 0) {
      const n = Math.round(-branches);
      for (let k = 0; k < n; k++) this.child(plan, parentPlan, i, k, 1, n > 1 ? k / (n - 1) - 0.5 : 0);
      return;
    }
    const count = childrenOf(this.species, stems, i, branches);
    const low = stems.level[i] === 0 ? this.species.tree.baseSize : 0;
    places.spread(stems, i, low, count, stream, DRAW.place, DRAW.jitter);
    if (stems.clone[i] === 0) places.clear(stems.inside[i] / stems.length[i]);
    // Row 14: where a spiral starts is random; rows of alternate sides (row 15) begin on a random one.
    const begin = draw(stream, DRAW.spiral);
    let turned = begin * 2 * Math.PI;
    for (let k = 0; k < places.count; k++) {
      const path = childPath(stems.path[i], k);
      const step = plan.rotate + spread(streamOf(path), DRAW.rotate, plan.rotateV);
      if (plan.parameters.rotate >= 0) turned += step;
      else turned = (k % 2 === 0) === begin < 0.5 ? step : -step;
      this.child(plan, parentPlan, i, k, places.z[k], turned);
    }
  }

  /** Grows one child at z of its parent: turned about the parent's z, or in a fan (`turn` is then its place from -1/2 to 1/2). */
  private child(plan: LevelPlan, parentPlan: LevelPlan, i: number, k: number, z: number, turn: number): void {
    const { grower, species } = this;
    const { stems } = grower;
    const path = childPath(stems.path[i], k);
    const own = streamOf(path);
    const parentLength = stems.length[i];
    const offset = z * parentLength;
    const base = stems.level[i] === 0 ? species.tree.baseSize * parentLength : 0;
    // Row 4: the variation of the length is drawn once for each child.
    const relative = Math.max(0, plan.parameters.length + spread(own, DRAW.length, plan.parameters.lengthV));
    const { shape, crown } = species.tree;
    const length =
      plan.level === 1
        ? mainBranchLength(relative, parentLength, offset, base, shape, species.pruning, crown)
        : deeperLength(relative, parentLength, offset);

    const at = locate(stems, i, z);
    grower.x = at.x;
    grower.y = at.y;
    grower.z = at.z;
    const f = grower.frame;
    readFrame(f, stems.nodeFrame, 9 * at.node);
    if (plan.parameters.branches < 0) turnY(f, plan.rotate * turn);
    else turnZ(f, turn);
    const { downAngle, downAngleV } = plan.parameters;
    turnX(
      f,
      downAngleV < 0
        ? downAngleAlong(downAngle, downAngleV, parentLength, offset, base) * RADIANS
        : plan.downAngle + spread(own, DRAW.down, plan.downAngleV),
    );

    const first = grower.grow(plan, i, z, path, length);
    if (first < 0) return;
    // Row 20: the radius comes last, from the length that pruning has left.
    const limit = taperRadius(z, parentPlan.parameters.taper, stems.baseRadius[i], parentLength)[0];
    const radius = radiusChild(stems.baseRadius[i], stems.length[first], parentLength, species.tree.ratioPower, limit);
    for (let s = first; s < stems.count; s++) stems.baseRadius[s] = radius;
    stems.relative[first] = relative;
    stems.inside[first] = limit;
  }
}
