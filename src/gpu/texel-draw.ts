import {
  BufferAttribute,
  BufferGeometry,
  Camera,
  GLSL3,
  type IUniform,
  Mesh,
  NoBlending,
  RawShaderMaterial,
  Sphere,
  type WebGLRenderer,
  type WebGLRenderTarget,
} from 'three';
import vertexShader from '../../shaders/wind/texels.vert';
import { type TexelRectangle, texelRectangles } from './texel-ranges.ts';

/** A range of indices, [start, end). */
export type IndexRange = readonly [start: number, end: number];

/** A material that computes texels: GLSL ES 3.00 as it stands, nothing of three's mixed in, no blending, no depth. */
export function texelMaterial(
  fragmentShader: string,
  uniforms: Record<string, IUniform>,
  defines: Record<string, string | number> = {},
): RawShaderMaterial {
  return new RawShaderMaterial({
    glslVersion: GLSL3,
    vertexShader,
    fragmentShader,
    uniforms,
    defines,
    blending: NoBlending, // alpha is data
    depthTest: false,
    depthWrite: false,
    toneMapped: false,
  });
}

/**
 * Draws the texels of a range of indices and no others.
 *
 * All ranges are rectangles of one buffer, made once, so that a draw changes only the draw range. The caller holds the
 * renderer's settings (`PassState`).
 */
export class TexelDraw {
  readonly #geometry = new BufferGeometry();
  readonly #mesh = new Mesh(this.#geometry);
  readonly #camera = new Camera();
  readonly #first: number[] = [];

  /** `width`, `height` of the targets in texels; `ranges` are drawn by their place in the list. */
  constructor(width: number, height: number, ranges: readonly IndexRange[]) {
    const corners: number[] = [];
    for (const [start, end] of ranges) {
      this.#first.push(corners.length / 2);
      for (const rectangle of texelRectangles(start, end, width)) corners.push(...triangles(rectangle, width, height));
    }
    this.#first.push(corners.length / 2);
    this.#geometry.setAttribute('position', new BufferAttribute(new Float32Array(corners), 2));
    this.#geometry.boundingSphere = new Sphere(); // three sorts by it, and would look for a third coordinate
    this.#mesh.frustumCulled = false;
    this.#mesh.matrixAutoUpdate = false;
    this.#camera.matrixAutoUpdate = false;
  }

  /** Draws range number `range` into `target`. */
  draw(renderer: WebGLRenderer, target: WebGLRenderTarget, material: RawShaderMaterial, range: number): void {
    const first = this.#first[range];
    this.#geometry.setDrawRange(first, this.#first[range + 1] - first);
    this.#mesh.material = material;
    renderer.setRenderTarget(target);
    renderer.render(this.#mesh, this.#camera);
  }

  dispose(): void {
    this.#geometry.dispose();
  }
}

/** Two triangles in clip space. A large triangle with a scissor would shade no texel twice either, but needs GL state. */
function triangles([x0, y0, x1, y1]: TexelRectangle, width: number, height: number): number[] {
  const [l, r] = [(2 * x0) / width - 1, (2 * x1) / width - 1];
  const [b, t] = [(2 * y0) / height - 1, (2 * y1) / height - 1];
  return [l, b, r, b, r, t, l, b, r, t, l, t];
}
