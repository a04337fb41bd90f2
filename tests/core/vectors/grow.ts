import { attractAsPrinted, attractUp, curveUp, declinationOf } from '../../../src/core/grow/attraction.ts';
import { curveDeltas, stemPolyline } from '../../../src/core/grow/curve.ts';
import type { Frame } from '../../../src/core/grow/frame.ts';
import { leafBend } from '../../../src/core/grow/leaf-bend.ts';
import { insideEnvelope } from '../../../src/core/grow/pruning.ts';
import { radiusChild } from '../../../src/core/grow/radius.ts';
import { splitSequence, spreadAngleDeg } from '../../../src/core/grow/splits.ts';
import {
  countOnDeeperStem,
  countOnMainBranch,
  deeperLength,
  downAngleAlong,
  leavesCount,
  mainBranchLength,
  shapeRatio,
} from '../../../src/core/grow/stem-shape.ts';
import type { Mat3, Vec3 } from '../../../src/core/math/vec3.ts';
import { type Adapters, transposed } from './case.ts';

const RADIANS = Math.PI / 180;

const frameOf = (rows: Mat3): Frame => Float64Array.from(transposed(rows).flat());
const rowsOf = (f: Frame): Mat3 => transposed([0, 3, 6].map((k) => [...f.subarray(k, k + 3)]) as Mat3);

interface Lengths {
  level: number;
  lmax: number;
  Lpar: number;
  off: number[];
  Lbase: number;
  shape: number;
}

interface Envelope {
  points: Vec3[];
  scale: number;
  base: number;
  width: number;
  peak: number;
  lo: number;
  hi: number;
}

interface Counts {
  level: number[];
  smax: number[];
  Lchild: number[];
  Lpar: number[];
  lmax: number[];
  off: number[];
}

export const grow: Adapters = {
  shape_ratio: ({
    shape,
    ratio,
    ...envelope
  }: {
    shape: number;
    ratio: number[];
    peak?: number;
    lo?: number;
    hi?: number;
  }) => {
    const { peak = 0.5, lo = 0.5, hi = 0.5 } = envelope;
    return { y: ratio.map((r) => shapeRatio(shape, r, { widthPeak: peak, powerLow: lo, powerHigh: hi })) };
  },
  length_child: ({ level, lmax, Lpar, off, Lbase, shape }: Lengths) => ({
    L: off.map((o) => (level === 1 ? mainBranchLength(lmax, Lpar, o, Lbase, shape) : deeperLength(lmax, Lpar, o))),
  }),
  stems_count: ({ level, smax, Lchild, Lpar, lmax, off }: Counts) => ({
    n: level.map((l, i) =>
      l === 1 ? countOnMainBranch(smax[i], Lchild[i], Lpar[i], lmax[i]) : countOnDeeperStem(smax[i], off[i], Lpar[i]),
    ),
  }),
  leaves_count: ({ leaves, off, Lpar, quality }: { leaves: number; off: number[]; Lpar: number; quality: number }) => ({
    n: off.map((o) => leavesCount(leaves, o, Lpar, quality)),
  }),
  down_angle_deg: ({
    down,
    downV,
    Lpar,
    off,
    Lbase,
  }: Record<'down' | 'downV' | 'Lpar' | 'Lbase', number> & { off: number[] }) => ({
    deg: off.map((o) => downAngleAlong(down, downV, Lpar, o, Lbase)),
  }),
  radius_child: ({
    rpar,
    Lc,
    Lp,
    power,
    limit,
  }: Record<'rpar' | 'Lc' | 'Lp' | 'power', number> & { limit: number[] }) => ({
    r: limit.map((l) => radiusChild(rpar, Lc, Lp, power, l)),
  }),
  curve_deltas_deg: ({ curve, back, n }: Record<'curve' | 'back' | 'n', number>) => ({
    d: curveDeltas(curve, back, n),
  }),
  stem_polyline: ({ L, deltas_x_deg }: { L: number; deltas_x_deg: number[] }) => ({
    points: stemPolyline(
      L,
      deltas_x_deg.map((d) => d * RADIANS),
    ),
  }),
  split_sequence: ({ segsplits, count }: Record<'segsplits' | 'count', number>) => ({
    n: splitSequence(segsplits, count),
  }),
  spread_angle_deg: ({ decl, rnd, coeff }: { decl: number[]; rnd: number[]; coeff: number }) => ({
    deg: decl.map((d, i) => spreadAngleDeg(d, rnd[i], coeff)),
  }),
  attraction_up: ({ R, att, nres }: { R: Mat3; att: number; nres: number }) => {
    const f = frameOf(R);
    const declination = declinationOf(f);
    const up = curveUp(f, att, nres);
    attractAsPrinted(f, att, nres);
    return { declination, curve_up: up, R: rowsOf(f) };
  },
  attraction_up_general: ({ R, att, nres }: { R: Mat3; att: number; nres: number }) => {
    const f = frameOf(R);
    attractUp(f, att, nres, 0);
    return { R: rowsOf(f) };
  },
  inside: ({ points, scale, base, width, peak, lo, hi }: Envelope) => ({
    inside: points.map(([x, y, z]) =>
      insideEnvelope(x, y, z, {
        scale,
        width,
        baseSize: base,
        widthPeak: peak,
        powerLow: lo,
        powerHigh: hi,
        pruneBase: false,
      }),
    ),
  }),
  leaf_bend: ({ R, pos, bend }: { R: Mat3; pos: Vec3; bend: number }) => {
    const f = frameOf(R);
    leafBend(f, pos[0], pos[1], bend);
    return { R: rowsOf(f) };
  },
};
