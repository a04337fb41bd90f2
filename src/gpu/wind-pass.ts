import type { WebGLRenderer, WebGLRenderTarget } from 'three';
import { POSE_TARGETS, TEXEL } from '../core/pack/layout.ts';
import { PassState } from './pass-state.ts';
import type { Poser } from './poser.ts';
import { type StepMaterials, stepMaterialsOf } from './step-materials.ts';
import { type IndexRange, TexelDraw } from './texel-draw.ts';
import { arrayTexture, type TreeTextures } from './tree-textures.ts';
import type { WindSource } from './wind-source.ts';

/** Seconds of a step of the lagged pose: the grid on which it is a pure function of time. */
export const STEP = 1 / 60;

/** The set that even depths are in. */
const EVEN = 0;

/**
 * Poses a tree on the GPU: force, bend and pose of every piece in one fragment pass with four RGBA32F targets
 * (Skjermo 2007, section 5).
 *
 * `exact`: depth by depth, each into the set that the other depths' parity leaves alone, so that a parent is always this
 * time's. `lagged`, the paper: all pieces at once, parents from the step before; a jump in time runs depth + 1 steps up to it,
 * after which nothing of the former pose is left, so that the pose is the same however that time was reached.
 */
export class WindPass implements Poser {
  readonly #textures: TreeTextures;
  readonly #targets: readonly [WebGLRenderTarget, WebGLRenderTarget];
  readonly #draw: TexelDraw;
  readonly #state = new PassState();
  readonly #depths: number;
  #seeded = false;
  /** What the pose was computed for; NaN where nothing was. */
  #time = Number.NaN;
  #revision = Number.NaN;
  #mode: WindSource['pose'] | null = null;
  /** The lagged pose: the set that holds it, and the number of its step. */
  #current = EVEN;
  #stepNumber = Number.NaN;
  #canvas: WebGLRenderer['domElement'] | null = null;
  readonly #forget = () => {
    this.#seeded = false;
  };

  /** `textures` must have targets, that is be made for a GPU that can draw into them. */
  constructor(textures: TreeTextures) {
    if (!textures.pose.targets) throw new Error('WindPass needs float targets; CpuPoser does without.');
    this.#textures = textures;
    this.#targets = textures.pose.targets;
    const { tree } = textures;
    this.#depths = tree.depthStart.length - 1;
    const ranges: IndexRange[] = Array.from({ length: this.#depths }, (_, d) => [
      tree.depthStart[d],
      tree.depthStart[d + 1],
    ]);
    // After the depths: all pieces, for the lagged pose and to seed.
    this.#draw = new TexelDraw(tree.pieces.width, tree.pieces.height, [...ranges, [0, tree.pieceCount]]);
  }

  /** Poses the tree as of `time` seconds. Changes no setting of `renderer` and allocates nothing. */
  update(renderer: WebGLRenderer, time: number, source: WindSource): void {
    if (renderer.getContext().isContextLost()) return;
    this.#listen(renderer);
    const { pose, revision } = source;
    if (this.#seeded && time === this.#time && revision === this.#revision && pose === this.#mode) return;
    this.#state.begin(renderer);
    const materials = stepMaterialsOf(renderer);
    if (!this.#seeded) this.#seed(renderer, materials);
    materials.uniforms.pieces.value = this.#textures.pieces;
    materials.uniforms.log2Width.value = Math.log2(this.#textures.pieces.image.width);
    if (pose === 'lagged') this.#lagged(renderer, materials, time, source);
    else this.#exact(renderer, materials, time, source);
    this.#state.end(renderer);
    this.#time = time;
    this.#revision = revision;
    this.#mode = pose;
  }

  /** The pose as last computed, laid out as `PackedTree.restPose.data`; slow: for checks and exports. */
  read(renderer: WebGLRenderer, out = new Float32Array(this.#textures.tree.restPose.data.length)): Float32Array {
    const { width, height } = this.#textures.tree.restPose;
    const floats = width * height * TEXEL;
    const { poseEven, poseOdd } = this.#textures.uniforms;
    const set = (textures: unknown) => (textures === this.#targets[0].textures[0] ? 0 : 1);
    const even = set(poseEven.value[0]);
    const odd = set(poseOdd.value[0]);
    const other = even === odd ? null : new Float32Array(floats);
    for (const target of Object.values(POSE_TARGETS)) {
      const layer = out.subarray(target * floats, (target + 1) * floats);
      renderer.readRenderTargetPixels(this.#targets[even], 0, 0, width, height, layer, undefined, target);
      if (!other) continue;
      renderer.readRenderTargetPixels(this.#targets[odd], 0, 0, width, height, other, undefined, target);
      const { depthStart } = this.#textures.tree;
      for (let d = 1; d < this.#depths; d += 2) {
        const [start, end] = [TEXEL * depthStart[d], TEXEL * depthStart[d + 1]];
        layer.set(other.subarray(start, end), start);
      }
    }
    return out;
  }

  dispose(): void {
    this.#canvas?.removeEventListener('webglcontextrestored', this.#forget);
    this.#draw.dispose();
  }

  /** A restored context gives targets without their contents: they are seeded again at the next update. */
  #listen(renderer: WebGLRenderer): void {
    if (this.#canvas === renderer.domElement) return;
    this.#canvas?.removeEventListener('webglcontextrestored', this.#forget);
    this.#canvas = renderer.domElement;
    this.#canvas.addEventListener('webglcontextrestored', this.#forget);
    this.#seeded = false; // another renderer has targets of its own
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

  #exact(renderer: WebGLRenderer, materials: StepMaterials, time: number, source: WindSource): void {
    source.fill(time, materials.wind);
    for (let depth = 0; depth < this.#depths; depth++) this.#write(renderer, materials, depth & 1, depth);
    this.#show(0, 1);
  }

  #lagged(renderer: WebGLRenderer, materials: StepMaterials, time: number, source: WindSource): void {
    const wanted = Math.round(time / STEP);
    // An edit while playing goes on from the pose there is; one while paused is shown as if it had always blown so.
    const ahead = wanted - this.#stepNumber;
    const follows = this.#mode === 'lagged' && ahead > 0 && ahead < this.#depths;
    // A piece of depth d looks back d steps, so the first of D + 1 steps may start from any pose.
    let step = follows ? this.#stepNumber + 1 : wanted - this.#depths + 1;
    for (; step <= wanted; step++) {
      source.fill(step * STEP, materials.wind);
      this.#current = 1 - this.#current;
      this.#write(renderer, materials, this.#current, this.#depths);
    }
    this.#show(this.#current, this.#current);
    this.#stepNumber = wanted;
  }

  /** Draws a range into a set, reading the other one. */
  #write(renderer: WebGLRenderer, materials: StepMaterials, set: number, range: number): void {
    materials.uniforms.parentPose.value = this.#targets[1 - set].textures;
    this.#draw.draw(renderer, this.#targets[set], materials.material(renderer), range);
  }

  /** Points the deformer's uniforms at the sets that even and odd depths are in. */
  #show(even: number, odd: number): void {
    const { poseEven, poseOdd } = this.#textures.uniforms;
    for (let i = 0; i < poseEven.value.length; i++) {
      poseEven.value[i] = this.#targets[even].textures[i];
      poseOdd.value[i] = this.#targets[odd].textures[i];
    }
  }
}
