import type { Material, Object3D, WebGLRenderer } from 'three';

const smoothing = new WeakMap<WebGLRenderer, boolean>();

/** Does the renderer take several samples of each pixel of what it draws into now? */
function isSmoothed(renderer: WebGLRenderer): boolean {
  const target = renderer.getRenderTarget();
  if (target) return target.samples > 0;
  let smoothed = smoothing.get(renderer);
  if (smoothed === undefined) {
    smoothed = renderer.getContext().getContextAttributes()?.antialias === true;
    smoothing.set(renderer, smoothed);
  }
  return smoothed;
}

/**
 * Draws the alpha of an object's material as so many of the samples of a pixel, where it has several: needles are thinner than the texels
 * of a picture, and cut at an alpha they would be blots. Where it has one, shaders/forest/soft-cut.glsl dithers.
 */
export function softenEdges(object: Object3D): void {
  object.onBeforeRender = (renderer, _scene, _camera, _geometry, material: Material) => {
    const smoothed = isSmoothed(renderer);
    if (material.alphaToCoverage === smoothed) return;
    material.alphaToCoverage = smoothed;
    material.needsUpdate = true;
  };
}
