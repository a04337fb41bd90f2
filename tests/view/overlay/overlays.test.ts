import { describe, expect, it } from 'vitest';
import { growPacked } from '../../../src/core/pack/grow-packed.ts';
import { PIECE_LAYERS, TEXEL } from '../../../src/core/pack/layout.ts';
import { lattice } from '../../../src/view/overlay/arrows.ts';
import { Handle } from '../../../src/view/overlay/handle.ts';
import { overlayUniforms } from '../../../src/view/overlay/overlay-material.ts';
import { isOdd, stemPieces } from '../../../src/view/overlay/stem-pieces.ts';
import { shippedSpecies } from '../../core/pack/shipped-species.ts';

const { packed } = growPacked(shippedSpecies('quaking-aspen'), 1);

describe('arrows', () => {
  it('stand on a lattice within the circle, all as far apart', () => {
    const spots = lattice(6);
    const points = Array.from({ length: spots.length / 2 }, (_, i) => [spots[2 * i]!, spots[2 * i + 1]!] as const);
    expect(points.length).toBeGreaterThan(100);
    for (const [x, y] of points) {
      expect(Math.hypot(x, y)).toBeLessThanOrEqual(1 + 1e-6);
      const nearest = Math.min(...points.map(([u, v]) => Math.hypot(u - x, v - y) || 9));
      expect(nearest).toBeCloseTo(1 / 6, 5);
    }
  });
});

describe('wind handle', () => {
  it('stands upwind, farther out the stronger it blows, and what it says it is set to', () => {
    const handle = new Handle(overlayUniforms());
    handle.fit(10, 3);
    for (const [direction, strength] of [
      [0.4, 0.25],
      [-2.5, 1],
      [3, 0],
    ] as const) {
      const radius = handle.radiusOf(strength);
      const place = handle.placeOf(-radius * Math.cos(direction), -radius * Math.sin(direction));
      expect(place.direction).toBeCloseTo(direction, 6);
      expect(place.strength).toBeCloseTo(strength, 6);
    }
    expect(handle.placeOf(-1000, 0)).toEqual({ direction: Math.atan2(-0, 1000), strength: 1 });
    expect(handle.placeOf(0.01, 0).strength).toBe(0);
  });
});

describe('pieces of a stem', () => {
  it('are a chain from the base on, the whole of it, whichever of them is asked for', () => {
    const plane = packed.pieces.width * packed.pieces.height * TEXEL;
    const parentOf = (i: number) => packed.pieces.data[PIECE_LAYERS.ATTACH * plane + i * TEXEL];
    const stems = Array.from({ length: packed.pieceCount }, (_, i) => stemPieces(packed, i));
    const stem = stems.reduce((long, other) => (other.length > long.length ? other : long));
    expect(stem.length).toBeGreaterThan(4);
    for (let k = 4; k < stem.length; k += 4) {
      expect(parentOf(stem[k]!)).toBe(stem[k - 4]);
      expect(stem[k + 2]).toBeCloseTo(stem[k - 1]!, 6); // as thick where it goes on
    }
    for (const piece of [stem[4]!, stem[stem.length - 4]!]) expect(stemPieces(packed, piece)).toEqual(stem);
  });

  it('know whether their depth is odd', () => {
    for (let depth = 0; depth + 1 < packed.depthStart.length; depth++) {
      const [first, end] = [packed.depthStart[depth]!, packed.depthStart[depth + 1]!];
      for (const piece of [first, end - 1]) expect(isOdd(packed, piece)).toBe(depth % 2 === 1);
    }
  });
});
