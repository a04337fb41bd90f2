import { MeshStandardMaterial, Object3D, type WebGLRenderer, WebGLRenderTarget } from 'three';
import { expect, test } from 'vitest';
import { softenEdges } from '../../../src/view/forest/soft-edges.ts';

const renderer = (antialias: boolean, target: WebGLRenderTarget | null = null) =>
  ({
    getRenderTarget: () => target,
    getContext: () => ({ getContextAttributes: () => ({ antialias }) }),
  }) as unknown as WebGLRenderer;

test('alpha goes into the samples of a pixel where it has several, and the program is made anew only when that changes', () => {
  const thing = new Object3D();
  softenEdges(thing);
  const material = new MeshStandardMaterial();
  const drawnBy = (by: WebGLRenderer): [boolean, number] => {
    thing.onBeforeRender(by, null as never, null as never, null as never, material, null as never);
    return [material.alphaToCoverage, material.version];
  };
  const smooth = renderer(true);
  expect(drawnBy(renderer(false))).toEqual([false, 0]);
  expect(drawnBy(smooth)).toEqual([true, 1]);
  expect(drawnBy(smooth)).toEqual([true, 1]);
  expect(drawnBy(renderer(true, new WebGLRenderTarget(4, 4)))).toEqual([false, 2]);
  expect(drawnBy(renderer(false, new WebGLRenderTarget(4, 4, { samples: 4 })))).toEqual([true, 3]);
});
