import type { MeshBuilder, Teeth, Vector } from './blade.ts';

/** A needle some way off: a triangle whose foot lies along the shoot, the z axis, where it shares its corners with its neighbours. */
export interface Tooth {
  /** Where its foot begins and ends. */
  readonly foot: readonly [number, number];
  readonly tip: Vector;
}

/** Area of some teeth. */
export const toothArea = (teeth: readonly Tooth[]): number =>
  teeth.reduce((sum, { foot, tip }) => sum + 0.5 * (foot[1] - foot[0]) * Math.hypot(tip[0], tip[1]), 0);

/** Some teeth as what a form has. */
export const teethOf = (teeth: readonly Tooth[]): Teeth => ({
  area: toothArea(teeth),
  triangles: teeth.length,
  add: (out, petiole) => addTeeth(out, teeth, petiole),
});

/** How far the shading of a tooth's tip turns outwards from the shoot, so that a tuft reads as round. */
const TUFT = 0.6;

/** Adds teeth, which share the corners of their feet; each faces the upper side. */
function addTeeth(out: MeshBuilder, teeth: readonly Tooth[], petiole: number): void {
  const feet = new Map<number, number>();
  const corner = ([x, y, z]: readonly number[], [nx, ny, nz]: readonly number[], margin: number): number => {
    const n = Math.hypot(nx!, ny!, nz!);
    out.position.push(x!, y!, petiole + z!);
    out.normal.push(nx! / n, ny! / n, nz! / n);
    out.blade.push(margin, z!, 0, margin);
    return out.position.length / 3 - 1;
  };
  const foot = (z: number): number => {
    const found = feet.get(z) ?? corner([0, 0, z], [0, 1, 0], 0);
    feet.set(z, found);
    return found;
  };
  for (const { foot: ends, tip } of teeth) {
    const [low, high] = [foot(ends[0]), foot(ends[1])];
    const [x, y] = tip;
    const far = Math.hypot(x, y);
    // Its face is at right angles to the plane through the shoot and its tip, on the side that looks up.
    const side = x < 0 ? -1 : 1;
    const [nx, ny] = [(-side * y) / far, (side * x) / far];
    const top = corner(tip, [nx + (TUFT * x) / far, ny + (TUFT * y) / far, 0], 1);
    if (side > 0) out.index.push(low, high, top);
    else out.index.push(low, top, high);
  }
}
