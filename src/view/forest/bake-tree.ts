import { Color, Matrix4, OrthographicCamera, Scene, Vector3, type WebGLRenderer, type WebGLRenderTarget } from 'three';
import { viewFrame } from '../../core/forest/octahedral.ts';
import type { Vec3 } from '../../core/math/vec3.ts';
import type { PackedTree } from '../../core/pack/packed.ts';
import type { Species } from '../../core/species/species.ts';
import { TreeTextures } from '../../gpu/tree-textures.ts';
import { TreeParts } from '../tree-parts.ts';
import { wholeKit } from '../whole-kit.ts';
import { bakeMaterial } from './bake-material.ts';

const nothing = new Color(0, 0, 0);
const was = new Color();

/** The box that a picture of a tree shows: metres, tree space. */
export interface BakeBox {
  readonly centre: readonly [number, number, number];
  readonly halfWidth: number;
  readonly halfHeight: number;
  /** From the centre to the nearest and to the farthest that is drawn. */
  readonly depth: number;
}

const turned = ([x, y, z]: readonly [number, number, number]): Vector3 => new Vector3(x, z, -y);

/** A tree at rest as pictures are taken of it: its own meshes, without light. */
export class BakeTree {
  readonly #parts = new TreeParts(
    { mode: 'shaded', levels: Number.POSITIVE_INFINITY, leaves: true, detail: 'auto', leafBudget: 60_000 },
    wholeKit,
  );
  readonly #scene = new Scene();
  readonly #camera = new OrthographicCamera();
  #textures: TreeTextures | null = null;

  constructor() {
    this.#scene.add(this.#parts);
    this.#camera.matrixAutoUpdate = false;
  }

  /** Takes a tree. `rounding`: how far the normals of its leaves turn to the outside of the crown, 0..1. */
  setTree(tree: PackedTree, species: Species, rounding: number): void {
    this.#textures?.dispose();
    const textures = new TreeTextures(tree, false);
    this.#textures = textures;
    const { shared } = this.#parts;
    const { poseEven, poseOdd, branches, leaves } = textures.uniforms;
    shared.poseEven.value = poseEven.value;
    shared.poseOdd.value = poseOdd.value;
    shared.branches.value = branches.value;
    shared.leaves.value = leaves.value;
    shared.poseLog2Width.value = Math.log2(tree.restPose.width);
    shared.branchLog2Width.value = Math.log2(tree.branches.width);
    shared.leafLog2Width.value = Math.log2(tree.leaves.width);
    this.#parts.setTree(tree, species);
    this.#parts.leaves.look.crownRounding.value = rounding;
  }

  /** Draws the tree as seen from direction `d` (unit, tree space) into `target`, its height filling the picture. */
  draw(
    renderer: WebGLRenderer,
    target: WebGLRenderTarget,
    d: Vec3,
    { centre, halfWidth, halfHeight, depth }: BakeBox,
  ): void {
    const camera = this.#camera;
    const { right, up } = viewFrame(d);
    Object.assign(camera, {
      left: -halfWidth,
      right: halfWidth,
      top: halfHeight,
      bottom: -halfHeight,
      near: 0,
      far: 2 * depth,
    });
    camera.updateProjectionMatrix();
    camera.matrix.copy(new Matrix4().makeBasis(turned(right), turned(up), turned(d)));
    camera.matrix.setPosition(turned(centre).addScaledVector(turned(d), depth));
    camera.updateMatrixWorld(true);
    this.#parts.pictureHeight = target.height;
    this.#scene.updateMatrixWorld();
    this.#parts.update(camera);
    for (const child of this.#parts.children) if ('isMesh' in child) bakeMaterial(child as never);
    renderer.getClearColor(was);
    const alpha = renderer.getClearAlpha();
    renderer.setClearColor(nothing, 0);
    renderer.setRenderTarget(target);
    renderer.clear();
    renderer.render(this.#scene, camera);
    renderer.setClearColor(was, alpha);
  }

  /** Frees what is of the tree; its programs stay for the next one. */
  leave(): void {
    this.#textures?.dispose();
    this.#textures = null;
  }

  dispose(): void {
    this.leave();
    this.#parts.dispose();
  }
}
