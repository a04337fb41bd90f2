import { aboutX, aboutZ } from '../../../src/core/deform/generator.ts';
import type { Cubic } from '../../../src/core/math/bezier.ts';
import { distance, type Mat3, multiply, type Vec3 } from '../../../src/core/math/vec3.ts';
import {
  type AttachAngles,
  anglesOfWeberPenn,
  attachByAngles,
  decomposeAttachment,
  rotationOfAngles,
} from '../../../src/core/wind/attach-angles.ts';
import { bendStep, bendVector, bendWeights, weightedPush } from '../../../src/core/wind/bend.ts';
import {
  appendWaves,
  createForceUniforms,
  type ForceUniforms,
  linearWindForce,
  meanPush,
  windForce,
} from '../../../src/core/wind/force.ts';
import { swayParts, swayRate, swayReach, swaySine } from '../../../src/core/wind/sway.ts';
import { STILL, type Wave, type Wind } from '../../../src/core/wind/wind.ts';
import { type Adapters, cubicOf, type Points, pointsOf, TAU, transposed } from './case.ts';

interface CaseWave {
  A: number;
  D: [number, number];
  w: number;
  phi: number;
  k: number;
  phase0?: number;
}

interface Blowing {
  waves: CaseWave[];
  x: number;
  y: number;
  t: number;
  l: number;
  sign: 1 | -1;
  gain: number;
  zero_mean?: boolean;
}

/** A case's phase grows with phase0 + sign * t * phi; a wave's with minus its own, except in the paper's direction of travel. */
const waveOf = ({ A, D, w, phi, k, phase0 = 0 }: CaseWave, sign: 1 | -1): Wave => ({
  on: true,
  solo: false,
  amplitude: A,
  direction: Math.atan2(D[1], D[0]),
  wavelength: TAU / w,
  speed: phi / w,
  sharpness: k,
  phase: (sign * phase0) / TAU,
});

/** The force of a case as the product has it, in double. */
function forceOf({ waves, sign, t, zero_mean: zeroMean = false }: Blowing): ForceUniforms {
  const wind: Wind = { ...STILL, waves: waves.map((wave) => waveOf(wave, sign)), zeroMean, paper: sign > 0 };
  const out = { ...createForceUniforms(), waves: new Float64Array(32), phases: new Float64Array(32) };
  return appendWaves(out, wind, t, 1);
}

/** Weights of a whole stem. */
const WHOLE = bendWeights(0, 1);

/** The cases take the force as the displacement b = l beta of each edge's end: the push on a direction is b over the edge's length. */
function bent(c: Cubic, force: Vec3, p: number): Cubic {
  const b = bendVector(force[0], force[1], 1, p, 0);
  const per = (weight: number, l: number): number => (l > 0 ? weight / l : 0);
  return bendStep(c, weightedPush(b, [per(WHOLE[0], distance(c.p1, c.p2)), per(WHOLE[1], distance(c.p2, c.p3))]));
}

interface Attached extends AttachAngles {
  P: Points;
  O: Vec3;
  v: number;
  local: Points;
  frames: string;
}

export const wind: Adapters = {
  wind_force: (input: Blowing) => ({
    F: windForce(forceOf(input), input.x, input.y, 0).map((n) => (n * input.gain) / input.l),
  }),
  wind_linear: (input: Blowing) => ({ F: linearWindForce(forceOf(input), input.x, input.y) }),
  mean_pow: ({ k }: { k: number[] }) => ({ m: k.map(meanPush) }),
  bend_step: ({ P, F, p }: { P: Points; F: Vec3; p: number }) => ({ P: pointsOf(bent(cubicOf(P), F, p)) }),
  bend_step_chain: ({ P, beta, k, n }: { P: Points; beta: Vec3; k: number; n: number }) => {
    const w = bendWeights(k / n, (k + 1) / n);
    return { w, P: pointsOf(bendStep(cubicOf(P), weightedPush(beta, w))) };
  },
  // The cases take offset and rate in degrees, as the paper may be read.
  wp_sway_deg: ({ L, rstem, rZ, Z, nres, speed, gust, offx, offy, time, rate }: Record<string, number>) => {
    const turned = swayRate({ reading: 'ratio', rate }, rstem, L) * time;
    const sine = (offset: number) => swaySine(swayParts(speed, gust), ((offset + turned) * TAU) / 360);
    return { xy: [offx, offy].map((offset) => (swayReach(L, rZ, Z) * sine(offset)) / nres) };
  },
  attach: ({ P, O, v, local, frames, ...angles }: Attached) => {
    const a = attachByAngles(cubicOf(P), O, v, angles, cubicOf(local), frames === 'sloan');
    return { P: pointsOf(a.curve), O: a.o, R: transposed(a.axes) };
  },
  attach_decompose: ({ P, O, v, R, frames }: { P: Points; O: Vec3; v: number; R: Mat3; frames: string }) => {
    const { theta, alpha, roll } = decomposeAttachment(cubicOf(P), O, v, transposed(R), frames === 'sloan');
    return { theta, alpha, roll };
  },
  attach_wp: ({ rotate_deg, down_deg }: { rotate_deg: number; down_deg: number }) => {
    const rotate = (rotate_deg * TAU) / 360;
    const down = (down_deg * TAU) / 360;
    const angles = anglesOfWeberPenn(rotate, down);
    // The trunk's section frame (U, T^, S^) is (z, y, -x) in the frame of its stem.
    const trunk: Mat3 = [
      [0, 0, 1],
      [0, 1, 0],
      [-1, 0, 0],
    ];
    return {
      theta: angles.theta,
      alpha: angles.alpha,
      R_wp: transposed(multiply(aboutZ(rotate), aboutX(down))),
      R_skj: transposed(multiply(trunk, rotationOfAngles(angles))),
    };
  },
  hierarchy: ({ root, F, children }: { root: { P: Points; O: Vec3 }; F: Vec3; children: Attached[] }) => {
    let parent = { curve: bent(cubicOf(root.P), F, 1), o: root.O };
    const all = [parent];
    for (const child of children) {
      const placed = attachByAngles(parent.curve, parent.o, child.v, child, cubicOf(child.local));
      parent = { curve: bent(placed.curve, F, 1), o: placed.o };
      all.push(parent);
    }
    return { P: all.map(({ curve }) => pointsOf(curve)), O: all.map(({ o }) => o) };
  },
};
