import { draw, spread } from './draws.ts';
import type { StemBuilder } from './stem-builder.ts';

/** Where the children or leaves of one stem grow: fractions of its whole length, in growing order. */
export class Places {
  z = new Float64Array(256);
  count = 0;

  /**
   * Spreads children over stem `i` from `low` to its tip: `rate` of them per whole length, less where clones share them.
   *
   * The children stand at the whole numbers of a count that grows along the stem and starts at a random fraction: error diffusion, so the
   * mean is exact, and no stem depends on another (row 8). Each is moved by up to a quarter of its distance to the next (row 9).
   */
  spread(
    stems: StemBuilder,
    i: number,
    low: number,
    rate: number,
    stream: number,
    place: number,
    jitter: number,
  ): void {
    this.count = 0;
    if (!(rate > 0)) return;
    const first = stems.nodeStart[i];
    const segments = stems.nodeStart[i + 1] - 1 - first;
    const zStart = stems.zStart[i];
    const step = (1 - zStart) / segments;
    const from = Math.max(low, zStart);
    let reached = 0;
    let next = 1 - draw(stream, place);
    for (let s = 0; s < segments; s++) {
      const end = s === segments - 1 ? 1 : zStart + (s + 1) * step;
      const begin = Math.max(zStart + s * step, from);
      if (end <= begin) continue;
      const density = rate * stems.share[first + s];
      const after = reached + (end - begin) * density;
      for (; next <= after; next++) {
        const moved = begin + (next - reached + spread(stream, jitter + this.count, 0.25)) / density;
        this.push(Math.min(Math.max(moved, from), 1));
      }
      reached = after;
    }
  }

  /** Moves what would grow inside the parent's wood, up to `inside` (a fraction of the length), out of it (row 9). */
  clear(inside: number): void {
    const wood = Math.min(inside, 0.5);
    for (let k = 0; k < this.count && this.z[k] < 2 * wood; k++) if (this.z[k] < wood) this.z[k] = this.z[k] + wood;
  }

  private push(z: number): void {
    if (this.count === this.z.length) {
      const wider = new Float64Array(2 * this.count);
      wider.set(this.z);
      this.z = wider;
    }
    this.z[this.count++] = z;
  }
}

/** A place on a stem's axis: the node at which its segment starts, and the point itself in metres. */
const found = { node: 0, x: 0, y: 0, z: 0 };

/** The place at z (a fraction of the whole length) of stem `i`; the same object each time, so read it before the next call. */
export function locate(stems: StemBuilder, i: number, z: number): Readonly<typeof found> {
  const first = stems.nodeStart[i];
  const segments = stems.nodeStart[i + 1] - 1 - first;
  const zStart = stems.zStart[i];
  const at = ((z - zStart) / (1 - zStart)) * segments;
  const segment = Math.min(Math.max(Math.floor(at), 0), segments - 1);
  const part = Math.min(Math.max(at - segment, 0), 1);
  const n = 3 * (first + segment);
  const p = stems.nodePosition;
  found.node = first + segment;
  found.x = p[n] + part * (p[n + 3] - p[n]);
  found.y = p[n + 1] + part * (p[n + 4] - p[n + 1]);
  found.z = p[n + 2] + part * (p[n + 5] - p[n + 2]);
  return found;
}
