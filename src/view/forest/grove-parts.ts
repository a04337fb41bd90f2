import type { Box3, Camera, Matrix4, Vector2 } from 'three';
import type { GroveLight } from '../../core/look/grove-light.ts';
import type { PackedTree } from '../../core/pack/packed.ts';
import type { Species } from '../../core/species/species.ts';
import type { LeafHost } from '../leaf-layer.ts';
import type { TreeMesh } from '../tree-parts.ts';
import type { GroveUniforms } from '../uniforms.ts';

/** What hangs on the branches of a tree or a grove and is drawn beside them: leaves and organs, or cards. */
export interface Foliage {
  /** How many of them the last frame drew. */
  readonly count: number;
  /** The meshes that there are. */
  meshes(): readonly TreeMesh[];
  setTree(tree: PackedTree, species: Species, light?: GroveLight): void;
  /** The time in sixteenths of a beat, 0..1, and where the wind blows to at the tree. */
  setWind(beats: number, way: Vector2): void;
  /** Chooses what is drawn for this camera. `box`: bounds in any wind. */
  fit(camera: Camera, box: Box3): void;
  setWireframe(wireframe: boolean): void;
  /** Their programs are others: what is drawn next makes them anew. */
  dropMaterials(): void;
  dispose(): void;
}

/** What makes the parts of one tree those of a grove. */
export interface GroveParts {
  readonly uniforms: GroveUniforms;
  /** Trees in the grove. */
  readonly count: number;
  /** What it has in place of leaves; left out: leaves. */
  readonly foliage?: (host: LeafHost) => Foliage;
  /** Pixels that a metre takes at the tree that is nearest to the camera, in a picture of that height. */
  nearest(camera: Camera, matrixWorld: Matrix4, height: number): number;
}
