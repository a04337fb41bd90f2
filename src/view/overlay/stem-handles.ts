import { BufferAttribute, BufferGeometry, Color, type IUniform, Mesh, Object3D, Vector3, Vector4 } from 'three';
import fragmentShader from '../../../shaders/overlay/stem-handle.frag';
import vertexShader from '../../../shaders/overlay/stem-handle.vert';
import type { PackedTree } from '../../core/pack/packed.ts';
import { levelColour } from '../level-colours.ts';
import type { StemHandle } from '../picture/picture.ts';
import { type OverlayUniforms, overlayMaterial } from './overlay-material.ts';
import type { StemEnds } from './stem-ends.ts';
import { isOdd } from './stem-pieces.ts';

/** Kinds of marks, as shaders/overlay/stem-handle.vert names them. */
const KINDS: readonly StemHandle[] = ['length', 'curve', 'down'];
const ARC = 3;

/** Straight parts of the arc. */
const PARTS = 28;

function marks(): BufferGeometry {
  const position: number[] = [];
  const index: number[] = [];
  const quad = (): void => {
    const n = position.length / 3;
    index.push(n - 4, n - 2, n - 3, n - 3, n - 2, n - 1);
  };
  for (let i = 0; i <= PARTS; i++) {
    position.push(i / PARTS, -1, ARC, i / PARTS, 1, ARC);
    if (i > 0) quad();
  }
  for (const kind of KINDS.keys()) {
    for (const y of [-1, 1]) for (const x of [-1, 1]) position.push(x, y, kind);
    quad();
  }
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new BufferAttribute(new Float32Array(position), 3));
  geometry.setIndex(index);
  return geometry;
}

/** The handles of a stem, drawn before all else and read from the pose on the GPU, so that they never lag behind the wind. */
export class StemHandles extends Object3D {
  readonly #geometry = marks();
  readonly #ends = { value: new Int32Array(8) };
  readonly #places = { value: new Vector4() };
  readonly #grips = { value: new Vector3() };
  readonly #colour = { value: new Color() };
  readonly #material;

  /** `pose`: poseEven, poseOdd and poseLog2Width of the tree. */
  constructor(shared: OverlayUniforms, pose: Record<string, IUniform>) {
    super();
    this.#material = overlayMaterial(vertexShader, fragmentShader, {
      ...shared,
      ...pose,
      stemEnds: this.#ends,
      stemPlaces: this.#places,
      stemGrips: this.#grips,
      stemColour: this.#colour,
    });
    // A handle that a leaf hides could not be found.
    this.#material.depthTest = false;
    const mesh = new Mesh(this.#geometry, this.#material);
    mesh.frustumCulled = false;
    mesh.renderOrder = 10;
    mesh.raycast = () => {};
    this.add(mesh);
    this.name = 'handles of a stem';
  }

  set(tree: PackedTree, { base, middle, tip, parent, down, level }: StemEnds): void {
    for (const [i, place] of [base, middle, tip, parent].entries()) {
      this.#ends.value[2 * i] = place ? place.piece : -1;
      this.#ends.value[2 * i + 1] = place && isOdd(tree, place.piece) ? 1 : 0;
    }
    this.#places.value.set(middle.v, parent?.v ?? 0, down ? 1 : 0, 1);
    this.#colour.value.set(levelColour(level)).convertLinearToSRGB();
  }

  /** How a handle is: at rest, pointed at or held. */
  grip(kind: StemHandle, how: 'rest' | 'hover' | 'held'): void {
    this.#grips.value.setComponent(KINDS.indexOf(kind), how === 'held' ? 2 : how === 'hover' ? 1 : 0);
  }

  override dispose(): void {
    this.#geometry.dispose();
    this.#material.dispose();
  }
}
