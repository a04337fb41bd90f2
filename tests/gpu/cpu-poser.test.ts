import type { WebGLRenderer } from 'three';
import { expect, test } from 'vitest';
import { createWindState } from '../../src/core/wind/fade.ts';
import { poseTreePlainly } from '../../src/core/wind/pose-plainly.ts';
import { presets } from '../../src/core/wind/presets.ts';
import { CpuPoser } from '../../src/gpu/cpu-poser.ts';
import { syntheticTree } from '../../src/gpu/crosscheck/synthetic-tree.ts';
import { TreeTextures } from '../../src/gpu/tree-textures.ts';
import { windSource } from '../../src/gpu/wind-source.ts';

const tree = syntheticTree(200, 4);
const noRenderer = null as unknown as WebGLRenderer; // the CPU needs none

test('the CPU writes the pose of the time into the very textures that the deformer reads, and uploads only what is new', () => {
  const textures = new TreeTextures(tree, false);
  const poser = new CpuPoser(textures);
  const source = windSource(presets.gale);
  const written = textures.uniforms.poseEven.value;
  const dataOf = (target: number): Float32Array => (written[target].image as { data: Float32Array }).data;
  expect(textures.uniforms.poseOdd.value).toEqual(written);
  expect(dataOf(0)).toEqual(tree.restPose.data.subarray(0, dataOf(0).length));

  poser.update(noRenderer, 7, source);
  const wind = createWindState();
  source.fill(7, wind);
  const wanted = poseTreePlainly(tree, wind, 'exact');
  const floats = wanted.length / 4;
  for (let target = 0; target < 4; target++) {
    const far = dataOf(target).map((value, i) => Math.abs(value - wanted[target * floats + i]));
    expect(Math.max(...far)).toBeLessThan(1e-5);
  }
  expect(poser.read(noRenderer)).not.toEqual(tree.restPose.data);

  const versions = written.map((texture) => texture.version);
  poser.update(noRenderer, 7, source);
  expect(written.map((texture) => texture.version)).toEqual(versions);
  poser.update(noRenderer, 8, source);
  expect(written.map((texture) => texture.version)).not.toEqual(versions);
  poser.update(noRenderer, 8, windSource(presets.still));
  expect(poser.read(noRenderer)).toEqual(tree.restPose.data);
});

test('each document has a revision of its own', () => {
  const revisions = [presets.gale, presets.gale, presets.still].map((wind) => windSource(wind).revision);
  expect(new Set(revisions).size).toBe(3);
});
