import {
  bulges,
  clampedFlare,
  flare,
  lobes,
  type Profile,
  powerTaper,
  type Shape,
  skjermoRadius,
  taperRadius,
} from '../../../src/core/deform/radius.ts';
import { deform as deformPoint, paperSurfacePoint, surfacePoint } from '../../../src/core/deform/surface.ts';
import { handlesOf, projectedHandlesOf } from '../../../src/core/math/frames.ts';
import type { Vec3 } from '../../../src/core/math/vec3.ts';
import { type Adapters, cubicOf, type Points, TAU } from './case.ts';

interface CaseShape {
  r: number;
  t: number;
  f: number;
  bn: number;
  bd: number;
  ln: number;
  ld: number;
  lt: number;
  flare: 'skj' | 'wp';
}

interface OnSurface {
  P: Points;
  O: Vec3;
  frames?: 'rmf' | 'sloan';
  shape: CaseShape;
  u: number;
  theta: number;
}

const profile = ([f, df]: Profile) => ({ f, df });

function radiusOf(s: CaseShape, u: number, theta: number): [number, number, number] {
  const shape: Shape = {
    taper: s.t,
    flare: s.f,
    lobes: s.ln,
    lobeDepth: s.ld,
    lobeFade: s.lt,
    bulges: s.bn,
    bulgeDepth: s.bd,
  };
  return skjermoRadius(shape, s.r, u, theta / TAU, s.flare === 'wp' ? clampedFlare : flare);
}

const onSurface =
  (point: typeof surfacePoint) =>
  ({ P, O, frames, shape, u, theta }: OnSurface) => {
    const c = cubicOf(P);
    const h = frames === 'sloan' ? projectedHandlesOf(c, O) : handlesOf(c, O);
    const [rho, rhoU, q] = radiusOf(shape, u, theta);
    const p = point(c, h, u, Math.cos(theta), Math.sin(theta), rho, rhoU, q);
    return { pos: p.position, tangent_u: p.along, bitangent_theta: p.around, normal: p.normal, rho };
  };

export const deform: Adapters = {
  taper: ({ u, r, t }: Record<'u' | 'r' | 't', number>) => profile(powerTaper(u, r, t)),
  flare_skj: ({ u, f }: Record<'u' | 'f', number>) => profile(flare(u, f)),
  flare_wp: ({ u, f }: Record<'u' | 'f', number>) => profile(clampedFlare(u, f)),
  bulges: ({ u, bn, bd }: Record<'u' | 'bn' | 'bd', number>) => profile(bulges(u, bn, bd)),
  lobes: ({ u, theta, ln, ld, lt }: Record<'u' | 'theta' | 'ln' | 'ld' | 'lt', number>) => {
    const [f, du, dtheta] = lobes(u, theta / TAU, ln, ld, lt);
    return { f, du, dtheta };
  },
  rho: ({ u, theta, shape }: { u: number; theta: number; shape: CaseShape }) => {
    const [rho, rhoU, q] = radiusOf(shape, u, theta);
    return { rho, rho_u: rhoU, rho_theta: q * rho, q };
  },
  wp_radius: ({ Z, nTaper, radius, length }: { Z: number[]; nTaper: number; radius: number; length: number }) => ({
    r: Z.map((z) => taperRadius(z, nTaper, radius, length)[0]),
  }),
  deform: ({ P, O, frames, u, v, w }: OnSurface & { v: number; w: number }) => {
    const c = cubicOf(P);
    const d = deformPoint(c, frames === 'sloan' ? projectedHandlesOf(c, O) : handlesOf(c, O), u, v, w);
    return { Q: d.position, Qu: d.byU, Qv: d.byV, Qw: d.byW };
  },
  surface: onSurface(paperSurfacePoint),
  surface_ortho: onSurface(surfacePoint),
};
