import { DataTexture, FloatType, RGBAFormat } from 'three';
import { TEXEL } from '../core/pack/layout.ts';
import { RECORD_WIDTH } from '../core/wind/record-state.ts';

/** Records on the GPU at a time: two winds side by side, each fading into another. */
const MOST = 4;

/** The textures of the measured winds that blow lately, each uploaded once; three lets go of the rest. */
export class RecordTextures {
  /** Used last comes last. */
  readonly #textures = new Map<Float32Array, DataTexture>();

  /** The texture of `WindState.record`; the same as long as the record is. */
  of(record: Float32Array | null): DataTexture | null {
    if (!record) return null;
    let texture = this.#textures.get(record);
    if (texture) this.#textures.delete(record);
    else {
      const height = record.length / (RECORD_WIDTH * TEXEL);
      texture = new DataTexture(record as Float32Array<ArrayBuffer>, RECORD_WIDTH, height, RGBAFormat, FloatType);
      texture.name = 'wind record';
      texture.needsUpdate = true;
    }
    this.#textures.set(record, texture);
    for (const [old, stale] of this.#textures) {
      if (this.#textures.size <= MOST) break;
      this.#textures.delete(old);
      stale.dispose();
    }
    return texture;
  }
}
