import type { WebGLRenderer } from 'three';
import type { PackedTree } from '../../core/pack/packed.ts';
import type { Wind } from '../../core/wind/wind.ts';
import { STEP } from '../step.ts';
import { windSource } from '../wind-source.ts';
import { passOf, seek } from './pass-checks.ts';
import { differing } from './pose-distance.ts';
import { type Check, check } from './report.ts';

const SOME_STEP = 33;

/** One event of the canvas, or nothing after `milliseconds`. */
const eventOf = (canvas: HTMLCanvasElement, name: string, milliseconds = 5000): Promise<boolean> =>
  new Promise((resolve) => {
    const timer = setTimeout(() => resolve(false), milliseconds);
    canvas.addEventListener(
      name,
      () => {
        clearTimeout(timer);
        resolve(true);
      },
      { once: true },
    );
  });

/**
 * A lost and restored context gives float targets back empty: the pose afterwards must be the one before, in both modes.
 * No sample where this browser cannot lose a context on purpose.
 */
export async function checkContextLoss(renderer: WebGLRenderer, tree: PackedTree, wind: Wind): Promise<Check[]> {
  const { pass, dispose } = passOf(tree);
  const sources = [windSource({ ...wind, pose: 'exact' }), windSource({ ...wind, pose: 'lagged' })];
  const pose = (i: number) => {
    seek(renderer, pass, SOME_STEP * STEP, sources[i]);
    return pass.read(renderer);
  };
  const before = sources.map((_, i) => pose(i));
  const extension = renderer.getContext().getExtension('WEBGL_lose_context');
  const canvas = renderer.domElement;
  let restored = false;
  if (extension) {
    const lost = eventOf(canvas, 'webglcontextlost');
    extension.loseContext();
    if (await lost) {
      pass.update(renderer, SOME_STEP * STEP, sources[0]); // a frame that falls into the gap does no harm
      await new Promise((resolve) => setTimeout(resolve)); // not from within the event: browsers refuse that
      const back = eventOf(canvas, 'webglcontextrestored');
      extension.restoreContext();
      restored = await back;
    }
  }
  // Backwards: the last pose before the loss is asked for first, for the same time, and yet must be computed again.
  const checks: Check[] = [];
  for (const i of [1, 0]) {
    const changed = restored ? differing(pose(i), before[i]) : Number.NaN;
    const name = `wind pass, ${wind.model}, ${sources[i].pose}, after a lost context`;
    const note = 'numbers that differ from those of the pose before: none';
    checks.push(check(name, restored ? tree.pieceCount : 0, changed, 0, note));
  }
  dispose();
  return checks;
}
