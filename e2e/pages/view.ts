import type { BendModelName } from '../../src/core/wind/wind.ts';
import { Stage } from '../../src/view/stage.ts';
import { type Mode, WindTree } from '../../src/view/wind-tree.ts';
import { grown } from './grown.ts';
import { shippedWind } from './shipped-wind.ts';

// One tree on the stage, as the address says: species, seed, wind, model, t, mode, dark, levels, detail, budget, azimuth, and
// view=x,y,z,x,y,z, a camera and its target, for close looks.
const q = new URLSearchParams(location.search);
const text = (name: string, otherwise: string) => q.get(name) ?? otherwise;
const number = (name: string, otherwise: number) => Number(q.get(name) ?? otherwise);
const canvas = document.querySelector('canvas') as HTMLCanvasElement;
const { species, packed, box } = await grown(text('species', 'quaking-aspen'), number('seed', 1));
const stage = new Stage(canvas, {
  antialias: q.has('aa'),
  shadows: number('shadows', 1024),
});
stage.resize(innerWidth, innerHeight, 1);
stage.setDark(q.has('dark'));
const windTree = new WindTree();
windTree.setTree(packed, species);
const wind = await shippedWind(text('wind', 'breeze'));
windTree.setWind({ ...wind, model: text('model', wind.model) as BendModelName });
windTree.mode = text('mode', 'shaded') as Mode;
if (q.has('levels')) windTree.levelsShown = number('levels', 4);
if (q.has('detail')) windTree.detail = text('detail', 'auto') as 'high';
if (q.has('budget')) windTree.leafBudget = number('budget', 1e6);
stage.scene.add(windTree);
stage.frame(box, { azimuth: number('azimuth', 0.2) });
const view = q.get('view')?.split(',').map(Number);
if (view) {
  stage.camera.position.set(view[0], view[1], view[2]);
  stage.controls.target.set(view[3], view[4], view[5]);
  stage.controls.update();
}
const draw = (time: number) => {
  windTree.update(stage.renderer, time);
  stage.blow(windTree.windSource(), time);
  stage.render(true);
};
draw(number('t', 3));
const report = { stats: windTree.stats(), box, camera: stage.camera.position, target: stage.controls.target };
Object.assign(window, { stage, windTree, draw, packed, report, done: true });
