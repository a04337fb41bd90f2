import {
  BufferAttribute,
  InstancedBufferAttribute,
  InstancedBufferGeometry,
  type IUniform,
  Mesh,
  Object3D,
} from 'three';
import fragmentShader from '../../../shaders/overlay/highlight.frag';
import vertexShader from '../../../shaders/overlay/highlight.vert';
import { type OverlayUniforms, overlayMaterial } from './overlay-material.ts';

/** Straight parts of a piece. */
const PARTS = 10;

/** Numbers of a piece: piece | odd | radius at its start | at its end. */
const NUMBERS = 4;

function ribbon(): InstancedBufferGeometry {
  const position: number[] = [];
  const index: number[] = [];
  for (let i = 0; i <= PARTS; i++) {
    position.push(i / PARTS, -1, 0, i / PARTS, 1, 0);
    if (i > 0) index.push(2 * i - 2, 2 * i, 2 * i - 1, 2 * i - 1, 2 * i, 2 * i + 1);
  }
  const geometry = new InstancedBufferGeometry();
  geometry.setAttribute('position', new BufferAttribute(new Float32Array(position), 3));
  geometry.setIndex(index);
  return geometry;
}

/** A branch that stands out: a ribbon before each of its pieces, in the pose as the GPU has it. */
export class Highlight extends Object3D {
  readonly #geometry = ribbon();
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
    this.#geometry.setAttribute('piece', new InstancedBufferAttribute(pieces, NUMBERS));
    this.#geometry.instanceCount = pieces.length / NUMBERS;
  }

  override dispose(): void {
    this.#geometry.dispose();
    for (const material of this.#materials) material.dispose();
  }
}
