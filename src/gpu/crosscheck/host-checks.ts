import { Color, Vector4, type WebGLRenderer, WebGLRenderTarget } from 'three';
import type { PackedTree } from '../../core/pack/packed.ts';
import type { Wind } from '../../core/wind/wind.ts';
import { CpuPoser } from '../cpu-poser.ts';
import { STEP } from '../step.ts';
import { TreeTextures } from '../tree-textures.ts';
import { WindPass } from '../wind-pass.ts';
import { type WindSource, windSource } from '../wind-source.ts';
import { poseDistance } from './pose-distance.ts';
import { type Check, check } from './report.ts';

const SOME_STEP = 33;

/** Every setting of a renderer that a pass might disturb, and the state of GL that three keeps in mind for it. */
function settingsOf(renderer: WebGLRenderer): unknown[] {
  const gl = renderer.getContext();
  const { info, shadowMap, xr } = renderer;
  return [
    renderer.getRenderTarget(),
    renderer.getActiveCubeFace(),
    renderer.getActiveMipmapLevel(),
    ...renderer.getViewport(new Vector4()).toArray(),
    ...renderer.getScissor(new Vector4()).toArray(),
    renderer.getScissorTest(),
    renderer.getClearColor(new Color()).getHex(),
    renderer.getClearAlpha(),
    renderer.autoClear,
    renderer.toneMapping,
    renderer.outputColorSpace,
    xr.enabled,
    shadowMap.autoUpdate,
    shadowMap.needsUpdate,
    info.autoReset,
    info.render.calls,
    info.render.triangles,
    ...gl.getParameter(gl.VIEWPORT),
    gl.isEnabled(gl.SCISSOR_TEST),
    gl.getParameter(gl.FRAMEBUFFER_BINDING),
  ];
}

const BROKEN = new Error('a source that throws');

/** A pass leaves the renderer as it found it: unusual settings, drawing to the canvas and to a target, its source throwing. */
export function checkSettings(renderer: WebGLRenderer, tree: PackedTree, wind: Wind): Check {
  const textures = new TreeTextures(tree, true);
  const pass = new WindPass(textures);
  const target = new WebGLRenderTarget(8, 4);
  renderer.setViewport(1, 2, 3, 4);
  renderer.setScissor(2, 1, 5, 6);
  renderer.setScissorTest(true);
  renderer.setClearColor(0x123456, 0.5);
  renderer.shadowMap.needsUpdate = true;
  const { autoClear, xr, shadowMap, info } = renderer;
  const broken: WindSource = {
    ...windSource(wind),
    fill: () => {
      throw BROKEN;
    },
  };
  let samples = 0;
  let changed = 0;
  for (const current of [null, target]) {
    renderer.setRenderTarget(current);
    // Once one way and once the other: a setting that a pass leaves as it wants it would pass one of them.
    const on = current === null;
    renderer.autoClear = on;
    xr.enabled = on;
    shadowMap.autoUpdate = on;
    info.autoReset = on;
    const before = settingsOf(renderer);
    for (const source of [windSource(wind), broken]) {
      try {
        pass.update(renderer, ++samples, source);
      } catch (error) {
        if (error !== BROKEN) throw error;
      }
      const after = settingsOf(renderer);
      changed += before.filter((value, i) => value !== after[i]).length;
      samples += before.length;
    }
  }
  renderer.setRenderTarget(null);
  renderer.setScissorTest(false);
  renderer.autoClear = autoClear;
  xr.enabled = false;
  shadowMap.autoUpdate = true;
  shadowMap.needsUpdate = false;
  info.autoReset = true;
  target.dispose();
  pass.dispose();
  textures.dispose();
  return check('wind pass, settings of the renderer', samples, changed, 0, 'settings that it changed');
}

/** Without float targets the CPU poses the tree: it must be the tree that the GPU makes. */
export function checkCpuPoser(renderer: WebGLRenderer, name: string, tree: PackedTree, wind: Wind): Check {
  const [cpu, gpu] = [false, true].map((gpuPose) => {
    const textures = new TreeTextures(tree, gpuPose);
    const poser = gpuPose ? new WindPass(textures) : new CpuPoser(textures);
    do poser.update(renderer, SOME_STEP * STEP, windSource(wind));
    while (poser.catchingUp !== null);
    const pose = poser.read(renderer);
    poser.dispose();
    textures.dispose();
    return pose;
  });
  const { points } = poseDistance(tree, cpu, gpu);
  return check(
    `pose on the CPU, ${name}, ${wind.model}`,
    4 * tree.pieceCount,
    points,
    2e-5,
    'of the tree’s height; against the GPU’s',
  );
}
