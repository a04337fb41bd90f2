import { BufferAttribute, BufferGeometry, type IUniform, Mesh, Object3D } from 'three';
import fragmentShader from '../../../shaders/overlay/marker.frag';
import vertexShader from '../../../shaders/overlay/marker.vert';
import { type OverlayUniforms, overlayMaterial } from './overlay-material.ts';

/** The probe: a ring that sticks to the end of a piece, read from the pose on the GPU; a ghost of it where leaves hide it. */
export class Marker extends Object3D {
  readonly #geometry = new BufferGeometry();
  readonly #piece = { value: [0, 0] };
  readonly #materials;

  /** `pose`: poseEven, poseOdd and poseLog2Width of the tree. */
  constructor(shared: OverlayUniforms, pose: Record<string, IUniform>) {
    super();
    this.#geometry.setAttribute(
      'position',
      new BufferAttribute(new Float32Array([-1, -1, 0, 1, -1, 0, -1, 1, 0, 1, 1, 0]), 3),
    );
    this.#geometry.setIndex([0, 1, 2, 2, 1, 3]);
    this.#materials = (['hidden', 'seen'] as const).map((layer) =>
      overlayMaterial(vertexShader, fragmentShader, { ...shared, ...pose, markerPiece: this.#piece }, layer),
    );
    this.#materials.forEach((material, i) => {
      const mesh = new Mesh(this.#geometry, material);
      mesh.frustumCulled = false;
      mesh.renderOrder = 8 + i;
      mesh.raycast = () => {};
      this.add(mesh);
    });
    this.name = 'probe';
  }

  /** Sticks it to a piece whose depth is odd or even. */
  stick(piece: number, odd: boolean): void {
    this.#piece.value = [piece, odd ? 1 : 0];
  }

  override dispose(): void {
    this.#geometry.dispose();
    for (const material of this.#materials) material.dispose();
  }
}
