import type { DataArrayTexture } from 'three';
import type { PackedTree, TexelArray } from '../core/pack/packed.ts';
import type { WindState } from '../core/wind/fade.ts';
import { sameValue } from '../core/wind/same-before.ts';
import { springTexels } from '../core/wind/spring-texels.ts';
import { swayTexels } from '../core/wind/sway.ts';
import type { SpringSettings, SwaySettings } from '../core/wind/wind.ts';
import { arrayTexture } from './tree-textures.ts';

/** While a fade changes the stiffness, the springs are made anew for every fiftieth of it. */
const NOTICEABLE = 0.02;

/** A texel array that is written anew in place, and its texture. */
class Renewed {
  readonly #name: string;
  #texels: TexelArray | undefined;
  #texture: DataArrayTexture | null = null;

  constructor(name: string) {
    this.#name = name;
  }

  get texture(): DataArrayTexture | null {
    return this.#texture;
  }

  get bytes(): number {
    return this.#texels?.data.byteLength ?? 0;
  }

  renew(write: (out: TexelArray | undefined) => TexelArray): DataArrayTexture {
    this.#texels = write(this.#texels);
    this.#texture ??= arrayTexture(this.#texels, this.#name);
    this.#texture.needsUpdate = true;
    return this.#texture;
  }

  dispose(): void {
    this.#texture?.dispose();
    this.#texture = null;
    this.#texels = undefined;
  }
}

/** What the bend models read of a tree besides its pieces: made when a model is first used, and anew when its settings change. */
export class BendTextures {
  readonly #tree: PackedTree;
  readonly #springs = new Renewed('springs');
  #spring: SpringSettings | null = null;
  #softness = Number.NaN;
  #asked = Number.NaN;
  readonly #sways = new Renewed('sways');
  #sway: Pick<SwaySettings, 'reading' | 'rate'> | null = null;

  constructor(tree: PackedTree) {
    this.#tree = tree;
  }

  /** Layers of SPRING_LAYERS for the springs of a wind. */
  springs({ spring, softness }: Pick<WindState, 'spring' | 'softness'>): DataArrayTexture {
    const settled = softness === this.#asked;
    this.#asked = softness;
    const near = Math.abs(softness / this.#softness - 1) <= (settled ? 0 : NOTICEABLE);
    const { texture } = this.#springs;
    if (texture && near && sameValue(spring, this.#spring)) return texture;
    this.#spring = structuredClone(spring);
    this.#softness = softness;
    return this.#springs.renew((out) => springTexels(this.#tree, spring, 1 / softness, undefined, out));
  }

  /** Layers of SWAY_LAYERS for the swaying of a wind. */
  sways({ sway }: Pick<WindState, 'sway'>): DataArrayTexture {
    const { reading, rate } = sway;
    const { texture } = this.#sways;
    if (texture && this.#sway?.reading === reading && this.#sway.rate === rate) return texture;
    this.#sway = { reading, rate };
    return this.#sways.renew((out) => swayTexels(this.#tree, sway, out));
  }

  /** On the GPU. */
  get bytes(): number {
    return this.#springs.bytes + this.#sways.bytes;
  }

  dispose(): void {
    this.#springs.dispose();
    this.#sways.dispose();
  }
}
