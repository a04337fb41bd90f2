import type { HeightProfile } from './wind.ts';

/** How the wind grows with height. Twin: the uniforms of shaders/wind/profile.glsl. */
export interface ProfileUniforms {
  /** 0: the same wind at all heights, and `profile` is not read. */
  profiled: 0 | 1;
  /** 1/height | slope of the logarithm a doubling | exponent of the power law | weight of the logarithm, 0..1; the power law has the rest. */
  profile: Float32Array;
}

export const createProfileUniforms = (): ProfileUniforms => ({ profiled: 0, profile: new Float32Array(4) });

/** Parts of the height that count as the ground: what a logarithm of 0 is read as. Both laws are as good as 0 there. */
const GROUND = 2 ** -40;

/**
 * Factor on the wind at `z` metres above the ground: 1 at the profile's height. w max(0, 1 + b log2 z/h) + (1 - w) (z/h)^a: with w = 1 the
 * logarithmic law ln(z/z0)/ln(h/z0), nothing below the roughness length z0; with w = 0 the power law; between them while one fades into
 * the other. Source: Stull 1988, "An Introduction to Boundary Layer Meteorology", 9.7. Twin: shaders/wind/profile.glsl.
 */
export function profileFactor({ profile }: ProfileUniforms, z: number): number {
  const l = Math.log2(Math.max(z * profile[0], GROUND));
  return profile[3] * Math.max(0, 1 + profile[1] * l) + (1 - profile[3]) * 2 ** (profile[2] * l);
}

interface Law {
  /** log2 of the height. */
  height: number;
  slope: number;
  exponent: number;
  log: number;
}

/** Of `none`: a power law whose exponent is 0, at the other one's height, so that fading from it moves nothing else. */
function lawOf(profile: HeightProfile, other: HeightProfile): Law {
  const own = profile.kind === 'none' ? other : profile;
  // A height within the roughness would have no wind to compare with: at least twice the roughness length.
  const slope = ({ height, roughness }: HeightProfile) => 1 / Math.max(1, Math.log2(height / roughness));
  return {
    height: Math.log2(own.height),
    // A law without a logarithm has the other's slope, one without a power the other's exponent: only the weight fades.
    slope: slope(profile.kind === 'log' ? profile : other),
    exponent:
      profile.kind === 'power'
        ? profile.exponent
        : profile.kind === 'log' && other.kind === 'power'
          ? other.exponent
          : 0,
    log: profile.kind === 'log' ? 1 : 0,
  };
}

/** Writes the profile that is `h` (0..1) of the way from one to another to `out`: its factor is continuous in h at every height. */
export function fillProfile(out: ProfileUniforms, to: HeightProfile, from = to, h = 1): void {
  out.profiled = from.kind === 'none' && to.kind === 'none' ? 0 : 1;
  if (out.profiled === 0) return;
  const a = lawOf(from, to);
  const b = lawOf(to, from);
  const mix = (x: number, y: number): number => x + (y - x) * h;
  out.profile[0] = 2 ** -mix(a.height, b.height);
  out.profile[1] = mix(a.slope, b.slope);
  out.profile[2] = mix(a.exponent, b.exponent);
  out.profile[3] = mix(a.log, b.log);
}
