import { type Camera, Frustum, Matrix4, type Object3D, Vector3, type WebGLRenderer } from 'three';
import { NEVER } from '../../core/forest/fade.ts';
import type { Wind } from '../../core/wind/wind.ts';
import { type GroveClient, type GroveForm, isAborted } from '../../worker/grove-client.ts';
import type { ForestStep } from './budget.ts';
import { distanceToCell } from './cells.ts';
import { bandOf, isWanted, type Thresholds } from './classes.ts';
import { variantSeed } from './forest-plan.ts';
import { type ForestSetup, variantOf } from './forest-setup.ts';
import { Grove, type GroveOptions } from './grove.ts';
import { GroveUnit, type Part } from './grove-unit.ts';
import { Stream, type Wish } from './stream.ts';
import { TRIES } from './tree-shapes.ts';
import type { CellView } from './view-cells.ts';

/** What a frame asks of the groves. */
export interface GroveFrame {
  readonly renderer: WebGLRenderer;
  readonly camera: Camera;
  /** Of the clock, seconds; and of the page, milliseconds. */
  readonly time: number;
  readonly passed: number;
  readonly view: CellView;
  readonly thresholds: Thresholds;
  readonly step: ForestStep;
  readonly memoryBudget: number;
  readonly wind: Wind;
}

/** What becomes of trees in the coarsest class: `taken`, 0..1, is the part of each that a finer class has. */
export type Taken = (ranks: readonly number[], taken: number) => void;

/** Milliseconds in which a grove fades in. */
const FADE = 400;
/** Groves made and uploaded a frame at most, and milliseconds after which no other begins. */
const UPLOADS = 2;
const SLICE = 5;
/** Bytes of a tree on the GPU before one of its species has been seen. */
const GUESS: Readonly<Record<GroveForm, number>> = { full: 2.5e6, middle: 1.5e5 };
/** Metres outside of the picture from which shadows fall into it. */
const SHADOW_REACH = 30;

const matrix = new Matrix4();

/** The near and middle trees of a forest: grown in the worker as they are wanted, faded in, moved, and freed when memory asks for it. */
export class ForestGroves {
  readonly #parent: Object3D;
  readonly #client: GroveClient;
  readonly #taken: Taken;
  readonly #options: (form: GroveForm, species: number) => GroveOptions | null;
  readonly #failed: (error: unknown) => void;
  readonly #stream = new Stream();
  readonly #units = new Map<string, GroveUnit>();
  readonly #perTree: Record<GroveForm, Map<number, number>> = { full: new Map(), middle: new Map() };
  readonly #frustum = new Frustum();
  readonly #eye = new Vector3();
  #setup: ForestSetup | null = null;
  #arrived: { unit: GroveUnit; part: Part }[] = [];
  #wind: Wind | null = null;
  #frame = 0;
  #fading = false;
  /** Factor on the time in which groves fade in where they are seen, and on the band of sizes over which classes go over; 0: at once. */
  fade = 1;
  /** Is there a middle class? Without one near trees stand out of far ones. Set before the forest. */
  middle = true;

  /** `options`: how groves of a form are drawn; null while that cannot be said yet: they wait; `failed` is told why one cannot be grown. */
  constructor(
    parent: Object3D,
    client: GroveClient,
    taken: Taken,
    options: (form: GroveForm, species: number) => GroveOptions | null,
    failed: (error: unknown) => void,
  ) {
    this.#parent = parent;
    this.#client = client;
    this.#taken = taken;
    this.#options = options;
    this.#failed = failed;
  }

  /** Takes another forest; all groves of the last one go. */
  setForest(setup: ForestSetup | null): void {
    this.clear();
    // Another mix has other species in their places.
    for (const bytes of Object.values(this.#perTree)) bytes.clear();
    this.#setup = setup;
    if (!setup) return;
    const { near, middle } = setup;
    const parents = new Map<number, GroveUnit>();
    for (const cell of this.middle ? middle.cells : []) {
      const unit = new GroveUnit('middle', cell, null);
      parents.set(cell.index, unit);
      this.#units.set(unit.key, unit);
    }
    const ratio = near.columns / middle.columns;
    for (const cell of near.cells) {
      const column = Math.floor((cell.index % near.columns) / ratio);
      const row = Math.floor(Math.floor(cell.index / near.columns) / ratio);
      const unit = new GroveUnit('full', cell, parents.get(row * middle.columns + column) ?? null);
      this.#units.set(unit.key, unit);
    }
  }

  /** Does all that one frame asks: what is wanted, what has come, what fades, what moves. */
  update(frame: GroveFrame): void {
    const setup = this.#setup;
    if (!setup) return;
    this.#frame++;
    this.#look(frame);
    this.#plan(frame, setup);
    this.#upload(frame, setup);
    this.#fadeAll(frame);
    this.#move(frame);
  }

  /** Is nothing grown, waiting or fading? */
  get settled(): boolean {
    return this.#stream.growing === 0 && this.#arrived.length === 0 && !this.#fading;
  }

  stats() {
    const sum = { near: 0, middle: 0, groves: 0, growing: this.#stream.growing, triangles: 0, drawCalls: 0, bytes: 0 };
    for (const unit of this.#units.values()) {
      if (unit.state !== 'there') continue;
      sum.bytes += unit.bytes;
      for (const { grove } of unit.parts) {
        sum.groves++;
        if (!grove?.visible || !unit.inView) continue;
        const { triangles, drawCalls } = grove.stats();
        sum.triangles += triangles;
        sum.drawCalls += drawCalls;
      }
      if (unit.come <= 0 || !unit.inView || !unit.wanted) continue;
      sum[unit.form === 'full' ? 'near' : 'middle'] += unit.cell.count;
      if (unit.form === 'full') sum.middle -= unit.cell.count;
    }
    sum.middle = Math.max(0, sum.middle);
    return sum;
  }

  /** Frees all groves. */
  clear(): void {
    for (const unit of this.#units.values()) unit.drop();
    this.#units.clear();
    this.#arrived = [];
    this.#stream.clear();
    this.#fading = false;
  }

  /** How large each cell is on screen, and whether it is wanted. */
  #look({ view, thresholds }: GroveFrame): void {
    const [x, y, z] = view.eye;
    for (const unit of this.#units.values()) {
      const { cell, form, parent, side } = unit;
      // A finer form comes after the coarser one, so that two classes and no more share any tree out; most of a forest ends here.
      if (parent && parent.state !== 'there') {
        unit.wanted = false;
        continue;
      }
      const threshold = form === 'full' ? thresholds.near : thresholds.middle;
      unit.pixels = (cell.tallest * view.scale) / Math.max(1, distanceToCell(cell, side, x, y, z));
      const ready = !parent || parent.come >= 1;
      unit.wanted = unit.failures < TRIES && ready && isWanted(unit.pixels, threshold, unit.wanted);
      if (unit.wanted || unit.state === 'there') unit.inView = view.sees(cell, side, 0);
    }
  }

  #plan({ thresholds, memoryBudget }: GroveFrame, setup: ForestSetup): void {
    const wishes: Wish[] = [];
    for (const unit of this.#units.values()) {
      if (!unit.wanted) continue;
      if (unit.state === 'none' && !this.#drawable(unit)) continue;
      const threshold = unit.form === 'full' ? thresholds.near : thresholds.middle;
      wishes.push({
        key: unit.key,
        inView: unit.inView,
        urgency: unit.pixels / threshold,
        bytes: this.#guess(unit),
      });
    }
    const { grow, cancel, drop } = this.#stream.plan(wishes, memoryBudget);
    for (const key of [...cancel, ...drop]) {
      const unit = this.#units.get(key);
      if (unit) this.#drop(unit);
    }
    for (const key of grow) {
      const unit = this.#units.get(key);
      if (unit) this.#grow(unit, setup);
    }
  }

  /** A unit goes, and with a middle one what was drawn in its stead. */
  #drop(unit: GroveUnit): void {
    for (const child of unit.children) {
      if (child.state === 'none') continue;
      this.#stream.failed(child.key);
      this.#drop(child);
    }
    this.#arrived = this.#arrived.filter((each) => each.unit !== unit);
    unit.drop();
    this.#tell(unit);
  }

  #drawable(unit: GroveUnit): boolean {
    for (const species of unit.cell.bySpecies.keys()) if (!this.#options(unit.form, species)) return false;
    return true;
  }

  #guess({ cell, form }: GroveUnit): number {
    let bytes = 0;
    for (const [species, ranks] of cell.bySpecies) {
      bytes += ranks.length * (this.#perTree[form].get(species) ?? GUESS[form]);
    }
    return bytes;
  }

  #grow(unit: GroveUnit, setup: ForestSetup): void {
    const { document, mix, places, feet } = setup;
    unit.begin();
    for (const part of unit.parts) {
      const species = mix[part.species];
      if (!species) continue;
      const members = part.ranks.map((i) => ({
        seed: variantSeed(document, part.species, variantOf(setup, i)),
        x: (places.x[i] as number) - unit.cell.x,
        y: (places.y[i] as number) - unit.cell.y,
        z: (feet[i] as number) - unit.cell.low,
        turn: places.turn[i] as number,
        // Trees of one shape do not swing in unison.
        phase: ((i * 0.618034) % 1) + (i % 7) / 7,
      }));
      const ticket = this.#client.grow({ species, members, form: unit.form }, -unit.pixels);
      part.ticket = ticket;
      ticket.done.then(
        (grown) => {
          if (part.ticket !== ticket || !unit.parts.includes(part)) return;
          part.ticket = null;
          part.grown = grown;
          this.#arrived.push({ unit, part });
        },
        (error: unknown) => {
          if (!isAborted(error) && unit.parts.includes(part)) this.#giveUp(unit, error);
        },
      );
    }
  }

  /** Growing a unit came to nothing: it is tried again, and told of where that was in vain, too. */
  #giveUp(unit: GroveUnit, error: unknown): void {
    unit.failures++;
    this.#stream.failed(unit.key);
    this.#drop(unit);
    if (unit.failures >= TRIES) this.#failed(error);
  }

  /** Makes groves of what has come, as many as the frame has time for. */
  #upload(frame: GroveFrame, setup: ForestSetup): void {
    const began = performance.now();
    this.#arrived.sort((a, b) => Number(b.unit.inView) - Number(a.unit.inView) || b.unit.pixels - a.unit.pixels);
    for (let i = 0; i < UPLOADS && this.#arrived.length > 0; i++) {
      if (i > 0 && performance.now() - began > SLICE) return;
      const { unit, part } = this.#arrived.shift() as { unit: GroveUnit; part: Part };
      try {
        this.#make(unit, part, frame, setup);
      } catch (error) {
        this.#giveUp(unit, error);
      }
    }
  }

  /** Makes the grove of a part that has been grown. */
  #make(unit: GroveUnit, part: Part, frame: GroveFrame, setup: ForestSetup): void {
    const species = setup.mix[part.species];
    const options = this.#options(unit.form, part.species);
    if (!part.grown || !species || !options) return;
    const grove = new Grove(options);
    part.grove = grove;
    grove.position.set(unit.cell.x, unit.cell.low, -unit.cell.y);
    grove.setWind(frame.wind);
    grove.setGrove(part.grown.packed, species, part.grown.light);
    for (let k = 0; k < part.ranks.length; k++) grove.share(k, 0, 0);
    part.grown = null;
    grove.visible = false;
    this.#parent.add(grove);
    this.#pose(grove, frame);
    this.#perTree[unit.form].set(part.species, grove.stats().bytes / part.ranks.length);
    if (!unit.parts.every((each) => each.grove)) return;
    unit.state = 'there';
    this.#stream.arrived(unit.key, unit.bytes);
  }

  /** Lets what is there come, and tells the coarser classes of it. */
  #fadeAll({ passed, thresholds }: GroveFrame): void {
    this.#fading = false;
    for (const unit of this.#units.values()) {
      if (unit.state !== 'there' || unit.come >= 1) continue;
      const [from] = bandOf(unit.form === 'full' ? thresholds.near : thresholds.middle);
      // Nothing of it shows yet: it may be there at once.
      const hidden = unit.pixels < from || !unit.inView || this.fade <= 0;
      unit.come = hidden ? 1 : Math.min(1, unit.come + passed / (FADE * this.fade));
      this.#tell(unit);
      // In the frame in which it has come, too: what waited for it is asked for in the next.
      this.#fading = true;
    }
  }

  /** Hands the share of a unit on: to its own trees, and to those of the class that they leave. */
  #tell(unit: GroveUnit): void {
    const { come, parts, form, parent } = unit;
    if (form === 'middle') {
      for (const { ranks } of parts) this.#taken(ranks, come);
      if (parts.length === 0) for (const ranks of unit.cell.bySpecies.values()) this.#taken(ranks, 0);
      const near = new Map<number, number>();
      for (const child of unit.children) {
        if (child.come <= 0) continue;
        for (const ranks of child.cell.bySpecies.values()) for (const rank of ranks) near.set(rank, child.come);
      }
      for (const { grove, ranks } of parts) {
        ranks.forEach((rank, i) => {
          grove?.share(i, come, near.get(rank) ?? 0);
        });
      }
      return;
    }
    for (const { grove, ranks } of parts) {
      for (let i = 0; i < ranks.length; i++) grove?.share(i, come, 0);
    }
    if (parent?.state === 'there') this.#tell(parent);
    if (parent) return;
    for (const ranks of unit.cell.bySpecies.values()) this.#taken(ranks, come);
  }

  /** Moves what is drawn. */
  #move(frame: GroveFrame): void {
    const { thresholds, wind, view } = frame;
    const blown = wind !== this.#wind;
    this.#wind = wind;
    const [nearFrom, nearTo] = bandOf(thresholds.near, this.fade);
    const [middleFrom, middleTo] = bandOf(thresholds.middle, this.fade);
    for (const unit of this.#units.values()) {
      // Also what is there of a unit whose other species are still growing.
      if (blown) for (const { grove } of unit.parts) grove?.setWind(wind, { fade: 1 });
      if (unit.state !== 'there') continue;
      const shown = unit.come > 0 && unit.pixels > (unit.form === 'full' ? nearFrom : middleFrom);
      const close = shown && (unit.inView || view.sees(unit.cell, unit.side, SHADOW_REACH));
      for (const { grove } of unit.parts) {
        if (!grove) continue;
        grove.visible = close;
        if (unit.form === 'full') grove.fade.set(nearFrom, nearTo, NEVER, NEVER);
        else grove.fade.set(middleFrom, middleTo, nearFrom, nearTo);
        grove.slack = frame.step.motion;
        if (close) this.#pose(grove, frame);
      }
    }
  }

  #pose(grove: Grove, { camera, renderer, time, view }: GroveFrame): void {
    this.#frustum.setFromProjectionMatrix(matrix.multiplyMatrices(camera.projectionMatrix, camera.matrixWorldInverse));
    this.#eye.setFromMatrixPosition(camera.matrixWorld);
    grove.update(renderer, time, { eye: this.#eye, scale: view.scale, frame: this.#frame, frustum: this.#frustum });
  }
}
