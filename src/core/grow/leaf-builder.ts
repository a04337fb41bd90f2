import { writeQuaternion } from '../math/quaternion.ts';
import type { Frame } from './frame.ts';
import { widened } from './stem-builder.ts';
import type { Leaves } from './tree.ts';

/** Leaves while they are grown: the arrays of `Leaves`, with room to grow. */
export class LeafBuilder {
  count = 0;
  private stem = new Int32Array(4096);
  private z = new Float32Array(4096);
  private orientation = new Float32Array(4 * 4096);
  private phase = new Float32Array(4096);

  add(stem: number, z: number, f: Frame, phase: number): void {
    const i = this.count;
    if (i === this.stem.length) this.reserve(i + 1);
    this.stem[i] = stem;
    this.z[i] = z;
    this.phase[i] = phase;
    writeQuaternion(f, this.orientation, 4 * i);
    this.count = i + 1;
  }

  /** The arrays at their exact size; every blade is `length` metres long. */
  finish(length: number): Leaves {
    const n = this.count;
    return {
      count: n,
      stem: this.stem.slice(0, n),
      z: this.z.slice(0, n),
      orientation: this.orientation.slice(0, 4 * n),
      length: new Float32Array(n).fill(length),
      phase: this.phase.slice(0, n),
    };
  }

  /** Makes room for so many leaves in one go. */
  reserve(needed: number): void {
    if (needed <= this.stem.length) return;
    this.stem = widened(this.stem, needed);
    this.z = widened(this.z, needed);
    this.orientation = widened(this.orientation, 4 * needed);
    this.phase = widened(this.phase, needed);
  }
}
