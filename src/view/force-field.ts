import { DataTexture, FloatType, type IUniform, type Material, RGBAFormat } from 'three';
import { createWindState, type WindState } from '../core/wind/fade.ts';
import { MAX_WAVES } from '../core/wind/force.ts';
import { forceUniforms } from '../core/wind/force-variant.ts';
import { MAX_GUSTS } from '../core/wind/gust.ts';
import { RECORD_WIDTH } from '../core/wind/record-state.ts';
import type { WindSource } from '../gpu/wind-source.ts';

/** The force of the wind for shaders that show it: the same uniforms and functions as the wind pass. */
export class ForceField {
  readonly state: WindState = createWindState();
  readonly uniforms: Readonly<Record<string, IUniform>>;
  readonly #record: IUniform<DataTexture | null> = { value: null };
  #recorded: Float32Array | null = null;
  readonly #counts = { value: [0, 0] };
  #source: WindSource | null = null;
  #time = Number.NaN;
  #revision = Number.NaN;

  constructor() {
    const values = Object.entries(forceUniforms(this.state));
    this.uniforms = {
      ...Object.fromEntries(values.map(([name, value]) => [name, { value }])),
      windRecord: this.#record,
      fieldCounts: this.#counts,
    };
  }

  /** Takes the wind at `time` seconds. */
  take(source: WindSource, time: number): void {
    if (source === this.#source && time === this.#time && source.revision === this.#revision) return;
    const { state } = this;
    source.fill(time, state);
    this.#source = source;
    this.#time = time;
    this.#revision = source.revision;
    this.#takeRecord(state.record);
    this.#counts.value[0] = state.count;
    this.#counts.value[1] = state.gustCount;
  }

  /** Chooses the variant of a material's program: one with a record, or without; three keeps those that it made. */
  dress(material: Material): void {
    const record = this.state.record ? 1 : 0;
    if (material.defines?.WIND_RECORD === record) return;
    material.defines = { ...material.defines, WIND_WAVES: MAX_WAVES, WIND_GUSTS: MAX_GUSTS, WIND_RECORD: record };
    material.needsUpdate = true;
  }

  dispose(): void {
    this.#takeRecord(null);
  }

  #takeRecord(record: Float32Array | null): void {
    if (record === this.#recorded) return;
    this.#recorded = record;
    this.#record.value?.dispose();
    this.#record.value = null;
    if (!record) return;
    const rows = record.length / (4 * RECORD_WIDTH);
    const texture = new DataTexture(record as Float32Array<ArrayBuffer>, RECORD_WIDTH, rows, RGBAFormat, FloatType);
    texture.needsUpdate = true;
    texture.name = 'wind record';
    this.#record.value = texture;
  }
}
