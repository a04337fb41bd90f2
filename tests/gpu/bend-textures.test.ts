import { expect, test } from 'vitest';
import { springTexels } from '../../src/core/wind/spring-texels.ts';
import { swayTexels } from '../../src/core/wind/sway.ts';
import { STILL } from '../../src/core/wind/wind.ts';
import { BendTextures } from '../../src/gpu/bend-textures.ts';
import { syntheticTree } from '../../src/gpu/crosscheck/synthetic-tree.ts';
import { RecordTextures } from '../../src/gpu/record-texture.ts';

const tree = syntheticTree(60, 3);

test('springs are made anew when their settings or the stiffness change, in the same texture, and else not', () => {
  const bend = new BendTextures(tree);
  const texture = bend.springs({ spring: STILL.spring, softness: 1 });
  const { version } = texture;
  expect(texture.image.data).toEqual(springTexels(tree, STILL.spring).data);
  expect(bend.springs({ spring: structuredClone(STILL.spring), softness: 1 })).toBe(texture);
  expect(texture.version).toBe(version);
  const spring = { ...STILL.spring, levels: [{ frequency: 2, damping: null }] };
  expect(bend.springs({ spring, softness: 1 })).toBe(texture);
  expect(texture.version).toBe(version + 1);
  expect(texture.image.data).toEqual(springTexels(tree, spring).data);
  expect(bend.bytes).toBe(springTexels(tree, spring).data.byteLength);
});

test('a fade of the stiffness makes them anew now and then, and when it stands still exactly', () => {
  const bend = new BendTextures(tree);
  const { spring } = STILL;
  const texture = bend.springs({ spring, softness: 1 });
  const { version } = texture;
  for (let i = 1; i <= 60; i++) bend.springs({ spring, softness: 1 + i / 100 });
  expect(texture.version - version).toBeLessThan(31);
  expect(texture.version - version).toBeGreaterThan(10);
  bend.springs({ spring, softness: 1.6 });
  expect(texture.image.data).toEqual(springTexels(tree, spring, 1 / 1.6).data);
});

test('swaying follows what sets frequencies alone', () => {
  const bend = new BendTextures(tree);
  const sway = { ...STILL.sway };
  const texture = bend.sways({ sway });
  const { version } = texture;
  sway.speed = 40;
  bend.sways({ sway });
  expect(texture.version).toBe(version);
  sway.rate = 30;
  bend.sways({ sway });
  expect(texture.version).toBe(version + 1);
  expect(texture.image.data).toEqual(swayTexels(tree, sway).data);
});

test('a record is one texture as long as it blows, and the oldest of many goes', () => {
  const records = new RecordTextures();
  const samples = Array.from({ length: 6 }, () => new Float32Array(4 * 1024 * 2));
  const first = records.of(samples[0]!)!;
  expect([first.image.width, first.image.height]).toEqual([1024, 2]);
  expect(records.of(samples[0]!)).toBe(first);
  const gone: number[] = [];
  samples.forEach((sample, i) => {
    records.of(sample)!.addEventListener('dispose', () => gone.push(i));
    records.of(samples[0]!); // the one that blows all the time stays
  });
  expect(gone).toEqual([1, 2]);
  expect(records.of(null)).toBeNull();
});
