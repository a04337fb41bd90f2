import type { WebGLRenderer } from 'three';
import { POSE_TARGETS, TEXEL } from '../core/pack/layout.ts';
import type { TexelArray } from '../core/pack/packed.ts';
import { createWindState } from '../core/wind/fade.ts';
import { poseTree } from '../core/wind/pose-tree.ts';
import { type Bends, uses } from '../core/wind/push.ts';
import { swayTexels } from '../core/wind/sway.ts';
import { CpuSprings } from './cpu-springs.ts';
import type { Poser, ReadBack } from './poser.ts';
import { checkpointsFor, sliceFor } from './state-budget.ts';
import { type Near, StateRun } from './state-run.ts';
import { stepsAt } from './step.ts';
import type { TreeTextures } from './tree-textures.ts';
import type { WindSource } from './wind-source.ts';

/** Poses a tree by the TypeScript reference and uploads the pose: where the GPU draws into no float textures. Always `exact`. */
export class CpuPoser implements Poser {
  readonly bytes = 0;
  readonly #textures: TreeTextures;
  readonly #pose: Float32Array;
  readonly #wind = createWindState();
  #near: Near;
  #springs: CpuSprings | null = null;
  #run: StateRun | null = null;
  #state: Float32Array | null = null;
  #sways: TexelArray | undefined;
  #sway = '';
  #time = Number.NaN;
  #revision = Number.NaN;

  /** `textures` must be made for the CPU (`gpuPose` false); `near`: springs begin with the wind of the first update's time, until `settle`. */
  constructor(textures: TreeTextures, near: Near = false) {
    this.#near = near;
    if (!textures.cpuPose) throw new Error('CpuPoser needs textures that the CPU writes.');
    this.#textures = textures;
    this.#pose = textures.cpuPose;
  }

  get catchingUp(): number | null {
    return this.#run?.catchingUp ?? null;
  }

  settle(): void {
    if (!this.#near || this.#near === 'always') return;
    this.#near = false;
    this.#run?.settle();
    this.#time = Number.NaN;
  }

  update(_renderer: WebGLRenderer | null, time: number, source: WindSource): void {
    if (time === this.#time && source.revision === this.#revision && this.catchingUp === null) return;
    source.fill(time, this.#wind);
    const bends: Bends = {};
    this.#state = null;
    if (uses(this.#wind, 'spring')) {
      const springs = this.#swing(time, source);
      if (!springs) return;
      bends.springs = springs;
      this.#state = springs.state;
      source.fill(time, this.#wind); // the steps had winds of their own
    } else this.#run?.rest();
    if (uses(this.#wind, 'sway')) bends.sway = this.#swaying();
    poseTree(this.#textures.tree, this.#wind, 'exact', undefined, this.#pose, bends);
    for (const texture of this.#textures.pose.written ?? []) texture.needsUpdate = true;
    this.#time = time;
    this.#revision = source.revision;
  }

  read(_renderer: WebGLRenderer | null, out = new Float32Array(this.#pose.length)): Float32Array {
    out.set(this.#pose);
    return out;
  }

  readState(): Float32Array | null {
    return this.#state?.slice() ?? null;
  }

  async readBack(renderer: WebGLRenderer | null): Promise<ReadBack> {
    return { pose: this.read(renderer), state: this.readState() };
  }

  async readPiece(_renderer: WebGLRenderer | null, piece: number): Promise<Float32Array | null> {
    const { pieceCount } = this.#textures.tree;
    if (!(Number.isInteger(piece) && piece >= 0 && piece < pieceCount)) return null;
    const targets = Object.values(POSE_TARGETS);
    const plane = this.#pose.length / targets.length;
    const out = new Float32Array(targets.length * TEXEL);
    for (const target of targets) {
      const at = target * plane + TEXEL * piece;
      out.set(this.#pose.subarray(at, at + TEXEL), TEXEL * target);
    }
    return out;
  }

  dispose(): void {
    this.#springs = null;
    this.#run = null;
    this.#state = null;
  }

  /** The springs at a time; null where the way there is long and goes on with the next update. */
  #swing(time: number, source: WindSource): Required<Bends>['springs'] | null {
    const { tree } = this.#textures;
    this.#springs ??= new CpuSprings(tree);
    const springs = this.#springs;
    springs.use(source);
    const { first, last, fraction } = stepsAt(time);
    this.#run ??= new StateRun(
      springs,
      checkpointsFor(48 * tree.pieceCount),
      sliceFor(tree.pieceCount, true),
      this.#near,
    );
    const run = this.#run;
    if (!run.reach(first, last, source)) return null;
    const before = first < run.latest && run.has(first) ? springs.previous : springs.latest;
    return springs.bends(before, springs.latest, before === springs.latest ? 0 : fraction).springs;
  }

  #swaying(): TexelArray {
    const { reading, rate } = this.#wind.sway;
    const key = `${reading} ${rate}`;
    if (!this.#sways || key !== this.#sway) {
      this.#sway = key;
      this.#sways = swayTexels(this.#textures.tree, this.#wind.sway, this.#sways);
    }
    return this.#sways;
  }
}
