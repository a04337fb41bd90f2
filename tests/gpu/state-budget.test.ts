import { expect, test } from 'vitest';
import { checkpointsFor, isSoftware, LEAST_STEPS, sliceFor } from '../../src/gpu/state-budget.ts';

test('checkpoints stay within some megabytes, but never fewer than it takes to seek', () => {
  for (const pieces of [16 * 16, 32 * 32, 256 * 256, 1024 * 1024]) {
    const count = checkpointsFor(48 * pieces);
    expect(count).toBeGreaterThanOrEqual(4);
    expect(count).toBeLessThanOrEqual(48);
    if (count > 4) expect(count * 48 * pieces).toBeLessThanOrEqual(24 * 2 ** 20);
  }
});

test('a slice is at least the longest frame of the fastest clock, and at most what a frame bears', () => {
  expect(LEAST_STEPS).toBeGreaterThan(0.25 * 2 * 60);
  expect(sliceFor(100, true)).toBe(400);
  expect(sliceFor(10_000, true)).toBe(52);
  expect(sliceFor(10_000, false)).toBe(400);
  expect(sliceFor(1_000_000, true)).toBe(LEAST_STEPS);
});

test('a software renderer is known by its name', () => {
  expect(isSoftware('ANGLE (Google, Vulkan 1.3.0 (SwiftShader Device (Subzero)), SwiftShader driver)')).toBe(true);
  expect(isSoftware('llvmpipe (LLVM 15.0.7, 256 bits)')).toBe(true);
  expect(isSoftware('ANGLE (NVIDIA, NVIDIA GeForce RTX 3060 Direct3D11 vs_5_0 ps_5_0)')).toBe(false);
});
