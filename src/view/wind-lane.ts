import { Vector2, type WebGLRenderer } from 'three';
import type { PackedTree } from '../core/pack/packed.ts';
import { createWindState, type WindState } from '../core/wind/fade.ts';
import { windForce } from '../core/wind/force.ts';
import { capabilitiesOf } from '../gpu/capabilities.ts';
import type { Poser } from '../gpu/poser.ts';
import type { Near } from '../gpu/state-run.ts';
import { TreeTextures } from '../gpu/tree-textures.ts';
import { WindPass } from '../gpu/wind-pass.ts';
import { FeltWind } from './felt-wind.ts';
import type { TreeKit } from './tree-kit.ts';

/** Metres of force above which leaves know where it blows from. */
const HINT = 0.01;

/** Metres along the ground from the origin of a tree to the farthest corner of its bounds. */
const reachOf = ({ bounds: [x0, y0, , x1, y1] }: PackedTree): number =>
  Math.hypot(Math.max(Math.abs(x0), Math.abs(x1)), Math.max(Math.abs(y0), Math.abs(y1)));

/** One wind on a tree, and the tree as it stands in it: a tree has one, and a second while two winds are compared. */
export class WindLane {
  readonly felt = new FeltWind();
  /** Direction towards which it blows at the tree, tree axes; shorter than 1 where it hardly does. */
  readonly way = new Vector2();
  /** Metres of force in the middle of the tree, as of the last `update`. */
  force = 0;
  readonly #state = createWindState();
  readonly #kit: Pick<TreeKit, 'cpuPoser'>;
  #textures: TreeTextures | null = null;
  #poser: Poser | null = null;

  constructor(kit: Pick<TreeKit, 'cpuPoser'>) {
    this.#kit = kit;
  }

  /** null before the first `update`. */
  get textures(): TreeTextures | null {
    return this.#textures;
  }

  /** The wind of the last `update`. */
  get state(): Readonly<WindState> {
    return this.#state;
  }

  get poser(): Poser | null {
    return this.#poser;
  }

  /** Springs that began near run again from time 0, from the next `update` on. */
  settle(): void {
    this.#poser?.settle();
  }

  /** Another tree comes with the next `update`: it takes over what is of its size. */
  leave(): void {
    this.#poser?.dispose();
    this.#poser = null;
  }

  /** Poses `tree` as of `time` seconds; the same tree until `leave` or `drop`. `near`: its springs begin with the wind of that time, until `settle`, or `always`. */
  update(renderer: WebGLRenderer, tree: PackedTree, time: number, near: Near = false): TreeTextures {
    let textures = this.#textures;
    if (!textures || !this.#poser) {
      if (!textures?.retake(tree)) {
        textures?.dispose();
        textures = new TreeTextures(tree, capabilitiesOf(renderer).floatTargets);
        this.#textures = textures;
      }
      this.felt.reach = reachOf(tree);
      this.#poser = textures.cpuPose ? this.#kit.cpuPoser(textures, near) : new WindPass(textures, near);
    }
    this.#poser.update(renderer, time, this.felt);
    this.felt.fill(time, this.#state);
    const [x, y] = windForce(this.#state, 0, 0, this.#state.profiled ? (tree.crown[2] as number) : 0);
    this.force = Math.hypot(x, y);
    this.way.set(x, y).divideScalar(this.force + HINT);
    return textures;
  }

  /** Frees what it has on the GPU. */
  drop(): void {
    this.leave();
    this.#textures?.dispose();
    this.#textures = null;
  }
}
