import type { WebGLRenderer, WebGLRenderTarget } from 'three';
import { STATE_TARGETS } from '../core/pack/layout.ts';
import { uses } from '../core/wind/push.ts';
import { BendTextures } from './bend-textures.ts';
import { PassState } from './pass-state.ts';
import { PoseReader } from './pose-reader.ts';
import type { Poser, ReadBack } from './poser.ts';
import { rendererName } from './renderer-name.ts';
import { bytesOfState, LEAN, SpringPass } from './spring-pass.ts';
import { checkpointsFor, isSoftware, sliceFor } from './state-budget.ts';
import { type Near, StateRun } from './state-run.ts';
import { STEP, stepsAt } from './step.ts';
import { type StepMaterials, stepMaterialsOf } from './step-materials.ts';
import { type IndexRange, TexelDraw } from './texel-draw.ts';
import { arrayTexture, type TreeTextures } from './tree-textures.ts';
import type { WindSource } from './wind-source.ts';

/** The set that even depths are in. */
const EVEN = 0;

/** The springs of a tree, and which steps of theirs are run. */
interface Springs {
  readonly pass: SpringPass;
  readonly run: StateRun;
  /** Steps that one update makes at most. */
  readonly slice: number;
}

/** What an update draws with. */
interface Update {
  readonly renderer: WebGLRenderer;
  readonly materials: StepMaterials;
  readonly time: number;
  readonly source: WindSource;
  /** null where no branch swings. */
  readonly springs: Springs | null;
}

/**
 * Poses a tree on the GPU: force, bend and pose of every piece in one fragment pass with four RGBA32F targets
 * (Skjermo 2007, section 5); where branches are springs, their states in a pass of their own before it.
 *
 * `exact`: depth by depth, each into the set that the other depths' parity leaves alone, so that a parent is always this
 * time's. `lagged`, the paper: all pieces at once, parents from the step before; a jump in time runs depth + 1 steps up to it,
 * after which nothing of the former pose is left, so that the pose is the same however that time was reached. A far jump of
 * springs takes some updates (`catchingUp`), and the pose stays meanwhile.
 */
export class WindPass implements Poser {
  readonly #textures: TreeTextures;
  readonly #targets: readonly [WebGLRenderTarget, WebGLRenderTarget];
  readonly #bend: BendTextures;
  readonly #draw: TexelDraw;
  readonly #state = new PassState();
  readonly #depths: number;
  readonly #reader: PoseReader;
  readonly #near: Near;
  #springs: Springs | null = null;
  #seeded = false;
  /** What the pose was computed for; NaN where nothing was. */
  #time = Number.NaN;
  #revision = Number.NaN;
  #mode: WindSource['pose'] | null = null;
  /** The step of the springs' state that the pose comes from, or the first of two. */
  #first = Number.NaN;
  /** The lagged pose: the set that holds it, and the number of its step. */
  #current = EVEN;
  #stepNumber = Number.NaN;
  #canvas: WebGLRenderer['domElement'] | null = null;
  #software = false;
  #settled = false;
  readonly #forget = () => {
    this.#seeded = false;
    this.#springs?.run.forget();
  };

  /**
   * `textures` must have targets, that is be made for a GPU that can draw into them; `near`: springs begin with the wind of the first
   * update's time, until `settle`.
   */
  constructor(textures: TreeTextures, near: Near = false) {
    this.#near = near;
    if (!textures.pose.targets) throw new Error('WindPass needs float targets; CpuPoser does without.');
    this.#textures = textures;
    this.#targets = textures.pose.targets;
    const { tree } = textures;
    this.#bend = new BendTextures(tree);
    this.#reader = new PoseReader(textures, this.#targets);
    this.#depths = tree.depthStart.length - 1;
    const ranges: IndexRange[] = Array.from({ length: this.#depths }, (_, d) => [
      tree.depthStart[d],
      tree.depthStart[d + 1],
    ]);
    // After the depths: all pieces, for springs, for the lagged pose, and to seed.
    this.#draw = new TexelDraw(tree.pieces.width, tree.pieces.height, [...ranges, [0, tree.pieceCount]]);
  }

  get catchingUp(): number | null {
    return this.#springs?.run.catchingUp ?? null;
  }

  get bytes(): number {
    return this.#bend.bytes + (this.#springs?.pass.bytes ?? 0);
  }

  settle(): void {
    if (!this.#near || this.#near === 'always' || this.#settled) return;
    this.#settled = true;
    this.#springs?.run.settle();
    this.#time = Number.NaN;
  }

  /** Poses the tree as of `time` seconds, or comes nearer to it. Changes no setting of `renderer`, though a source throws. */
  update(renderer: WebGLRenderer, time: number, source: WindSource): void {
    if (renderer.getContext().isContextLost()) return;
    this.#listen(renderer);
    const { pose, revision } = source;
    const same = this.#seeded && time === this.#time && revision === this.#revision && pose === this.#mode;
    if (same && this.catchingUp === null) return;
    this.#state.begin(renderer);
    try {
      if (!this.#pose(renderer, time, source)) return;
    } finally {
      this.#state.end(renderer);
    }
    this.#time = time;
    this.#revision = source.revision;
    this.#mode = pose;
  }

  /** The draws of an update; returns whether the tree is as of `time` now. */
  #pose(renderer: WebGLRenderer, time: number, source: WindSource): boolean {
    const materials = stepMaterialsOf(renderer);
    if (!this.#seeded) this.#seed(renderer, materials);
    materials.uniforms.pieces.value = this.#textures.pieces;
    materials.uniforms.log2Width.value = Math.log2(this.#textures.pieces.image.width);
    source.fill(time, materials.wind);
    const springs = uses(materials.wind, 'spring') ? this.#springsFor(renderer, materials, source) : null;
    if (!springs) this.#springs?.run.rest();
    const now: Update = { renderer, materials, time, source, springs };
    return source.pose === 'lagged' ? this.#lagged(now) : this.#exact(now);
  }

  read(renderer: WebGLRenderer, out = new Float32Array(this.#textures.tree.restPose.data.length)): Float32Array {
    return this.#reader.read(renderer, out);
  }

  readState(renderer: WebGLRenderer): Float32Array | null {
    const set = this.#shownState();
    return set && this.#reader.readState(renderer, set);
  }

  readBack(renderer: WebGLRenderer): Promise<ReadBack | null> {
    return this.#reader.readBack(renderer, this.#shownState());
  }

  readPiece(renderer: WebGLRenderer, piece: number): Promise<Float32Array | null> {
    return this.#reader.readPiece(renderer, piece);
  }

  dispose(): void {
    this.#canvas?.removeEventListener('webglcontextrestored', this.#forget);
    this.#springs?.pass.dispose();
    this.#springs = null;
    this.#bend.dispose();
    this.#draw.dispose();
  }

  /** A restored context gives targets without their contents: they are seeded again at the next update. */
  #listen(renderer: WebGLRenderer): void {
    if (this.#canvas === renderer.domElement) return;
    this.#canvas?.removeEventListener('webglcontextrestored', this.#forget);
    this.#canvas = renderer.domElement;
    this.#canvas.addEventListener('webglcontextrestored', this.#forget);
    this.#software = isSoftware(rendererName(renderer));
    this.#forget(); // another renderer has targets of its own
  }

  /** Rest pose into both sets: a root's place is read from the set that is not written. The texture goes again at once. */
  #seed(renderer: WebGLRenderer, { seed }: StepMaterials): void {
    const restPose = arrayTexture(this.#textures.tree.restPose, 'rest pose');
    seed.uniforms.restPose.value = restPose;
    for (const target of this.#targets) this.#draw.draw(renderer, target, seed, this.#depths);
    seed.uniforms.restPose.value = null;
    restPose.dispose();
    this.#seeded = true;
    this.#mode = null;
  }

  #springsFor(renderer: WebGLRenderer, materials: StepMaterials, source: WindSource): Springs {
    if (!this.#springs) {
      const { pieceCount, pieces } = this.#textures.tree;
      const pass = new SpringPass(this.#bend, this.#draw, this.#depths, pieces.width, pieces.height);
      const slice = sliceFor(pieceCount, this.#software);
      const kept = checkpointsFor(bytesOfState(pieces.width, pieces.height));
      this.#springs = { pass, run: new StateRun(pass, kept, slice, this.#settled ? false : this.#near), slice };
    }
    this.#springs.pass.use({ renderer, materials, source });
    return this.#springs;
  }

  #exact(now: Update): boolean {
    const { springs, time, source } = now;
    if (springs) {
      const { first, last, fraction } = stepsAt(time);
      this.#standIn(now, first);
      if (!springs.run.reach(first, last, source)) return false;
      this.#bindSprings(now, first, fraction);
    }
    this.#poseByDepth(now);
    return true;
  }

  #lagged(now: Update): boolean {
    const { springs, time, source } = now;
    const wanted = springs ? Math.max(0, Math.round(time / STEP)) : Math.round(time / STEP);
    // An edit while playing goes on from the pose there is; one while paused is shown as if it had always blown so.
    const ahead = wanted - this.#stepNumber;
    const follows = this.#mode === 'lagged' && ahead > 0 && ahead < this.#depths;
    // A piece of depth d looks back d steps, so the first of D + 1 steps may start from any pose.
    const from = follows ? this.#stepNumber + 1 : wanted - this.#depths + 1;
    if (springs) {
      const first = Math.max(0, from);
      this.#standIn(now, first);
      const visit = (step: number) => {
        this.#bindSprings(now, step, 0);
        // Before step 0 the springs were as they are then.
        for (let n = step === first ? from : first; n <= first; n++) this.#poseAtOnce(now, step);
      };
      if (!springs.run.reach(first, wanted, source, visit)) return false;
    } else {
      for (let step = from; step <= wanted; step++) this.#poseAtOnce(now, step);
    }
    this.#show(this.#current, this.#current);
    this.#stepNumber = wanted;
    return true;
  }

  /** Before there is any pose, and where the springs have a long way to run: the tree as if the wind of the moment had always blown. */
  #standIn(now: Update, step: number): void {
    const { springs } = now;
    if (!springs || this.#mode !== null || step <= springs.slice || !Number.isNaN(springs.run.latest)) return;
    springs.pass.begin(step);
    this.#bindSprings(now, step, 0);
    this.#poseByDepth(now);
    this.#mode = 'exact';
    this.#time = Number.NaN;
  }

  /** Points the pose at the states of a step and of the next, `fraction` of the way between them. */
  #bindSprings({ springs, materials }: Update, step: number, fraction: number): void {
    if (!springs) return;
    const { run, pass } = springs;
    const { uniforms } = materials;
    this.#first = step;
    const before = step < run.latest && run.has(step);
    const first = (before ? pass.previous : pass.latest).textures;
    const second = (before && fraction === 0 ? pass.previous : pass.latest).textures;
    uniforms.springQ.value[0] = first[STATE_TARGETS.Q];
    uniforms.springQ.value[1] = second[STATE_TARGETS.Q];
    uniforms.springLean.value[0] = first[LEAN];
    uniforms.springLean.value[1] = second[LEAN];
    uniforms.springFraction.value = fraction;
  }

  #poseByDepth(now: Update): void {
    this.#fill(now, now.time);
    for (let depth = 0; depth < this.#depths; depth++) this.#write(now, depth & 1, depth);
    this.#show(0, 1);
  }

  #poseAtOnce(now: Update, step: number): void {
    this.#fill(now, step * STEP);
    this.#current = 1 - this.#current;
    this.#write(now, this.#current, this.#depths);
  }

  #fill({ materials, source }: Update, time: number): void {
    const { wind, uniforms } = materials;
    source.fill(time, wind);
    materials.take();
    if (uses(wind, 'sway')) uniforms.sways.value = this.#bend.sways(wind);
  }

  /** Draws a range into a set, reading the other one. */
  #write({ renderer, materials }: Update, set: number, range: number): void {
    materials.uniforms.parentPose.value = this.#targets[1 - set].textures;
    this.#draw.draw(renderer, this.#targets[set], materials.material(renderer, 'pose'), range);
  }

  /** Points the deformer's uniforms at the sets that even and odd depths are in. */
  #show(even: number, odd: number): void {
    const { poseEven, poseOdd } = this.#textures.uniforms;
    for (let i = 0; i < poseEven.value.length; i++) {
      poseEven.value[i] = this.#targets[even].textures[i];
      poseOdd.value[i] = this.#targets[odd].textures[i];
    }
  }

  /** The set of the state that the pose comes from; null where no branch swings. */
  #shownState(): WebGLRenderTarget | null {
    if (!this.#springs || Number.isNaN(this.#springs.run.latest)) return null;
    const { run, pass } = this.#springs;
    return this.#first < run.latest && run.has(this.#first) ? pass.previous : pass.latest;
  }
}
