import { BufferAttribute, BufferGeometry, type Material, Mesh, MeshStandardMaterial } from 'three';
import { stemRadius } from '../src/core/deform/radius.ts';
import { surfacePoint } from '../src/core/deform/surface.ts';
import { handlesOf } from '../src/core/math/frames.ts';
import type { Vec3 } from '../src/core/math/vec3.ts';
import { TEXEL } from '../src/core/pack/layout.ts';
import type { PackedTree } from '../src/core/pack/packed.ts';
import { BUNDLE } from '../src/view/branch-geometry.ts';
import { BRANCH_STANDARD } from '../src/view/branch-shader.ts';
import { STREWN_TAPER, strewnBark } from '../src/view/deformed-mesh.ts';
import { branchGrid, type GridSpec } from '../src/view/grid.ts';
import { inject } from '../src/view/inject.ts';
import { levelUniforms } from '../src/view/uniforms.ts';

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
  const shape = { taper: STREWN_TAPER, flare: 0, lobes: 0, lobeDepth: 0, lobeFade: 0, bulges: 0, bulgeDepth: 0 };
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
    { ...strewnBark(), ...level },
  );
  return new Mesh(geometry, material);
}

/** The two cases of the papers: pieces and grids that give about their vertices. */
export const CASES = [
  { pieces: 10_000, spec: { sectors: 3, bands: 3, cap: false, bundle: BUNDLE } },
  { pieces: 17_400, spec: { sectors: 4, bands: 3, cap: false, bundle: BUNDLE } },
] as const;
