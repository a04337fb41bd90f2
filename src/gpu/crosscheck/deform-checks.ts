import { Vector2, Vector3, Vector4, type WebGLRenderer } from 'three';
import branchVertex from '../../../shaders/debug/check-branch.vert';
import leafVertex from '../../../shaders/debug/check-leaf.vert';
import { collar } from '../../core/deform/collar.ts';
import { type Shape, stemRadius } from '../../core/deform/radius.ts';
import { surfacePoint } from '../../core/deform/surface.ts';
import { bezierPoint } from '../../core/math/bezier.ts';
import { handlesOf, sectionFrame } from '../../core/math/frames.ts';
import { rotateByQuaternion } from '../../core/math/quaternion.ts';
import { add, scale, transform, type Vec3 } from '../../core/math/vec3.ts';
import { BRANCH_LAYERS } from '../../core/pack/layout.ts';
import { leafTexel } from '../../core/pack/leaf-texel.ts';
import type { PackedTree, TexelArray } from '../../core/pack/packed.ts';
import { layerStart } from '../../core/pack/texel-array.ts';
import { planeOf, poseOf } from '../../core/wind/pose-plainly.ts';
import type { Wind } from '../../core/wind/wind.ts';
import { STEP } from '../step.ts';
import { TreeTextures } from '../tree-textures.ts';
import { WindPass } from '../wind-pass.ts';
import { windSource } from '../wind-source.ts';
import { compareLine, PARTS } from './compare.ts';
import { between, direction, type Random, randomStream } from './random.ts';
import { Reference } from './reference.ts';
import type { Check } from './report.ts';
import { runVertices, type VertexRun } from './run-vertices.ts';

/** Everything that a stem's radius may have, so that each term is compared. */
const SHAPE: Shape = { taper: 1.2, flare: 0.7, lobes: 5, lobeDepth: 0.1, lobeFade: 0.6, bulges: 3, bulgeDepth: 0.06 };

/** A cone, the one shape that PLAIN_STEM knows. */
const CONE: Shape = { taper: 0.95, flare: 0, lobes: 0, lobeDepth: 0, lobeFade: 0, bulges: 0, bulgeDepth: 0 };

/** The deformer with every term, and the two variants that trees are drawn with (definesOf in src/view/tree-parts.ts). */
const BARKS: readonly { readonly what: string; readonly shape: Shape; readonly defines: Record<string, number> }[] = [
  { what: 'bark', shape: SHAPE, defines: {} },
  { what: 'bark of a trunk', shape: SHAPE, defines: { FLARED: 1 } },
  { what: 'bark of a plain stem', shape: CONE, defines: { PLAIN_STEM: 1 } },
];

/** How much wider a stem is where it leaves its parent. */
const COLLAR = 0.4;

const STEP_NUMBER = 100;
const VERTICES = 6000;

type Vertices = Pick<VertexRun, 'attributes'> & { readonly twin: Float64Array };

const texel = (array: TexelArray, layer: number, i: number): number[] => [
  ...array.data.subarray(layerStart(array, layer) + 4 * i, layerStart(array, layer) + 4 * i + 4),
];

/** Points on random branches, the ends of each among them, and where the reference puts them. */
function branchVertices(
  tree: PackedTree,
  pose: Float32Array,
  random: Random,
  { shape, defines }: (typeof BARKS)[number],
): Vertices {
  const position = new Float32Array(3 * VERTICES);
  const normal = new Float32Array(3 * VERTICES);
  const twin = new Float64Array(PARTS * VERTICES);
  for (let i = 0; i < VERTICES; i++) {
    const place = Math.floor(random() * tree.pieceCount);
    const ring = Math.fround(i % 8 === 0 ? 0 : i % 8 === 1 ? 1 : random());
    const turns = Math.fround(random());
    position.set([Math.cos(2 * Math.PI * turns), Math.sin(2 * Math.PI * turns), ring], 3 * i);
    normal.set([turns, place, 0], 3 * i);
    const [piece, z0, z1, baseRadius] = texel(tree.branches, BRANCH_LAYERS.SPAN, place);
    const [length, , , parentRadius] = texel(tree.branches, BRANCH_LAYERS.STEM, place);
    const { curve, o } = poseOf(pose, planeOf(tree.restPose), piece);
    // Row 22: the rings of a trunk's first piece crowd towards the ground.
    const v = defines.FLARED && z0 === 0 ? ring * (0.15 + 0.85 * ring) : ring;
    const z = z0 + (z1 - z0) * v;
    const [radius, taper, q] = stemRadius(shape, baseRadius, length, z, turns);
    const [swell, swelling] = collar(z * length, radius, parentRadius, COLLAR);
    const slope = taper * swell + radius * swelling * length;
    const [cos, sin] = [position[3 * i], position[3 * i + 1]];
    const point = surfacePoint(curve, handlesOf(curve, o), v, cos, sin, radius * swell, slope * (z1 - z0), q);
    [point.position, point.normal, point.around, point.along].forEach((vector, k) => {
      twin.set(vector, PARTS * i + 4 * k);
    });
  }
  return { attributes: { position: { data: position, size: 3 }, normal: { data: normal, size: 3 } }, twin };
}

/** Points of random leaves in still air, that is without their flutter, which is for the eye and has no reference. */
function leafVertices(tree: PackedTree, pose: Float32Array, random: Random): Vertices {
  const position = new Float32Array(3 * VERTICES);
  const normal = new Float32Array(3 * VERTICES);
  const blade = new Float32Array(4 * VERTICES);
  const twin = new Float64Array(PARTS * VERTICES);
  for (let i = 0; i < VERTICES; i++) {
    const leaf = Math.floor(random() * tree.leafCount);
    position.set([between(random, -0.5, 0.5), between(random, -0.1, 0.1), random()], 3 * i);
    normal.set(direction(random), 3 * i);
    blade[4 * i + 2] = leaf;
    const { piece, v, orientation: turn } = leafTexel(tree.leaves.data, leaf);
    const { curve, o } = poseOf(pose, planeOf(tree.restPose), piece);
    const frame = sectionFrame(curve, handlesOf(curve, o), v);
    const p = [...position.subarray(3 * i, 3 * i + 3)] as Vec3;
    const n = [...normal.subarray(3 * i, 3 * i + 3)] as Vec3;
    const moved = transform(frame, rotateByQuaternion(turn, scale(p, tree.leafLength)));
    twin.set(add(bezierPoint(curve, v), moved), PARTS * i);
    twin.set(transform(frame, rotateByQuaternion(turn, n)), PARTS * i + 4);
  }
  const attributes = {
    position: { data: position, size: 3 },
    normal: { data: normal, size: 3 },
    blade: { data: blade, size: 4 },
  };
  return { attributes, twin };
}

/** The deformers as they draw a tree in the wind, vertex by vertex, against core/deform on the reference's pose. */
export function checkDeformers(renderer: WebGLRenderer, name: string, tree: PackedTree, wind: Wind): Check[] {
  const source = windSource(wind);
  const textures = new TreeTextures(tree, true);
  const pass = new WindPass(textures);
  pass.update(renderer, STEP_NUMBER * STEP, source);
  const pose = new Reference(tree, source).pose(STEP_NUMBER * STEP);
  const random = randomStream(7);
  const shared = { ...textures.uniforms, poseLog2Width: { value: Math.log2(tree.restPose.width) } };

  const barks = BARKS.map((bark) => {
    const { shape, defines } = bark;
    const { attributes, twin } = branchVertices(tree, pose, random, bark);
    const gpu = runVertices(renderer, {
      vertexShader: branchVertex,
      defines,
      attributes,
      uniforms: {
        ...shared,
        branchLog2Width: { value: Math.log2(tree.branches.width) },
        branchRange: { value: new Vector3(0, tree.pieceCount, tree.pieceCount) },
        stemShape: {
          value: [
            new Vector4(shape.taper, shape.flare, shape.lobes, shape.lobeDepth),
            new Vector4(shape.lobeFade, shape.bulges, shape.bulgeDepth, COLLAR),
          ],
        },
      },
    });
    return { what: bark.what, gpu, twin };
  });
  const leaves = leafVertices(tree, pose, random);
  const leafResults = runVertices(renderer, {
    vertexShader: leafVertex,
    attributes: leaves.attributes,
    uniforms: {
      ...shared,
      leafLog2Width: { value: Math.log2(tree.leaves.width) },
      leafRange: { value: new Vector2(tree.leafCount, tree.leafCount) },
      leafSize: { value: new Vector2(tree.leafLength, tree.leafLength) },
      leafFlutter: { value: new Vector2(0, 0) },
    },
  });
  pass.dispose();
  textures.dispose();

  const size = new Float64Array(VERTICES).fill(tree.bounds[5] - tree.bounds[2]);
  const line = (what: string, parts: number[], metres: boolean) => ({
    name: `deformed ${name}, ${what}`,
    parts,
    error: 'vector' as const,
    bySize: metres,
    tolerance: metres ? 2e-5 : 1e-4,
    note: metres ? 'of the tree’s height' : 'radians',
  });
  const foliage = { samples: VERTICES, gpu: leafResults, twin: leaves.twin, size };
  return [
    ...barks.flatMap(({ what, gpu, twin }) => {
      const results = { samples: VERTICES, gpu, twin, size };
      return [
        compareLine(line(`${what}, positions`, [0, 1, 2], true), results),
        compareLine(line(`${what}, normals`, [4, 5, 6], false), results),
        compareLine(line(`${what}, around`, [8, 9, 10], false), results),
        compareLine(line(`${what}, along`, [12, 13, 14], false), results),
      ];
    }),
    compareLine(line('leaves, positions', [0, 1, 2], true), foliage),
    compareLine(line('leaves, normals', [4, 5, 6], false), foliage),
  ];
}
