import type { Species } from '../species/species.ts';
import { attractAsPrinted, attractUp, declinationOf } from './attraction.ts';
import type { GrowthBudget } from './budget.ts';
import { BYTES, GrowthBudgetError } from './budget.ts';
import { clonePath, DRAW, draw, spread, streamOf } from './draws.ts';
import type { Frame } from './frame.ts';
import { newFrame, turnAboutVertical, turnX, turnY, turnZ } from './frame.ts';
import type { LevelPlan } from './plan.ts';
import { RADIANS } from './plan.ts';
import type { Envelope } from './pruning.ts';
import { fittingPart } from './pruning.ts';
import { effectiveSplits, familySize, splitAngle, spreadAngleDeg } from './splits.ts';
import { StemBuilder } from './stem-builder.ts';

/** Where a stem or a clone begins, and what it brings along from its twin. */
interface Start {
  /** The stem that it grows on, or the twin of a clone. */
  parent: number;
  parentZ: number;
  clone: number;
  path: number;
  /** First segment: 0, later for a clone. */
  segment: number;
  readonly frame: Frame;
  x: number;
  y: number;
  z: number;
  /** Error of the diffusion of splits (row 29). */
  error: number;
  /** Turn a segment that leads back from the splits so far, and what the last one adds from the next segment on (row 34). */
  correction: number;
  pending: number;
  /** Share of the children of the stem (row 31). */
  share: number;
  /** Factor of nSegSplits (row 31). */
  propensity: number;
  /** Phase of a helix in radians. */
  phase: number;
}

const start = (): Start => ({
  parent: -1,
  parentZ: 0,
  clone: 0,
  path: 0,
  segment: 0,
  frame: newFrame(),
  x: 0,
  y: 0,
  z: 0,
  error: 0,
  correction: 0,
  pending: 0,
  share: 1,
  propensity: 1,
  phase: 0,
});

/** Grows one stem after another, each with its clones, into a `StemBuilder`. */
export class StemGrower {
  readonly stems = new StemBuilder();
  /** Frame and place of the next stem; the caller sets them before `grow`. */
  readonly frame: Frame = newFrame();
  x = 0;
  y = 0;
  z = 0;

  private readonly species: Species;
  private readonly budget: GrowthBudget;
  private readonly envelope: Envelope;
  /** Stems shorter than this are not made (row 11). */
  private readonly least: number;
  private readonly root = start();
  private readonly work = newFrame();
  private readonly helix = newFrame();
  private readonly waiting: Start[] = [];

  constructor(species: Species, scale: number, budget: GrowthBudget) {
    this.species = species;
    this.budget = budget;
    this.least = 1e-4 * scale;
    this.envelope = {
      ...species.pruning,
      scale,
      baseSize: species.tree.baseSize,
      pruneBase: species.switches.pruneBase,
    };
  }

  /**
   * Grows a stem of `length` metres with its clones and prunes it; returns its index, or -1 where it is too short to be made.
   * Its clones follow it directly.
   */
  grow(plan: LevelPlan, parent: number, parentZ: number, path: number, length: number): number {
    if (!(length >= this.least)) return -1;
    const { stems, root } = this;
    const first = stems.count;
    const firstNode = stems.nodeCount;
    const stream = streamOf(path);
    root.parent = parent;
    root.parentZ = parentZ;
    root.path = path;
    root.frame.set(this.frame);
    root.x = this.x;
    root.y = this.y;
    root.z = this.z;
    root.correction = 0;
    root.pending = 0;
    root.share = 1;
    root.propensity = 1;
    // Every stem starts with an error of its own in place of the paper's one for a level, so that the splits of a level spread over all its
    // stems and yet no stem depends on another. The trunk starts with the printed 0.
    root.error = plan.level > 0 && plan.parameters.segSplits > 0 ? draw(stream, DRAW.splits) - 0.5 : 0;
    root.phase = plan.helix > 0 ? 2 * Math.PI * draw(stream, DRAW.helix) : 0;
    this.foresee(plan, root.error);
    this.strand(plan, root, length, first);
    for (let i = 0; i < this.waiting.length; i++) this.strand(plan, this.waiting[i], length, first);
    this.waiting.length = 0;

    const ratio = this.species.pruning.ratio;
    if (plan.level > 0 && ratio > 0) {
      const part = fittingPart(stems.nodePosition, firstNode, stems.nodeCount, this.envelope);
      if (part < 1 && !this.shorten(first, firstNode, length, 1 - ratio + ratio * part)) return -1;
    }
    return first;
  }

  /** Scales a grown stem and its clones about its base (4.6, row 49); false where nothing worth keeping is left. */
  private shorten(first: number, firstNode: number, length: number, part: number): boolean {
    const { stems } = this;
    if (length * part < this.least) {
      stems.truncate(first);
      return false;
    }
    for (let i = first; i < stems.count; i++) stems.length[i] = length * part;
    const nodes = stems.nodePosition;
    for (let axis = 0; axis < 3; axis++) {
      const base = nodes[3 * firstNode + axis];
      for (let n = 3 * firstNode + axis; n < 3 * stems.nodeCount; n += 3) nodes[n] = base + part * (nodes[n] - base);
    }
    return true;
  }

  /** Grows one stem or clone from its start to its tip and puts the clones that leave it on the waiting list. */
  private strand(plan: LevelPlan, s: Start, length: number, first: number): void {
    const { stems, work } = this;
    const { segments, steps } = plan;
    const count = (segments - s.segment) * steps + 1;
    this.check(plan, count);
    const index = stems.add(count);
    stems.level[index] = plan.level;
    stems.parent[index] = s.parent;
    stems.parentZ[index] = s.parentZ;
    stems.clone[index] = s.clone;
    stems.length[index] = length;
    stems.zStart[index] = s.segment / segments;
    stems.path[index] = s.path;
    stems.family[index] = first;

    const stream = streamOf(s.path);
    const step = length / (segments * steps);
    let node = stems.nodeStart[index];
    work.set(s.frame);
    for (let i = s.segment; i < segments; i++) {
      if (i > 0) this.turn(plan, s, work, stream, i);
      const drawn = plan.helix > 0 ? this.helix : work;
      for (let j = 0; j < steps; j++) {
        if (plan.helix > 0) this.wind(plan, work, s.phase + plan.helixStep * (i * steps + j));
        stems.writeNode(node++, s.x, s.y, s.z, drawn, s.share);
        s.x += step * drawn[6];
        s.y += step * drawn[7];
        s.z += step * drawn[8];
      }
      if (i < segments - 1) this.split(plan, s, work, stream, index, i);
    }
    stems.writeNode(node, s.x, s.y, s.z, plan.helix > 0 ? this.helix : work, s.share);
  }

  /** Turns the frame from one segment to the next: curve (4.1), return from splits (4.2), attraction (4.8). */
  private turn(plan: LevelPlan, s: Start, f: Frame, stream: number, i: number): void {
    turnX(f, plan.deltas[i] + spread(stream, DRAW.curve + i, plan.curveV) - s.correction);
    s.correction += s.pending;
    s.pending = 0;
    if (plan.sideV !== 0) turnY(f, spread(stream, DRAW.side + i, plan.sideV));
    if (plan.attraction === 0) return;
    if (this.species.switches.paperAttraction) attractAsPrinted(f, plan.attraction, plan.segments);
    else attractUp(f, plan.attraction, plan.segments - i, 2 * Math.PI * draw(stream, DRAW.azimuth));
  }

  /** The frame of a step of a helix: tilted from the stem's axis towards an azimuth that goes round (row 28). */
  private wind(plan: LevelPlan, axis: Frame, azimuth: number): void {
    this.helix.set(axis);
    turnZ(this.helix, azimuth);
    turnX(this.helix, plan.helix);
    turnZ(this.helix, -azimuth);
  }

  /** Lets clones leave at the end of segment i and turns the stem itself away (4.2; rows 29 to 37). */
  private split(plan: LevelPlan, s: Start, f: Frame, stream: number, index: number, i: number): void {
    const p = plan.parameters;
    const atBase = plan.level === 0 && i === 0 && p.baseSplits > 0;
    let clones = Math.round(p.baseSplits);
    if (!atBase) {
      if (p.segSplits === 0) return;
      const rate = p.segSplits * s.propensity;
      clones = effectiveSplits(rate, s.error);
      s.error -= clones - rate;
    }
    if (clones === 0) return;
    const declination = declinationOf(f);
    const left = plan.segments - 1 - i;
    s.share /= clones + 1;
    if (this.species.switches.halveCloning) s.propensity *= 0.5;
    for (let j = 0; j < clones; j++) {
      const path = clonePath(s.path, i, j);
      const own = streamOf(path);
      const angle = splitAngle(plan.splitAngle + spread(own, DRAW.split + i, plan.splitAngleV), declination);
      const clone: Start = {
        ...s,
        parent: index,
        parentZ: (i + 1) / plan.segments,
        clone: 1,
        path,
        segment: i + 1,
        frame: f.slice(),
        // Like every correction, it counts all segments that are left and spares the one that begins with the split.
        pending: angle / left,
      };
      turnX(clone.frame, angle);
      turnAboutVertical(clone.frame, this.divergence(own, i, j, clones, atBase, declination));
      this.waiting.push(clone);
    }
    const angle = splitAngle(plan.splitAngle + spread(stream, DRAW.split + i, plan.splitAngleV), declination);
    turnX(f, angle);
    s.pending = angle / left;
  }

  /** How far a clone turns about the vertical through the split, in radians: rows 32, 35 and 37. */
  private divergence(own: number, i: number, j: number, clones: number, atBase: boolean, declination: number): number {
    if (clones === 1 && !atBase) {
      const random = draw(own, DRAW.spread + i);
      const degrees = spreadAngleDeg(declination / RADIANS, random, this.species.switches.spread);
      return (draw(own, DRAW.azimuth + 1 + i) < 0.5 ? -1 : 1) * degrees * RADIANS;
    }
    const gap = (2 * Math.PI) / (clones + 1);
    return (j + 1) * gap + spread(own, DRAW.spread + i, gap / 4);
  }

  /** Throws where the clones of a stem with this error of splits would go over the budget: before one is grown. */
  private foresee(plan: LevelPlan, error: number): void {
    const { segSplits } = plan.parameters;
    const baseSplits = plan.level === 0 ? Math.round(plan.parameters.baseSplits) : 0;
    if (segSplits === 0 && baseSplits === 0) return;
    const halving = this.species.switches.halveCloning;
    const size = familySize(segSplits, error, plan.segments, baseSplits > 0 ? baseSplits : -1, halving);
    const asked = this.stems.count + size;
    const key = segSplits > 0 ? 'segSplits' : 'baseSplits';
    if (asked > this.budget.stems) this.refuse(plan, 'stems', this.stems.count, asked, key);
  }

  /** Throws where the next stem, of this many nodes, would go over the budget. */
  private check(plan: LevelPlan, nodes: number): void {
    const { stems, budget } = this;
    const asked = stems.count + 1;
    const bytes = asked * BYTES.stem + (stems.nodeCount + nodes) * BYTES.node;
    if (asked > budget.stems) this.refuse(plan, 'stems', stems.count, asked);
    if (bytes > budget.bytes)
      this.refuse(plan, 'bytes', stems.count * BYTES.stem + stems.nodeCount * BYTES.node, bytes);
  }

  private refuse(
    plan: LevelPlan,
    what: 'stems' | 'bytes',
    count: number,
    asked: number,
    // The likely culprit.
    key: 'segSplits' | 'baseSplits' | 'curveRes' | 'branches' = plan.segments > 100 ? 'curveRes' : 'branches',
  ): never {
    const path = `levels[${Math.min(plan.level, 3)}].${key}`;
    throw new GrowthBudgetError(what, count, asked, this.budget[what], path, plan.parameters[key]);
  }
}
