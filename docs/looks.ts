// The page that docs/make-looks.ts takes its pictures from: a tree of ours and a preset of ez-tree, in turn on one stage, from the same places.
import { type Contestant, ezTree, windgroveTree } from '../bench/contestants.ts';
import type { Pair } from '../bench/pairs.ts';
import { Stage } from '../src/view/stage.ts';

/** Pixels of a view, and of a picture of a strip. */
const VIEW = { width: 340, height: 340 };
const FRAME = { width: 168, height: 168 };
/** Frames of a strip, and seconds that it lasts. */
const FRAMES = 6;
const SECONDS = 3;
/** Pixels between the pictures. */
const GAP = 4;

/** How far the camera is, in parts of the way to the whole tree; near looks into the crown. */
const WAYS = { near: 0.34, middle: 1, far: 2.2 } as const;

const stage = new Stage(document.querySelector<HTMLCanvasElement>('#stage')!, {
  shadows: 2048,
  preserveDrawingBuffer: true,
});

function look(ours: Contestant, way: keyof typeof WAYS): void {
  const { position, target } = stage.frame(ours.box);
  const eye = position.y;
  stage.controls.target.copy(target);
  stage.camera.position.copy(position).sub(target).multiplyScalar(WAYS[way]).add(target);
  stage.camera.position.y = way === 'near' ? 0.3 * ours.box.max.y : eye;
}

/** A pair as one picture: near, middle and far beside each other, ours above and theirs below, and below them a strip of each. */
async function picture({ species, seed, preset, season }: Pair): Promise<string> {
  const ours = await windgroveTree(species, seed, stage.renderer, { season });
  const theirs = await ezTree(preset, ours.box.max.y);
  const canvas = document.createElement('canvas');
  const ways = Object.keys(WAYS) as (keyof typeof WAYS)[];
  canvas.width = ways.length * (VIEW.width + GAP) - GAP;
  canvas.height = 2 * (VIEW.height + FRAME.height + 2 * GAP) - GAP;
  const context = canvas.getContext('2d', { alpha: false })!;
  context.fillStyle = '#fbfaf6';
  context.fillRect(0, 0, canvas.width, canvas.height);
  context.imageSmoothingQuality = 'high';
  for (const [row, tree] of [ours, theirs].entries()) {
    stage.scene.add(tree.object);
    const draw = (time: number, x: number, y: number, { width, height }: typeof VIEW): void => {
      tree.update(time);
      stage.render();
      context.drawImage(stage.renderer.domElement, x, y, width, height);
    };
    stage.resize(VIEW.width, VIEW.height, 2);
    for (const [column, way] of ways.entries()) {
      look(ours, way);
      // The first frame compiles: what a material sets up while compiling moves with the second.
      for (let i = 0; i < 2; i++) draw(2, column * (VIEW.width + GAP), row * (VIEW.height + GAP), VIEW);
    }
    stage.resize(FRAME.width, FRAME.height, 2);
    look(ours, 'middle');
    const top = 2 * (VIEW.height + GAP) + row * (FRAME.height + GAP);
    for (let i = 0; i < FRAMES; i++) {
      const left = ((canvas.width - FRAME.width) * i) / (FRAMES - 1);
      draw(2 + (SECONDS * i) / (FRAMES - 1), Math.round(left), top, FRAME);
    }
    stage.scene.remove(tree.object);
  }
  return canvas.toDataURL('image/webp', 0.8);
}

Object.assign(window, { windgroveLook: picture });
