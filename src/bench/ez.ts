import { Tree } from '@dgreenheck/ez-tree';
import { Box3, Group, Mesh, type MeshPhongMaterial, type Object3D, type Texture } from 'three';

/** A tree of ez-tree's, and what it takes. */
export interface EzTree {
  readonly name: string;
  readonly object: Object3D;
  readonly update: (time: number) => void;
  readonly bytes: number;
}

const imageOf = (texture: Texture | null | undefined): { width: number; height: number } | undefined =>
  texture?.image as { width: number; height: number } | undefined;

/** Vertices, indices, and its pictures with their mip maps. */
function bytesOf(meshes: readonly Mesh[]): number {
  let bytes = 0;
  const textures = new Set<Texture>();
  for (const { geometry, material } of meshes) {
    for (const attribute of Object.values(geometry.attributes)) bytes += attribute.array.byteLength;
    bytes += geometry.index?.array.byteLength ?? 0;
    const { map, normalMap, aoMap, roughnessMap } = material as MeshPhongMaterial & { roughnessMap?: Texture };
    for (const texture of [map, normalMap, aoMap, roughnessMap]) if (texture) textures.add(texture);
  }
  for (const texture of textures) {
    const image = imageOf(texture);
    bytes += ((image?.width ?? 0) * (image?.height ?? 0) * 4 * 4) / 3;
  }
  return bytes;
}

/** Milliseconds that its pictures are waited for. */
const PATIENCE = 30_000;

/** A preset of ez-tree with its pictures. It begins to load them when it is imported and says nothing when they are there: a texture then has its image. */
export async function loadPreset(preset: string): Promise<Tree> {
  const tree = new Tree();
  tree.loadPreset(preset);
  const { map: bark, normalMap, aoMap } = tree.branchesMesh.material as MeshPhongMaterial;
  const { map: leaf } = tree.leavesMesh.material as MeshPhongMaterial;
  const last = performance.now() + PATIENCE;
  while (![bark, normalMap, aoMap, leaf].every(imageOf)) {
    if (performance.now() > last) throw new Error(`The pictures of ez-tree's ${preset} did not come.`);
    await new Promise(requestAnimationFrame);
  }
  return tree;
}

/** Triangles of a tree of ez-tree's. */
const trianglesOf = ({ branchesMesh, leavesMesh }: Tree): number =>
  [branchesMesh, leavesMesh].reduce((sum, { geometry }) => sum + (geometry.index?.count ?? 0) / 3, 0);

/** The preset, of those named, whose triangles come nearest to a number, by their ratio. */
export async function presetWith(triangles: number, presets: readonly string[]): Promise<string> {
  let best = presets[0]!;
  let least = Number.POSITIVE_INFINITY;
  for (const preset of presets) {
    const tree = await loadPreset(preset);
    const away = Math.abs(Math.log(trianglesOf(tree) / triangles));
    for (const { geometry } of [tree.branchesMesh, tree.leavesMesh]) geometry.dispose();
    if (away < least) [best, least] = [preset, away];
  }
  return best;
}

/** A preset of ez-tree at a height in metres; where there are more `places` (x, z) copies of it share its vertices. */
export async function ezTree(
  preset: string,
  height: number,
  places: readonly (readonly [number, number])[] = [[0, 0]],
): Promise<EzTree> {
  const tree = await loadPreset(preset);
  const own = new Box3().setFromObject(tree);
  const { branchesMesh, leavesMesh } = tree;
  const group = new Group();
  const scale = height / own.max.y;
  for (const [x, z] of places) {
    const copy = new Group();
    for (const mesh of [branchesMesh, leavesMesh]) {
      const part = new Mesh(mesh.geometry, mesh.material);
      part.castShadow = true;
      part.receiveShadow = true;
      copy.add(part);
    }
    copy.position.set(x, 0, z);
    copy.rotation.y = 1.7 * x + 2.3 * z;
    copy.scale.setScalar(scale);
    group.add(copy);
  }
  return {
    name: `ez-tree 1.1.0, ${preset}`,
    object: group,
    update: (time) => tree.update(time),
    bytes: bytesOf([branchesMesh, leavesMesh]),
  };
}
