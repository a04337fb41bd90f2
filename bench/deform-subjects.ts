import { Box3, BufferAttribute, BufferGeometry, type Material, Mesh, MeshStandardMaterial, Vector3 } from 'three';
import { stemRadius } from '../src/core/deform/radius.ts';
import { surfacePoint } from '../src/core/deform/surface.ts';
import { handlesOf } from '../src/core/math/frames.ts';
import { hashPcg, hashUnit } from '../src/core/math/hash.ts';
import type { Vec3 } from '../src/core/math/vec3.ts';
import { BRANCH_LAYERS, MECHANICS_SIZE, TEXEL } from '../src/core/pack/layout.ts';
import type { PackedTree } from '../src/core/pack/packed.ts';
import { texelArray, wordTexels } from '../src/core/pack/texel-array.ts';
import { TreeTextures } from '../src/gpu/tree-textures.ts';
import { barkTexture } from '../src/view/bark-texture.ts';
import { BUNDLE, branchGeometry } from '../src/view/branch-geometry.ts';
import { BRANCH_STANDARD } from '../src/view/branch-shader.ts';
import { branchGrid, type GridSpec } from '../src/view/grid.ts';
import { inject } from '../src/view/inject.ts';
import { branchMaterials } from '../src/view/tree-materials.ts';
import { barkUniforms, levelUniforms, sharedUniforms } from '../src/view/uniforms.ts';

/** Half the side of the box that the pieces fill, metres. */
const HALF = 4;
const TAPER = 1;

/** Pieces strewn over a box: curved, a metre long, each the whole of a stem. */
export function strewnPieces(count: number): PackedTree {
  const restPose = texelArray(count, 4);
  const branches = texelArray(count, Object.keys(BRANCH_LAYERS).length);
  const plane = restPose.width * restPose.height * TEXEL;
  let h = 99;
  const draw = (): number => {
    h = hashPcg(h);
    return hashUnit(h);
  };
  const spread = (size: number): Vec3 => [size * (2 * draw() - 1), size * (2 * draw() - 1), size * (2 * draw() - 1)];
  for (let i = 0; i < count; i++) {
    const point = spread(HALF);
    const way = spread(1);
    const across = handlesOf({ p0: [0, 0, 0], p1: way, p2: way, p3: way }, [0, 0, 1]).t0;
    for (let k = 0; k < 4; k++) {
      restPose.data.set(point, k * plane + i * TEXEL);
      restPose.data[k * plane + i * TEXEL + 3] = k < 3 ? across[k] : 0;
      const bend = spread(0.12);
      for (let axis = 0; axis < 3; axis++) point[axis] += 0.33 * way[axis] + bend[axis] * k;
    }
    branches.data.set([i, 0, 1, 0.012 + 0.01 * draw()], i * TEXEL);
    branches.data.set([1, draw(), 0, 0], plane + i * TEXEL); // no parent, so no collar
  }
  return {
    pieceCount: count,
    leafCount: 0,
    depthStart: new Uint32Array([0, count]),
    pieces: texelArray(count, 5),
    restPose,
    mechanics: new Float32Array(MECHANICS_SIZE * count),
    branches,
    leaves: wordTexels(0, 1),
    leafLength: 0,
    levels: [{ start: 0, count }],
    bounds: new Float32Array([-HALF, -HALF, -HALF, HALF, HALF, HALF]),
    crown: new Float32Array([0, 0, 0, HALF, HALF, HALF]),
  };
}

const box = new Box3(new Vector3().setScalar(-HALF - 2), new Vector3().setScalar(HALF + 2));

function bark() {
  const uniforms = barkUniforms();
  uniforms.barkMap.value = barkTexture('plated');
  uniforms.barkTile.value.x = 0.7;
  uniforms.barkColour.value.set('#8a7a68');
  uniforms.barkDark.value.set('#3a3028');
  uniforms.barkRelief.value = 0.6;
  return uniforms;
}

/** The pieces bent on the GPU, as a tree does it. */
export function deformedMesh(tree: PackedTree, spec: GridSpec): Mesh {
  const textures = new TreeTextures(tree, false);
  const shared = sharedUniforms();
  shared.poseEven.value = textures.uniforms.poseEven.value;
  shared.poseOdd.value = textures.uniforms.poseOdd.value;
  shared.poseLog2Width.value = Math.log2(tree.restPose.width);
  shared.branches.value = textures.branches;
  shared.branchLog2Width.value = Math.log2(tree.branches.width);
  shared.crownRadii.value.setScalar(HALF);
  const level = levelUniforms();
  level.branchRange.value.set(0, tree.pieceCount, spec.bundle);
  level.stemShape.value[0].set(TAPER, 0, 0, 0);
  const { standard } = branchMaterials(['PLAIN_STEM'], { ...shared, ...bark(), ...level });
  return new Mesh(branchGeometry(spec, tree.pieceCount, box), standard);
}

/** The same triangles written out, each corner with what the fragment shader reads: one static, indexed mesh. */
export function staticMesh(tree: PackedTree, spec: GridSpec): Mesh {
  const grid = branchGrid({ ...spec, bundle: 1 });
  const n = grid.verticesPerCopy;
  const total = n * tree.pieceCount;
  const position = new Float32Array(total * 3);
  const normal = new Float32Array(total * 3);
  const around = new Float32Array(total * 3);
  const barkCorner = new Float32Array(total * 4);
  const index = new Uint32Array(grid.index.length * tree.pieceCount);
  const plane = tree.restPose.width * tree.restPose.height * TEXEL;
  const shape = { taper: TAPER, flare: 0, lobes: 0, lobeDepth: 0, lobeFade: 0, bulges: 0, bulgeDepth: 0 };
  for (let i = 0; i < tree.pieceCount; i++) {
    const at = (k: number): Vec3 => [0, 1, 2].map((axis) => tree.restPose.data[k * plane + i * TEXEL + axis]) as Vec3;
    const curve = { p0: at(0), p1: at(1), p2: at(2), p3: at(3) };
    const o = [0, 1, 2].map((k) => tree.restPose.data[k * plane + i * TEXEL + 3]) as Vec3;
    const handles = handlesOf(curve, o);
    const radius = tree.branches.data[i * TEXEL + 3];
    for (let k = 0; k < n; k++) {
      const [c, s, v] = grid.position.subarray(k * 3, k * 3 + 3);
      const [rho, slope, q] = stemRadius(shape, radius, 1, v, grid.shape[k * 3]);
      const p = surfacePoint(curve, handles, v, c, s, rho, slope, q);
      const corner = (i * n + k) * 3;
      position.set(p.position, corner);
      normal.set(p.normal, corner);
      around.set(p.around, corner);
      barkCorner.set([grid.shape[k * 3], v / 0.12, 0.5, 0.9], (i * n + k) * 4);
    }
    for (let k = 0; k < grid.index.length; k++) index[i * grid.index.length + k] = grid.index[k] + i * n;
  }
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new BufferAttribute(position, 3));
  geometry.setAttribute('normal', new BufferAttribute(normal, 3));
  geometry.setAttribute('around', new BufferAttribute(around, 3));
  geometry.setAttribute('barkCorner', new BufferAttribute(barkCorner, 4));
  geometry.setIndex(new BufferAttribute(index, 1));
  const level = levelUniforms();
  const material: Material = new MeshStandardMaterial({ metalness: 0 });
  inject(
    material,
    'bench static',
    {
      vertex: [
        {
          anchor: '#include <common>',
          after: 'in vec3 around; in vec4 barkCorner; out vec3 vAround; out vec4 vBark;',
        },
        {
          anchor: '#include <defaultnormal_vertex>',
          after: 'vAround = (modelViewMatrix * vec4(around, 0.0)).xyz; vBark = barkCorner;',
        },
      ],
      fragment: BRANCH_STANDARD.fragment,
    },
    { ...bark(), ...level },
  );
  return new Mesh(geometry, material);
}

/** The two cases of the papers: pieces and grids that give about their vertices. */
export const CASES = [
  { pieces: 10_000, spec: { sectors: 3, bands: 3, cap: false, bundle: BUNDLE } },
  { pieces: 17_400, spec: { sectors: 4, bands: 3, cap: false, bundle: BUNDLE } },
] as const;
