import { sinCos, trig } from './elementary.ts';

/**
 * The frame of a stem: nine numbers, the axes x, y, z one after the other (the columns of a rotation).
 *
 * z runs along the stem. A turn about a local axis multiplies from the right, one about the tree's axes from the left.
 * These write in place: growing a tree turns a million frames and allocates none.
 */
export type Frame = Float64Array;

export const newFrame = (): Frame => Float64Array.of(1, 0, 0, 0, 1, 0, 0, 0, 1);

/** Turns about the local x axis: a positive angle leans z towards -y, "down" on a side branch. */
export function turnX(f: Frame, angle: number): void {
  if (angle === 0) return;
  sinCos(angle);
  combineAxes(f, 3, 6, trig.cos, trig.sin);
}

/** Turns about the local y axis: a positive angle leans z towards x. */
export function turnY(f: Frame, angle: number): void {
  if (angle === 0) return;
  sinCos(angle);
  combineAxes(f, 6, 0, trig.cos, trig.sin);
}

/** Turns about the local z axis: a positive angle leans x towards y. */
export function turnZ(f: Frame, angle: number): void {
  if (angle === 0) return;
  sinCos(angle);
  combineAxes(f, 0, 3, trig.cos, trig.sin);
}

/** Axis a becomes c a + s b, axis b becomes c b - s a. */
function combineAxes(f: Frame, a: number, b: number, c: number, s: number): void {
  for (let i = 0; i < 3; i++) {
    const p = f[a + i];
    const q = f[b + i];
    f[a + i] = c * p + s * q;
    f[b + i] = c * q - s * p;
  }
}

/** Turns the whole frame about the tree's vertical. */
export function turnAboutVertical(f: Frame, angle: number): void {
  if (angle === 0) return;
  sinCos(angle);
  const c = trig.cos;
  const s = trig.sin;
  for (let i = 0; i < 9; i += 3) {
    const x = f[i];
    const y = f[i + 1];
    f[i] = c * x - s * y;
    f[i + 1] = s * x + c * y;
  }
}

/** Turns the whole frame about the horizontal axis (kx, ky, 0), a unit vector (Rodrigues). */
export function turnAboutHorizontal(f: Frame, kx: number, ky: number, angle: number): void {
  sinCos(angle);
  const c = trig.cos;
  const s = trig.sin;
  for (let i = 0; i < 9; i += 3) {
    const x = f[i];
    const y = f[i + 1];
    const z = f[i + 2];
    const along = (1 - c) * (kx * x + ky * y);
    f[i] = c * x + s * ky * z + along * kx;
    f[i + 1] = c * y - s * kx * z + along * ky;
    f[i + 2] = c * z + s * (kx * y - ky * x);
  }
}

/** Copies nine stored numbers from `offset` and makes them an exact rotation again: z first, then y. */
export function readFrame(f: Frame, stored: ArrayLike<number>, offset: number): void {
  for (let i = 0; i < 9; i++) f[i] = stored[offset + i];
  rectify(f);
}

/** Makes z a unit vector, y a unit vector perpendicular to it, and x = y x z. */
export function rectify(f: Frame): void {
  const nz = 1 / Math.sqrt(f[6] * f[6] + f[7] * f[7] + f[8] * f[8]);
  const zx = f[6] * nz;
  const zy = f[7] * nz;
  const zz = f[8] * nz;
  const along = f[3] * zx + f[4] * zy + f[5] * zz;
  let yx = f[3] - along * zx;
  let yy = f[4] - along * zy;
  let yz = f[5] - along * zz;
  const ny = 1 / Math.sqrt(yx * yx + yy * yy + yz * yz);
  yx *= ny;
  yy *= ny;
  yz *= ny;
  f[0] = yy * zz - yz * zy;
  f[1] = yz * zx - yx * zz;
  f[2] = yx * zy - yy * zx;
  f[3] = yx;
  f[4] = yy;
  f[5] = yz;
  f[6] = zx;
  f[7] = zy;
  f[8] = zz;
}
