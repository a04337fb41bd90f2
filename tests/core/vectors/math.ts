import { arcHandle, generatorBends, generatorCubic } from '../../../src/core/deform/generator.ts';
import {
  bezierArcLength,
  bezierDerivative,
  bezierPoint,
  bezierSecondDerivative,
  type Cubic,
  rescaleArc,
} from '../../../src/core/math/bezier.ts';
import { type Handles, handlesOf, projectedHandlesOf, transport } from '../../../src/core/math/frames.ts';
import { cross, distance, mix, type Vec3 } from '../../../src/core/math/vec3.ts';
import { type Adapters, cubicOf, type Points, pointsOf } from './case.ts';

interface Framed {
  P: Points;
  O: Vec3;
}

const handleLists = (h: Handles) => ({
  L: [h.l0, h.l1, h.l2],
  S: [cross(h.l0, h.t0), cross(h.l1, h.t1), cross(h.l2, h.t2)],
  T: [h.t0, h.t1, h.t2],
});

/** Both halves of a curve. */
function halves({ p0, p1, p2, p3 }: Cubic): [Cubic, Cubic] {
  const [a, b, c] = [mix(p0, p1, 0.5), mix(p1, p2, 0.5), mix(p2, p3, 0.5)];
  const [d, e] = [mix(a, b, 0.5), mix(b, c, 0.5)];
  const m = mix(d, e, 0.5);
  return [
    { p0, p1: a, p2: d, p3: m },
    { p0: m, p1: e, p2: c, p3 },
  ];
}

const exactArc = (c: Cubic, depth: number): number =>
  depth === 0 ? bezierArcLength(c) : halves(c).reduce((sum, half) => sum + exactArc(half, depth - 1), 0);

export const math: Adapters = {
  frames_sloan: ({ P, O }: Framed) => handleLists(projectedHandlesOf(cubicOf(P), O)),
  frames_rmf: ({ P, O }: Framed) => handleLists(handlesOf(cubicOf(P), O)),
  transport: ({ a, p, q }: { a: Vec3; p: Vec3; q: Vec3 }) => ({ r: transport(a, p, q) }),
  bezier: ({ P, u }: { P: Points; u: number }) => ({
    C: bezierPoint(cubicOf(P), u),
    C1: bezierDerivative(cubicOf(P), u),
    C2: bezierSecondDerivative(cubicOf(P), u),
  }),
  arc: ({ P }: { P: Points }) => {
    const [p0, p1, p2, p3] = P;
    return {
      gl5: bezierArcLength(cubicOf(P)),
      exact: exactArc(cubicOf(P), 6),
      // Half of polygon and chord: the estimate that equations.md 3.4 warns of; nothing in the code uses it.
      gravesen: (distance(p0, p1) + distance(p1, p2) + distance(p2, p3) + distance(p0, p3)) / 2,
    };
  },
  rescale_arc: ({ P, Lrest }: { P: Points; Lrest: number }) => ({ P: pointsOf(rescaleArc(cubicOf(P), Lrest)) }),
  generator_bezier: ({ L, a1, b1, a2, b2 }: Record<'L' | 'a1' | 'b1' | 'a2' | 'b2', number>) => ({
    P: pointsOf(generatorCubic(L, a1, b1, a2, b2)),
  }),
  generator_angles: ({ T1, T2 }: Record<'T1' | 'T2', number>) => ({ b: generatorBends(T1, T2) }),
  hermite_arc_handle: ({ arc_len, turn }: Record<'arc_len' | 'turn', number>) => ({ h: arcHandle(arc_len, turn) }),
};
