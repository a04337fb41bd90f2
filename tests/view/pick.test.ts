import { Ray, Vector3 } from 'three';
import { describe, expect, it } from 'vitest';
import { growPacked } from '../../src/core/pack/grow-packed.ts';
import { TEXEL } from '../../src/core/pack/layout.ts';
import { pickBranch } from '../../src/view/pick.ts';
import { shippedSpecies } from '../core/pack/shipped-species.ts';

const { packed } = growPacked(shippedSpecies('quaking-aspen'), 1);
const places = packed.pieceCount;
const plane = packed.restPose.width * packed.restPose.height * TEXEL;
const level = (x: number, z: number): Ray => new Ray(new Vector3(x, -30, z), new Vector3(0, 1, 0));

describe('picking a branch', () => {
  it('finds the trunk at rest, and beside it nothing', () => {
    expect(pickBranch(packed, level(0, 1), { places })?.piece).toBe(0);
    expect(pickBranch(packed, level(3, 1), { places })).toBeNull();
  });

  it('finds it where a pose has it', () => {
    const pose = packed.restPose.data.slice();
    for (let k = 0; k < 4; k++) for (let i = 0; i < places; i++) pose[k * plane + i * TEXEL]! += 3;
    expect(pickBranch(packed, level(0, 1), { places, pose })).toBeNull();
    expect(pickBranch(packed, level(3, 1), { places, pose })?.piece).toBe(0);
  });

  it('takes what is nearest beside the ray where none is hit, within reach', () => {
    const base = 0.2;
    expect(pickBranch(packed, level(base + 0.3, 1), { places, near: 0.02 })?.piece).toBe(0);
    expect(pickBranch(packed, level(base + 0.3, 1), { places, near: 0.001 })).toBeNull();
    // What is hit goes before what is passed by, however near that is.
    expect(pickBranch(packed, level(0, 1), { places, near: 1 })?.piece).toBe(0);
  });
});
