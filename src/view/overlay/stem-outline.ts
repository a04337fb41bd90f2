import { Color, InstancedBufferAttribute, type IUniform, Mesh, Object3D } from 'three';
import fragmentShader from '../../../shaders/overlay/outline.frag';
import vertexShader from '../../../shaders/overlay/outline.vert';
import { levelColour } from '../level-colours.ts';
import { type OverlayUniforms, overlayMaterial } from './overlay-material.ts';
import { PIECE_NUMBERS, pieceRibbon } from './piece-ribbon.ts';

/** How much of the outline shows through the leaves: a crown hides most of a stem, and it is what the reader looks for. */
const GHOST = 0.6;

/** A stem outlined at both sides, along all its pieces and in the pose as the GPU has it; a ghost of it where leaves hide it. */
export class StemOutline extends Object3D {
  readonly #geometry = pieceRibbon();
  readonly #colour = { value: new Color() };
  readonly #materials;

  /** `pose`: poseEven, poseOdd and poseLog2Width of the tree; `weight`: how strongly it is drawn, 0..1. */
  constructor(shared: OverlayUniforms, pose: Record<string, IUniform>, weight: number) {
    super();
    const uniforms = { ...shared, ...pose, stemColour: this.#colour, outlineWeight: { value: weight } };
    this.#materials = (['hidden', 'seen'] as const).map((layer) =>
      overlayMaterial(vertexShader, fragmentShader, uniforms, layer, GHOST),
    );
    this.#materials.forEach((material, i) => {
      const mesh = new Mesh(this.#geometry, material);
      mesh.frustumCulled = false;
      mesh.renderOrder = 6 + i;
      mesh.raycast = () => {};
      this.add(mesh);
    });
    this.name = 'outline of a stem';
  }

  /** Outlines these pieces, as `stemPieces` gives them, of a stem of a level. */
  set(pieces: Float32Array, level: number): void {
    this.#geometry.setAttribute('piece', new InstancedBufferAttribute(pieces, PIECE_NUMBERS));
    this.#geometry.instanceCount = pieces.length / PIECE_NUMBERS;
    this.#colour.value.set(levelColour(level)).convertLinearToSRGB();
  }

  override dispose(): void {
    this.#geometry.dispose();
    for (const material of this.#materials) material.dispose();
  }
}
