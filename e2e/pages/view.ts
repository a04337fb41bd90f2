import { Box3 } from 'three';
import { grow } from '../../src/core/grow/grow.ts';
import { packTree } from '../../src/core/pack/pack.ts';
import { attachLeaves } from '../../src/core/pieces/attach-leaves.ts';
import { fitPieces } from '../../src/core/pieces/fit-pieces.ts';
import type { Species } from '../../src/core/species/species.ts';
import { presets } from '../../src/core/wind/presets.ts';
import type { Wind } from '../../src/core/wind/wind.ts';
import { Stage } from '../../src/view/stage.ts';
import { type Mode, WindTree } from '../../src/view/wind-tree.ts';

// One tree on the stage, as the address says: species, seed, wind, t, mode, dark, and a camera for close views.
const q = new URLSearchParams(location.search);
const text = (name: string, otherwise: string) => q.get(name) ?? otherwise;
const number = (name: string, otherwise: number) => Number(q.get(name) ?? otherwise);
const canvas = document.querySelector('canvas') as HTMLCanvasElement;
const report: Record<string, unknown> = {};
const species: Species = await (await fetch(`/species/${text('species', 'quaking-aspen')}.json`)).json();
let t0 = performance.now();
const tree = grow(species, number('seed', 1));
report.grow = performance.now() - t0;
t0 = performance.now();
const pieces = fitPieces(tree);
const packed = packTree(tree, pieces, attachLeaves(tree, pieces));
report.pack = performance.now() - t0;
const stage = new Stage(canvas, { antialias: q.has('aa'), shadows: number('shadows', 1024) });
stage.resize(innerWidth, innerHeight, 1);
const sun = q.get('sun')?.split(',').map(Number);
if (sun) stage.sun.direction.set(sun[0], sun[1], sun[2]).normalize();
stage.setDark(q.has('dark'));
if (q.has('tone')) stage.renderer.toneMapping = number('tone', 4) as 4; // 3 Cineon, 4 ACES, 6 AgX, 7 Neutral
const windTree = new WindTree();
windTree.setTree(packed, species);
windTree.setWind(presets[text('wind', 'breeze')] as Wind);
windTree.mode = text('mode', 'shaded') as Mode;
if (q.has('levels')) windTree.levelsShown = number('levels', 4);
if (q.has('detail')) windTree.detail = text('detail', 'auto') as 'high';
if (q.has('budget')) windTree.leafBudget = number('budget', 1e6);
stage.scene.add(windTree);
const b = packed.bounds;
const box = new Box3();
box.min.set(b[0], b[2], -b[4]);
box.max.set(b[3], b[5], -b[1]);
stage.frame(box, number('azimuth', 0.2));
const view = q.get('view')?.split(',').map(Number);
if (view) {
  stage.camera.position.set(view[0], view[1], view[2]);
  stage.controls.target.set(view[3], view[4], view[5]);
  stage.controls.update();
}
const draw = (time: number) => {
  windTree.update(stage.renderer, time);
  stage.render(true);
};
draw(number('t', 3));
t0 = performance.now();
draw(number('t', 3));
const gl = stage.renderer.getContext();
gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, new Uint8Array(4));
report.frame = performance.now() - t0;
report.stats = windTree.stats();
report.box = [box.min.toArray(), box.max.toArray()];
report.camera = [stage.camera.position.toArray(), stage.controls.target.toArray()];
Object.assign(window, { stage, windTree, draw, packed, tree, pieces, done: true, report });
