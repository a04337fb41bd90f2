import validator, { type Report } from 'gltf-validator';
import { type Bone, type Mesh, Quaternion, Vector3 } from 'three';
import { describe, expect, it } from 'vitest';
import type { ExportOptions } from '../../../src/core/io/export-options.ts';
import { writeGlb } from '../../../src/core/io/glb/write-glb.ts';
import { yUpJoints } from '../../../src/core/io/glb/y-up.ts';
import { JOINT, placeJoints, skeletonOf } from '../../../src/core/mesh/skeleton.ts';
import { meshTree } from '../../../src/core/mesh/tree-mesh.ts';
import { growPacked } from '../../../src/core/pack/grow-packed.ts';
import { LoopedPoses } from '../../../src/core/wind/looped-poses.ts';
import { planeOf } from '../../../src/core/wind/pose-plainly.ts';
import type { Wind } from '../../../src/core/wind/wind.ts';
import { SMALL } from '../mesh/small-trees.ts';
import { GALE } from '../wind/some-winds.ts';
import { options, reload } from './glb-file.ts';

const trees = { aspen: growPacked(SMALL.aspen, 3), willow: growPacked(SMALL.willow, 3) } as const;

const validate = async (bytes: Uint8Array): Promise<Report['issues']> =>
  (await validator.validateBytes(bytes, { maxIssues: 0 })).issues;

const combinations: Partial<ExportOptions>[] = [];
for (const leaves of ['none', 'instances', 'expanded'] as const) {
  for (const lods of ['none', 'named', 'MSFT_lod'] as const) {
    for (const clip of [false, true]) {
      for (const quantize of [false, true]) combinations.push({ leaves, lods, clip, quantize });
    }
  }
}

describe('the validator finds no error and nothing to warn of', () => {
  it.each(combinations)('%o', async (more) => {
    for (const [i, grown] of Object.values(trees).entries()) {
      const textures = i === 0 && more.lods === 'none' ? '128' : 'none';
      const all = options({ ...more, textures, detail: i === 0 ? 'medium' : 'low', boneLevels: 1 + i, seconds: 2 });
      const issues = await validate(await writeGlb(grown, all, { wind: GALE }));
      expect(issues.messages.filter(({ severity }) => severity < 2)).toEqual([]);
      expect([issues.numErrors, issues.numWarnings]).toEqual([0, 0]);
    }
  });

  it.each(Object.keys(SMALL))('%s', async (name) => {
    for (const detail of ['low', 'high'] as const) {
      const grown = growPacked(SMALL[name], 5);
      const { numErrors, numWarnings } = await validate(
        await writeGlb(grown, options({ detail, clip: true, seconds: 1 })),
      );
      expect([numErrors, numWarnings]).toEqual([0, 0]);
    }
  });
});

/** Angle between two rotations, radians. */
const angle = (a: Quaternion, b: Quaternion): number =>
  2 * Math.asin(Math.min(1, Math.sqrt(1 - Math.min(1, a.dot(b) ** 2))));

describe.each(Object.entries(trees))('%s, read by three', (_, grown) => {
  const { packed } = grown;

  it('stands upright where it grew, within the box of the tree', async () => {
    const { box, scene } = await reload(grown, { detail: 'high' });
    const [x0, y0, z0, x1, y1, z1] = packed.bounds;
    for (const [at, least, most] of [
      [box.min, [x0, z0, -y1], [x1, z1, -y0]],
      [box.max, [x0, z0, -y1], [x1, z1, -y0]],
    ] as const) {
      at.toArray().forEach((x, k) => {
        expect(x).toBeGreaterThan(least[k] - 0.01);
        expect(x).toBeLessThan(most[k] + 0.01);
      });
    }
    const mesh = meshTree(grown, { detail: 'high' });
    const top = Math.max(...Array.from({ length: mesh.vertexCount }, (_, i) => mesh.position[3 * i + 2]));
    expect(box.max.y).toBeGreaterThanOrEqual(top - 1e-4);
    expect(scene.getObjectByName('tree')).toBeDefined();
  });

  it('has the same box however it is written', async () => {
    const plain = await reload(grown, {});
    const short = await reload(grown, { quantize: true });
    expect(short.box.min.distanceTo(plain.box.min)).toBeLessThan(1e-3);
    expect(short.box.max.distanceTo(plain.box.max)).toBeLessThan(1e-3);
    for (const quantize of [false, true]) {
      // three takes the box of each leaf's box: a little more than the leaf.
      const { box } = await reload(grown, { leaves: 'instances', quantize });
      expect(box.containsBox(plain.box.clone().expandByScalar(-1e-3))).toBe(true);
      expect(plain.box.clone().expandByScalar(0.1).containsBox(box)).toBe(true);
    }
  });

  it('has a node for each level of detail, each with fewer triangles', async () => {
    const { scene } = await reload(grown, { lods: 'named', detail: 'high' });
    const count = (name: string): number => {
      let triangles = 0;
      scene.getObjectByName(name)?.traverse((part) => {
        triangles += ((part as Mesh).geometry?.index?.count ?? 0) / 3;
      });
      return triangles;
    };
    const counts = ['tree_LOD0', 'tree_LOD1', 'tree_LOD2'].map(count);
    expect(counts[2]).toBeGreaterThan(50);
    expect(counts[1]).toBeGreaterThan(1.5 * counts[2]);
    expect(counts[0]).toBeGreaterThan(1.5 * counts[1]);
  });
});

/** Where the reference has the joints of a tree in a looped wind, y up. */
function reference(grown: (typeof trees)['aspen'], wind: Wind, levels: number, start: number, seconds: number) {
  const poses = new LoopedPoses(grown.packed, wind, start, seconds);
  const skeleton = skeletonOf(grown, levels);
  const plane = planeOf(grown.packed.restPose);
  return {
    skeleton,
    pose: (time: number) => poses.at(time),
    joints: (time: number) => yUpJoints(placeJoints(skeleton, poses.at(time), plane)),
  };
}

describe.each([
  ['aspen', 'spring', 2],
  ['aspen', 'spring', 3],
  ['aspen', 'direct', 2],
  ['willow', 'spring', 3],
  ['willow', 'sway', 2],
] as const)('the clip of %s by the model %s, bones on %i levels', (name, model, boneLevels) => {
  const grown = trees[name];
  const wind: Wind = { ...GALE, model };
  const [start, seconds, rate] = [2, 4, 30];
  const asked = { clip: true, boneLevels, start, seconds, rate, detail: 'medium' } as const;

  it('moves every bone as the reference, within a millimetre and a milliradian at each frame', async () => {
    const { skeleton, joints } = reference(grown, wind, boneLevels, start, seconds);
    const file = await reload(grown, asked, { wind });
    expect(file.animations).toHaveLength(1);
    expect(file.animations[0].duration).toBeCloseTo(seconds, 6);
    expect(file.animations[0].name).toBe(wind.name);
    const bones = new Map(file.bones().map((bone) => [bone.name, bone]));
    expect([...bones.keys()].sort()).toEqual([...skeleton.names].sort());
    const worst = (time: number) => {
      file.seek(time);
      const all = joints(time);
      const off = { place: 0, angle: 0 };
      skeleton.names.forEach((joint, j) => {
        const bone = bones.get(joint) as Bone;
        const [x, y, z, qx, qy, qz, qw] = all.subarray(JOINT * j, JOINT * j + JOINT);
        off.place = Math.max(off.place, bone.getWorldPosition(new Vector3()).distanceTo(new Vector3(x, y, z)));
        off.angle = Math.max(
          off.angle,
          angle(bone.getWorldQuaternion(new Quaternion()), new Quaternion(qx, qy, qz, qw)),
        );
      });
      return off;
    };
    for (const frame of [0, 1, 7, 30, 61, 90, 119]) {
      const off = worst(frame / rate);
      expect(off.place).toBeLessThan(1e-3);
      expect(off.angle).toBeLessThan(1e-3);
    }
    // Between two frames a key's straight way cuts the corner of a swing: by less than two centimetres and half a degree.
    for (const frame of [0.5, 13.5, 61.3, 99.7]) {
      const off = worst(frame / rate);
      expect(off.place).toBeLessThan(2e-2);
      expect(off.angle).toBeLessThan(0.01);
    }
  });

  it('ends as it begins, key for key', async () => {
    const { animations } = await reload(grown, asked, { wind });
    expect(animations[0].tracks.length).toBeGreaterThan(10);
    for (const { times, values } of animations[0].tracks) {
      const size = values.length / times.length;
      expect(times[0]).toBe(0);
      expect(times.at(-1)).toBeCloseTo(seconds, 6);
      expect(values.slice(-size)).toEqual(values.slice(0, size));
      expect(values.every(Number.isFinite)).toBe(true);
    }
  });

  it('bends the skin as the deformer bends the surface: where bones are, to a part of the stem', async () => {
    const { pose } = reference(grown, wind, boneLevels, start, seconds);
    const file = await reload(grown, { ...asked, leaves: 'none' }, { wind });
    for (const time of [0, 1.7]) {
      const bent = meshTree(grown, {
        detail: 'medium',
        leaves: false,
        pose: pose(time).slice(),
        leastBands: 3,
        bentLevels: boneLevels,
      });
      const rest = meshTree(grown, { detail: 'medium', leaves: false, leastBands: 3, bentLevels: boneLevels });
      file.seek(time);
      const at = new Vector3();
      let first = 0;
      const off: number[] = [];
      const moved: number[] = [];
      for (const mesh of file.skinned()) {
        const count = mesh.geometry.attributes.position.count;
        for (let i = 0; i < count; i++) {
          const v = first + i;
          if (bent.level[v] >= boneLevels) continue;
          mesh.getVertexPosition(i, at).applyMatrix4(mesh.matrixWorld);
          const [x, y, z] = bent.position.subarray(3 * v, 3 * v + 3);
          off.push(at.distanceTo(new Vector3(x, z, -y)));
          moved.push(Math.hypot(...[0, 1, 2].map((k) => bent.position[3 * v + k] - rest.position[3 * v + k])));
        }
        first += count;
      }
      expect(first).toBe(bent.vertexCount);
      const mean = (list: number[]) => list.reduce((a, b) => a + b, 0) / list.length;
      expect(mean(moved)).toBeGreaterThan(0.005);
      // A twenty-fifth of the way on the mean, and nowhere more than a tenth of the farthest.
      expect(mean(off)).toBeLessThan(0.04 * mean(moved));
      expect(Math.max(...off)).toBeLessThan(0.1 * Math.max(...moved));
    }
  });
});

describe('leaves of a clip', () => {
  it('ride on their bones alike, as triangles and as instances', async () => {
    const wind: Wind = { ...GALE, model: 'direct' };
    const boxes = await Promise.all(
      (['expanded', 'instances'] as const).map(async (leaves) => {
        const file = await reload(trees.aspen, { clip: true, leaves, seconds: 2 }, { wind });
        file.seek(0.9);
        return file;
      }),
    );
    const [expanded, instances] = boxes.map(({ scene }) => {
      let leaves = 0;
      scene.traverse((part) => {
        if ('isInstancedMesh' in part) leaves += (part as unknown as { count: number }).count;
      });
      return leaves;
    });
    expect(expanded).toBe(0);
    expect(instances).toBe(trees.aspen.packed.leafCount);
  });
});

it('writes the same bytes each time, and tells where the tree comes from', async () => {
  const [a, b] = await Promise.all(
    [0, 1].map(() => writeGlb(trees.aspen, options({ textures: '128', link: 'https://example.org/#s=x' }))),
  );
  expect(b).toEqual(a);
  const text = new TextDecoder().decode(a.subarray(20, 20 + new DataView(a.buffer, a.byteOffset).getUint32(12, true)));
  const json = JSON.parse(text);
  expect(json.asset.generator).toBe('Windgrove');
  expect(json.extras).toMatchObject({ species: 'Quaking Aspen', seed: 3, link: 'https://example.org/#s=x' });
});
