import { Box3, type Camera, Frustum, Matrix4, Vector3 } from 'three';
import type { Cell } from './cells.ts';

const matrix = new Matrix4();
const box = new Box3();
const eye = new Vector3();

/** What a camera sees of cells in forest space (z up), for a forest whose own matrix may be any. */
export class CellView {
  /** The eye in forest space, metres. */
  readonly eye: [number, number, number] = [0, 0, 0];
  /** Pixels of a metre at a metre from the eye. */
  scale = 1;
  readonly #frustum = new Frustum();

  /** `world`: matrix of the forest (y up); `height`: of the picture, pixels. */
  take(camera: Camera, world: Matrix4, height: number): void {
    matrix.copy(camera.matrixWorldInverse).multiply(world);
    this.#frustum.setFromProjectionMatrix(matrix.premultiply(camera.projectionMatrix));
    eye.setFromMatrixPosition(camera.matrixWorld).applyMatrix4(matrix.copy(world).invert());
    this.eye[0] = eye.x;
    this.eye[1] = -eye.z;
    this.eye[2] = eye.y;
    this.scale = (camera.projectionMatrix.elements[5] as number) * height * 0.5;
  }

  /** Is anything of a cell in the picture, or within `margin` metres of it? */
  sees({ x, y, low, high, tallest }: Cell, side: number, margin: number): boolean {
    const half = side / 2 + margin;
    box.min.set(x - half, low - margin, -y - half);
    box.max.set(x + half, high + 1.15 * tallest + margin, -y + half);
    return this.#frustum.intersectsBox(box);
  }
}
