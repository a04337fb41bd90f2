import type { WebGLRenderer } from 'three';
import type { PackedTree } from '../../core/pack/packed.ts';
import { WindFader } from '../../core/wind/fade.ts';
import type { Wind } from '../../core/wind/wind.ts';
import { STEP } from '../step.ts';
import { TreeTextures } from '../tree-textures.ts';
import { WindPass } from '../wind-pass.ts';
import { type WindSource, windSource } from '../wind-source.ts';
import { passOf, seek } from './pass-checks.ts';
import { differing, poseDistance } from './pose-distance.ts';
import { type Check, check } from './report.ts';

/** A wind that is edited while it blows, as a page does it. */
export class EditedWind implements WindSource {
  readonly pose = 'exact';
  revision = 1;
  past = 1;
  readonly #fader: WindFader;

  constructor(wind: Wind) {
    this.#fader = new WindFader(wind);
  }

  get epoch(): number {
    return this.#fader.epoch;
  }

  fill: WindSource['fill'] = (time, out) => {
    this.#fader.at(time, undefined, out);
  };

  set(wind: Wind, time: number, seconds: number): void {
    this.#fader.set(wind, time, seconds);
    this.revision++;
    this.past++;
  }
}

const EDIT = 60;
const LATER = 130;
const SOUGHT = 45;

/**
 * An edit while playing: nothing jumps, the springs swing on; and seeking afterwards gives what the new wind alone would have given, to
 * the last bit.
 */
export function checkEdit(renderer: WebGLRenderer, tree: PackedTree, before: Wind, after: Wind): Check[] {
  const source = new EditedWind(before);
  const edited = passOf(tree);
  for (let step = 0; step <= EDIT; step++) edited.pass.update(renderer, step * STEP, source);
  const last = edited.pass.read(renderer).slice();
  source.set(after, EDIT * STEP, 1);
  edited.pass.update(renderer, EDIT * STEP, source);
  const jumped = differing(edited.pass.read(renderer), last);
  for (let step = EDIT; step <= LATER; step++) edited.pass.update(renderer, step * STEP, source);
  const swung = differing(edited.pass.read(renderer), last);
  const alone = passOf(tree);
  let apart = 0;
  for (const step of [SOUGHT, LATER]) {
    seek(renderer, edited.pass, step * STEP, source);
    seek(renderer, alone.pass, step * STEP, windSource(after));
    apart += differing(edited.pass.read(renderer), alone.pass.read(renderer));
  }
  edited.dispose();
  alone.dispose();
  const samples = swung > tree.pieceCount ? tree.pieceCount : 0;
  return [
    check('wind pass, spring, an edit while playing', samples, jumped, 0, 'numbers that it changes at once: none'),
    check(
      'wind pass, spring, sought after an edit',
      samples,
      apart,
      0,
      'numbers that differ from the new wind’s alone: none',
    ),
  ];
}

/** Far into a wind, before its springs have been run there, a tree is shown as it would come to rest: as the paper bends it. */
export function checkStandIn(renderer: WebGLRenderer, tree: PackedTree, wind: Wind): Check {
  const far = 100;
  const swinging = passOf(tree);
  const direct = passOf(tree);
  swinging.pass.update(renderer, far, windSource({ ...wind, model: 'spring' }));
  direct.pass.update(renderer, far, windSource({ ...wind, model: 'direct' }));
  const samples = swinging.pass.catchingUp === null ? 0 : 4 * tree.pieceCount;
  const { points } = poseDistance(tree, swinging.pass.read(renderer), direct.pass.read(renderer));
  swinging.dispose();
  direct.dispose();
  return check('wind pass, spring, while it catches up', samples, points, 2e-5, 'of the tree’s height; against direct');
}

/** What is read back without waiting must be what is read at once, for the tree and for single pieces. */
export async function checkReadBack(renderer: WebGLRenderer, tree: PackedTree, wind: Wind): Promise<Check[]> {
  const { pass, dispose } = passOf(tree);
  const checks: Check[] = [];
  for (const pose of ['exact', 'lagged'] as const) {
    const source = windSource({ ...wind, pose });
    seek(renderer, pass, 0.5, source);
    const now = pass.read(renderer).slice();
    const state = pass.readState(renderer);
    const some = [0, 1, Math.floor(tree.pieceCount / 2), tree.pieceCount - 1];
    const asked = pass.readBack(renderer);
    const askedPieces = some.map((piece) => pass.readPiece(renderer, piece));
    // What is computed meanwhile must not be what is read.
    pass.update(renderer, 0.75, source);
    const all = await asked;
    const pieces = await Promise.all(askedPieces);
    const plane = now.length / 4;
    const wanted = some.map((piece) =>
      Float32Array.from({ length: 16 }, (_, k) => now[Math.floor(k / 4) * plane + 4 * piece + (k % 4)]),
    );
    const apart =
      differing(all?.pose ?? null, now) +
      differing(all?.state ?? null, state) +
      pieces.reduce((sum, piece, i) => sum + differing(piece, wanted[i]), 0);
    const none = await pass.readPiece(renderer, tree.pieceCount);
    const note = 'numbers that differ from those read at once: none';
    checks.push(check(`wind pass, ${pose}, read back`, tree.pieceCount, none ? Infinity : apart, 0, note));
  }
  dispose();
  return checks;
}

/** Textures and geometries before a pass came and after it went: springs, checkpoints and all. */
export function checkDispose(renderer: WebGLRenderer, tree: PackedTree, winds: readonly Wind[]): Check {
  const count = () => renderer.info.memory.geometries + renderer.info.memory.textures;
  const before = count();
  const textures = new TreeTextures(tree, true);
  const pass = new WindPass(textures);
  for (const wind of winds) seek(renderer, pass, 2, windSource(wind));
  const during = count();
  pass.dispose();
  textures.dispose();
  const note = 'textures and geometries that are left when a tree is gone: none';
  return check('wind pass, dispose', during - before, count() - before, 0, note);
}
