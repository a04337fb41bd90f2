import type { Species } from '../species/species.ts';
import type { GrowthBudget } from './budget.ts';
import { BYTES, GrowthBudgetError } from './budget.ts';
import { DRAW, draw, spread, streamOf } from './draws.ts';
import { newFrame, readFrame, turnX, turnY, turnZ } from './frame.ts';
import { leafBend } from './leaf-bend.ts';
import { LeafBuilder } from './leaf-builder.ts';
import { locate, Places } from './places.ts';
import { parametersOf, RADIANS } from './plan.ts';
import type { StemBuilder } from './stem-builder.ts';
import { downAngleAlong, leavesCount } from './stem-shape.ts';

/** Grows the leaves of one stem after another (Weber & Penn 1995, 4.5 and 4.9). */
export class LeafGrower {
  readonly leaves = new LeafBuilder();
  private readonly species: Species;
  private readonly stems: StemBuilder;
  private readonly budget: GrowthBudget;
  private readonly quality: number;
  private readonly places = new Places();
  private readonly base = newFrame();
  private readonly frame = newFrame();
  private x = 0;
  private y = 0;
  /** The node whose frame `base` is. */
  private node = -1;
  private readonly downAngle: number;
  private readonly downAngleV: number;
  private readonly rotate: number;
  private readonly rotateV: number;

  constructor(species: Species, stems: StemBuilder, budget: GrowthBudget, quality: number) {
    this.species = species;
    this.stems = stems;
    this.budget = budget;
    this.quality = quality;
    // Row 42: the leaves' angles are those of level `levels`, at most 3, unless the species gives them their own.
    const p = parametersOf(species, species.tree.levels);
    const { leaves } = species;
    this.downAngle = leaves.downAngle ?? p.downAngle;
    this.downAngleV = leaves.downAngleV ?? p.downAngleV;
    this.rotate = (leaves.rotate ?? p.rotate) * RADIANS;
    this.rotateV = (leaves.rotateV ?? p.rotateV) * RADIANS;
  }

  /** Length of every blade in metres: LeafScale / sqrt(quality) (row 41). */
  get length(): number {
    return this.species.leaves.scale / Math.sqrt(this.quality);
  }

  /** Throws where the leaves of stems `from` to `to` would go over the budget, before a single one is grown; makes room for them else. */
  foresee(from: number, to: number): void {
    const { stems, budget } = this;
    const { count, quality } = this.species.leaves;
    let asked = 0;
    for (let i = from; i < to; i++) if (stems.clone[i] === 0 || count < 0) asked += Math.abs(this.leavesOf(i));
    const bytes = stems.count * BYTES.stem + stems.nodeCount * BYTES.node + asked * BYTES.leaf;
    const path = quality > 1 ? 'leaves.quality' : 'leaves.count';
    const value = quality > 1 ? quality : count;
    if (asked > budget.leaves) throw new GrowthBudgetError('leaves', 0, asked, budget.leaves, path, value);
    if (bytes > budget.bytes) throw new GrowthBudgetError('bytes', 0, bytes, budget.bytes, path, value);
    // A stem rounds its leaves, so that a few more than asked for may grow.
    this.leaves.reserve(Math.ceil(1.02 * asked));
  }

  /** Leaves on stem `i` and its clones together; negative for a fan, of which every tip has one. */
  private leavesOf(i: number): number {
    const { stems, species } = this;
    const { count } = species.leaves;
    if (count < 0) return -Math.round(-count * this.quality);
    const family = stems.family[i];
    const parent = stems.parent[family];
    // A trunk has no place on a parent; it bears its leaves as a stem at a tip would, none of them on the bare part.
    if (parent < 0) return count * this.quality;
    const parentLength = stems.length[parent];
    return leavesCount(count, stems.parentZ[family] * parentLength, parentLength, this.quality);
  }

  /** Grows the leaves of stem (or clone) `i`. */
  bear(i: number): void {
    const { stems, places } = this;
    const count = this.leavesOf(i);
    if (count < 0) {
      this.fan(i, -count);
      return;
    }
    const stream = streamOf(stems.path[i]);
    const trunk = stems.level[i] === 0;
    const low = trunk ? this.species.tree.baseSize : 0;
    places.spread(stems, i, low, count, stream, DRAW.leafPlace, DRAW.leafJitter);
    if (!trunk && stems.clone[i] === 0) places.clear(stems.inside[i] / stems.length[i]);
    const begin = draw(stream, DRAW.leafSpiral);
    const flat = this.species.leaves.flat ?? 0;
    let turned = begin * 2 * Math.PI;
    for (let k = 0; k < places.count; k++) {
      const z = places.z[k];
      const step = this.rotate + spread(stream, DRAW.leafRotate + k, this.rotateV);
      const even = (k % 2 === 0) === begin < 0.5;
      if (this.rotate >= 0) turned += step;
      else turned = even ? step : -step;
      this.place(i, z);
      turnZ(this.frame, flat > 0 ? towardsRow(turned, even ? 0 : Math.PI, flat) : turned);
      this.leaf(i, k, z, stream);
    }
  }

  /** Leaves in a fan at the tip, in the plane of the stem's z and x (row 43). */
  private fan(i: number, count: number): void {
    const stream = streamOf(this.stems.path[i]);
    for (let k = 0; k < count; k++) {
      this.place(i, 1);
      turnY(this.frame, count > 1 ? this.rotate * (k / (count - 1) - 0.5) : 0);
      this.leaf(i, k, 1, stream);
    }
  }

  /** Sets place and frame to those of stem `i` at z. */
  private place(i: number, z: number): void {
    const at = locate(this.stems, i, z);
    this.x = at.x;
    this.y = at.y;
    if (at.node !== this.node) {
      this.node = at.node;
      readFrame(this.base, this.stems.nodeFrame, 9 * at.node);
    }
    for (let n = 0; n < 9; n++) this.frame[n] = this.base[n];
  }

  /** Tilts the frame by the down angle, turns it to the light and keeps it. */
  private leaf(i: number, k: number, z: number, stream: number): void {
    const { stems, frame } = this;
    let down = this.downAngle;
    if (this.downAngleV < 0) {
      const length = stems.length[i];
      const base = stems.level[i] === 0 ? this.species.tree.baseSize * length : 0;
      down = downAngleAlong(down, this.downAngleV, length, z * length, base);
    } else {
      down += spread(stream, DRAW.leafDown + k, this.downAngleV);
    }
    turnX(frame, down * RADIANS);
    const flat = this.species.leaves.flat ?? 0;
    // The blade lies on edge in its row: about its midrib it turns into the plane, with the upper face up.
    if (flat > 0) turnZ(frame, (frame[2] >= 0 ? -flat : flat) * (Math.PI / 2));
    leafBend(frame, this.x, this.y, this.species.leaves.bend);
    this.leaves.add(i, z, frame, draw(stream, DRAW.leafPhase + k));
  }
}

/** The angle around a stem, in radians, that is the part `flat` of the way from `turned` to a row. */
function towardsRow(turned: number, row: number, flat: number): number {
  const away = turned - row;
  return row + (1 - flat) * (away - 2 * Math.PI * Math.floor(away / (2 * Math.PI) + 0.5));
}
