import type { WebGLRenderer } from 'three';
import { expect, test } from 'vitest';
import { createWindState } from '../../src/core/wind/fade.ts';
import { poseTreePlainly } from '../../src/core/wind/pose-plainly.ts';
import { SpringRun } from '../../src/core/wind/spring-run.ts';
import { CpuPoser } from '../../src/gpu/cpu-poser.ts';
import { syntheticTree } from '../../src/gpu/crosscheck/synthetic-tree.ts';
import { TreeTextures } from '../../src/gpu/tree-textures.ts';
import { windSource } from '../../src/gpu/wind-source.ts';
import { directWind } from '../core/wind/shipped-winds.ts';

const tree = syntheticTree(200, 4);
const [gale, still] = ['gale', 'still'].map(directWind);
const noRenderer = null as unknown as WebGLRenderer; // the CPU needs none

test('the CPU writes the pose of the time into the very textures that the deformer reads, and uploads only what is new', () => {
  const textures = new TreeTextures(tree, false);
  const poser = new CpuPoser(textures);
  const source = windSource(gale);
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
  poser.update(noRenderer, 8, windSource(still));
  const moved = poser.read(noRenderer).map((value, i) => Math.abs(value - tree.restPose.data[i]!));
  expect(Math.max(...moved)).toBeLessThan(1e-5);
});

test('each document has a revision of its own', () => {
  const revisions = [gale, gale, still].map((wind) => windSource(wind).revision);
  expect(new Set(revisions).size).toBe(3);
});

test('springs swing on the CPU as the reference runs them; a far jump takes some updates and gives what playing gives', () => {
  const source = windSource({ ...gale, model: 'spring' });
  const run = new SpringRun(tree, source.fill);
  const [played, sought] = [0, 1].map(() => new CpuPoser(new TreeTextures(tree, false)));
  for (let n = 0; n <= 900; n++) played.update(noRenderer, n / 60, source);
  expect(played.readState()).toEqual(run.stepTo(900));
  let updates = 0;
  do {
    sought.update(noRenderer, 15, source);
    updates++;
  } while (sought.catchingUp !== null);
  expect(updates).toBeGreaterThan(1);
  expect(sought.read(noRenderer)).toEqual(played.read(noRenderer));
  const wind = createWindState();
  source.fill(15.01, wind);
  sought.update(noRenderer, 15.01, source);
  const wanted = poseTreePlainly(tree, wind, 'exact', undefined, undefined, run.bendsAt(15.01));
  const far = sought.read(noRenderer).map((value, i) => Math.abs(value - wanted[i]!));
  expect(Math.max(...far)).toBeLessThan(1e-5);
});

test('swaying on the CPU is a function of time; pose and pieces are read back', async () => {
  const source = windSource({ ...gale, model: 'sway', sway: { speed: 30, gust: 10, reading: 'ratio', rate: 67 } });
  const poser = new CpuPoser(new TreeTextures(tree, false));
  const poses = [3, 9, 3].map((time) => {
    poser.update(noRenderer, time, source);
    return poser.read(noRenderer);
  });
  expect(poses[0]).toEqual(poses[2]);
  expect(poses[0]).not.toEqual(poses[1]);
  const { pose, state } = await poser.readBack(noRenderer);
  expect(state).toBeNull();
  expect(pose).toEqual(poses[2]);
  const piece = await poser.readPiece(noRenderer, 7);
  expect(piece!.subarray(12)).toEqual(pose.subarray((3 * pose.length) / 4 + 28, (3 * pose.length) / 4 + 32));
  expect(await poser.readPiece(noRenderer, 200)).toBeNull();
});
