import { describe, expect, test } from 'vitest';
import { DEFAULT_EXPORT } from '../../../src/core/io/export-options.ts';
import { exportTree } from '../../../src/core/io/export-tree.ts';
import { meshBark } from '../../../src/core/mesh/bark-mesh.ts';
import { growPacked } from '../../../src/core/pack/grow-packed.ts';
import { createWindState, windStateAt } from '../../../src/core/wind/fade.ts';
import { windForce } from '../../../src/core/wind/force.ts';
import { STILL } from '../../../src/core/wind/wind.ts';
import { estimateOf, meshesOf } from '../../../src/editor/export/estimate.ts';
import { roundCount, sizeText } from '../../../src/editor/export/figures.ts';
import { filmOf } from '../../../src/editor/export/film.ts';
import { choicesOf } from '../../../src/editor/export/kinds.ts';
import { PICTURE_PARAMETERS, readPictureOptions } from '../../../src/editor/export/picture-options.ts';
import { frameName } from '../../../src/editor/export/sequence.ts';
import type { ShownTree } from '../../../src/editor/session.ts';
import { shippedSpecies } from '../../core/pack/shipped-species.ts';
import { GALE } from '../../core/wind/some-winds.ts';

describe('a film', () => {
  test('has its frames at exact times, whatever a sum of steps would give', () => {
    const { times } = filmOf(GALE, 2, { rate: 30, seconds: 10, loop: false });
    expect(times).toHaveLength(300);
    expect(times[299]).toBe(2 + 299 / 30);
  });

  test('that comes around has a wind that does, over exactly its frames', () => {
    const waves = { ...GALE, gusts: [], model: 'direct' as const };
    const { times, wind, open } = filmOf(waves, 3, { rate: 24, seconds: 4.02, loop: true });
    expect(open).toEqual([]);
    const seconds = times.length / 24;
    for (const t of [3, 3.7, 5.5]) {
      const [now, later] = [t, t + seconds].map((time) =>
        windForce(windStateAt(wind, time, undefined, createWindState()), 1, 2, 5),
      );
      expect(Math.hypot(now![0] - later![0], now![1] - later![1])).toBeLessThan(1e-5);
      expect(Math.hypot(...now!)).toBeGreaterThan(0);
    }
  });

  test('of branches that swing begins when they are in the swing of the wind', () => {
    const { times } = filmOf({ ...GALE, model: 'spring' }, 0, { rate: 10, seconds: 1, loop: true });
    expect(times[0]).toBe(12);
  });

  test('of less than a frame has one', () => {
    expect(filmOf({ ...GALE, model: 'direct' }, 0, { rate: 1, seconds: 0.1, loop: true }).times).toEqual([0]);
  });
});

test('frames are numbered so that they sort as they come', () => {
  expect(frameName('aspen-3', 0, 12)).toBe('aspen-3-0001.png');
  expect(frameName('aspen-3', 12_344, 12_345)).toBe('aspen-3-12345.png');
});

test('sizes and counts as people say them', () => {
  expect([0, 999, 1500, 34_400_000, 999_600_000].map(sizeText)).toEqual([
    '0\u2009B',
    '999\u2009B',
    '1.5\u2009kB',
    '34\u2009MB',
    '1.0\u2009GB',
  ]);
  expect([7, 99, 31_943, 1_451_160].map(roundCount)).toEqual(['7', '99', '32\u2009000', '1.5 million']);
});

describe('what is remembered', () => {
  test('is used where it is allowed, each choice by itself', () => {
    const read = readPictureOptions({ width: 640, height: -1, rate: 'fast', transparent: true, more: 1 });
    expect(read).toMatchObject({ width: 640, height: 1080, rate: 30, transparent: true });
    expect(Object.keys(read)).toEqual(PICTURE_PARAMETERS.map((row) => row.key));
  });

  test('of an export that is broken is forgotten as a whole', () => {
    const exports = { glb: { detail: 'high', format: 'obj', nonsense: 1 }, obj: { detail: 'finest' } };
    expect(choicesOf('glb', { exports })).toMatchObject({ format: 'glb', detail: 'high' });
    expect(choicesOf('obj', { exports })).toMatchObject({ format: 'obj', detail: 'medium' });
  });
});

test('an estimate foretells the file within a third, and its triangles', async () => {
  const species = shippedSpecies('quaking-aspen');
  const grown = growPacked(species, 3);
  const figures = { levels: grown.stats.levels.length, leaves: grown.packed.leafCount };
  const tree = { species, base: species, seed: 3, stems: grown.stems, figures } as unknown as ShownTree;
  for (const change of [
    {},
    { leaves: 'none', textures: 'none' },
    { leaves: 'instances', textures: '128' },
    { quantize: true, textures: 'none' },
    { lods: 'named', textures: 'none' },
    { clip: true, leaves: 'none', textures: 'none' },
  ] as const) {
    const options = { ...DEFAULT_EXPORT, ...change };
    const meshes = meshesOf('glb', options).map((mesh) => {
      const { vertexCount, triangleCount } = meshBark(grown, mesh);
      return { vertices: vertexCount, triangles: triangleCount };
    });
    const [file] = await exportTree(species, 3, STILL, options);
    const foretold = estimateOf('glb', tree, options, meshes)!.bytes! / file!.bytes.length;
    expect(Math.abs(foretold - 1), JSON.stringify(change)).toBeLessThan(1 / 3);
  }
  expect(estimateOf('species', tree, DEFAULT_EXPORT, null)).toBeNull();
});
