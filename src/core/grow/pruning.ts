import type { EnvelopeShape } from './stem-shape.ts';
import { envelopeRatio } from './stem-shape.ts';

/** The envelope that stems are pruned to: metres for `scale`, fractions of it for the rest. */
export interface Envelope extends EnvelopeShape {
  readonly scale: number;
  readonly baseSize: number;
  readonly width: number;
  /** Row 48: what hangs below the crown's base is outside too. */
  readonly pruneBase: boolean;
}

/** Whether a point lies inside the envelope (Weber & Penn 1995, 4.6; rows 45 and 47: the radius is horizontal, the width a radius). */
export function insideEnvelope(x: number, y: number, z: number, e: Envelope): boolean {
  const ratio = (e.scale - z) / (e.scale * (1 - e.baseSize));
  return Math.sqrt(x * x + y * y) / e.scale < e.width * envelopeRatio(ratio, e);
}

/** Bisections of the length: 8 halvings reach 0.4 % (row 49 asks for 0.5 %). */
const HALVINGS = 8;

/**
 * The part 0..1 of its length with which a stem and its clones stay inside: nodes `from` (the stem's first) to `to`, three numbers a node.
 *
 * No turn of a stem depends on its length, so a shorter stem is the same stem, scaled about its base: probing needs no second growth and the
 * draws are the same by construction (row 49).
 */
export function fittingPart(nodes: Float32Array, from: number, to: number, e: Envelope): number {
  if (fits(nodes, from, to, 1, e)) return 1;
  let low = 0;
  let high = 1;
  for (let i = 0; i < HALVINGS; i++) {
    const middle = (low + high) / 2;
    if (fits(nodes, from, to, middle, e)) low = middle;
    else high = middle;
  }
  return low;
}

function fits(nodes: Float32Array, from: number, to: number, part: number, e: Envelope): boolean {
  const bx = nodes[3 * from];
  const by = nodes[3 * from + 1];
  const bz = nodes[3 * from + 2];
  const floor = e.pruneBase ? Number.NEGATIVE_INFINITY : e.scale * e.baseSize;
  for (let i = from; i < to; i++) {
    const z = bz + part * (nodes[3 * i + 2] - bz);
    if (z < floor) continue;
    const x = bx + part * (nodes[3 * i] - bx);
    const y = by + part * (nodes[3 * i + 1] - by);
    if (!insideEnvelope(x, y, z, e)) return false;
  }
  return true;
}
