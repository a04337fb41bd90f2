import { bezierPoint } from '../../core/math/bezier.ts';
import type { Vec3 } from '../../core/math/vec3.ts';
import { MECHANICS, MECHANICS_SIZE } from '../../core/pack/layout.ts';
import type { PackedTree } from '../../core/pack/packed.ts';
import { planeOf, poseOf } from '../../core/wind/pose-plainly.ts';
import type { Colours } from '../figure.ts';
import type { Plane, Point } from '../plane.ts';

/** Points of a curve, without its first. */
const STEPS = 10;

/** How a piece is drawn; what is not given is as its level says. */
export interface PieceLook {
  readonly colour?: string;
  readonly alpha?: number;
  /** Pixels added to its width. */
  readonly wider?: number;
}

/** Draws a posed tree from the side: tree space's x and y turned by `azimuth`, z up. */
export class TreeDrawing {
  readonly tree: PackedTree;
  readonly #cos: number;
  readonly #sin: number;

  constructor(tree: PackedTree, azimuth = 0.6) {
    this.tree = tree;
    this.#cos = Math.cos(azimuth);
    this.#sin = Math.sin(azimuth);
  }

  flat([x, y, z]: Vec3): Point {
    return [x * this.#cos - y * this.#sin, z];
  }

  level(piece: number): number {
    return this.tree.mechanics[MECHANICS_SIZE * piece + MECHANICS.LEVEL] ?? 0;
  }

  curve(pose: Float32Array, piece: number): Point[] {
    const { curve } = poseOf(pose, planeOf(this.tree.restPose), piece);
    return Array.from({ length: STEPS + 1 }, (_, k) => this.flat(bezierPoint(curve, k / STEPS)));
  }

  draw(plane: Plane, pose: Float32Array, colours: Colours, look: (piece: number) => PieceLook = () => ({})): void {
    const levels = [colours.level0, colours.level1, colours.level2, colours.level3];
    // Twigs first: the trunk stands before them.
    for (let piece = this.tree.pieceCount - 1; piece >= 0; piece--) {
      const level = this.level(piece);
      const { colour = levels[Math.min(level, 3)], alpha = 1, wider = 0 } = look(piece);
      const width = [6, 3, 1.6, 1.2][Math.min(level, 3)] ?? 1;
      plane.polyline(this.curve(pose, piece), { colour: colour ?? colours.ink, alpha, width: width + wider });
    }
  }

  /** The piece whose curve is nearest to a pixel of the stage, within 14 pixels; -1: none. */
  pick(plane: Plane, pose: Float32Array, px: number, py: number): number {
    let [best, least] = [-1, 14];
    for (let piece = 0; piece < this.tree.pieceCount; piece++) {
      for (const point of this.curve(pose, piece).slice(2)) {
        const [x, y] = plane.toPixel(...point);
        // Thin ones first, where several are as near.
        const far = Math.hypot(x - px, y - py) - this.level(piece);
        if (far < least) [best, least] = [piece, far];
      }
    }
    return best;
  }
}
