import { InstancedBufferAttribute, type IUniform, Mesh, Object3D } from 'three';
import fragmentShader from '../../../shaders/overlay/highlight.frag';
import vertexShader from '../../../shaders/overlay/highlight.vert';
import { type OverlayUniforms, overlayMaterial } from './overlay-material.ts';
import { PIECE_NUMBERS, pieceRibbon } from './piece-ribbon.ts';

/** A branch that stands out: a ribbon before each of its pieces, in the pose as the GPU has it. */
export class Highlight extends Object3D {
  readonly #geometry = pieceRibbon();
  readonly #materials;

  /** `pose`: poseEven, poseOdd and poseLog2Width of the tree. */
  constructor(shared: OverlayUniforms, pose: Record<string, IUniform>) {
    super();
    this.#materials = (['hidden', 'seen'] as const).map((layer) =>
      overlayMaterial(vertexShader, fragmentShader, { ...shared, ...pose }, layer),
    );
    this.#materials.forEach((material, i) => {
      const mesh = new Mesh(this.#geometry, material);
      mesh.frustumCulled = false;
      mesh.renderOrder = 6 + i;
      mesh.raycast = () => {};
      this.add(mesh);
    });
    this.name = 'highlight';
  }

  /** Shows these pieces: piece | 1 where its depth is odd | radius in metres at its start | at its end. */
  set(pieces: Float32Array): void {
    this.#geometry.setAttribute('piece', new InstancedBufferAttribute(pieces, PIECE_NUMBERS));
    this.#geometry.instanceCount = pieces.length / PIECE_NUMBERS;
  }

  override dispose(): void {
    this.#geometry.dispose();
    for (const material of this.#materials) material.dispose();
  }
}
