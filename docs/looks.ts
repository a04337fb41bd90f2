// The page that docs/make-looks.ts takes its pictures from: a tree of ours and a preset of ez-tree, in turn on one stage, from the same places.
import { type Contestant, ezTree, windgroveTree } from '../bench/contestants.ts';
import type { Pair } from '../bench/pairs.ts';
import { Stage } from '../src/view/stage.ts';

/** Pixels of a view, and of a picture of a strip. */
const VIEW = { width: 400, height: 400 };
const FRAME = { width: 128, height: 148 };
/** Frames of a strip, and seconds that it lasts. */
const FRAMES = 6;
const SECONDS = 3;
/** Pixels between the pictures. */
const GAP = 4;

/** How far the camera is, in parts of the way to the whole tree; near looks into the crown. */
const WAYS = { near: 0.34, middle: 1, far: 3 } as const;

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

/** A pair as one picture: near, middle and far below each other, ours left and theirs right, and below them a strip of each. */
async function picture({ species, seed, preset, season }: Pair): Promise<string> {
  const ours = await windgroveTree(species, seed, stage.renderer, { season });
  const theirs = await ezTree(preset, ours.box.max.y);
  const canvas = document.createElement('canvas');
  const across = FRAMES * FRAME.width + (FRAMES - 1) * GAP;
  canvas.width = 2 * VIEW.width + GAP;
  const rows = Object.keys(WAYS) as (keyof typeof WAYS)[];
  canvas.height = rows.length * (VIEW.height + GAP) + 2 * (FRAME.height + GAP);
  const context = canvas.getContext('2d', { alpha: false })!;
  context.fillStyle = '#fbfaf6';
  context.fillRect(0, 0, canvas.width, canvas.height);
  context.imageSmoothingQuality = 'high';
  for (const [column, tree] of [ours, theirs].entries()) {
    stage.scene.add(tree.object);
    const draw = (time: number, x: number, y: number, width: number, height: number): void => {
      tree.update(time);
      stage.render();
      context.drawImage(stage.renderer.domElement, x, y, width, height);
    };
    stage.resize(VIEW.width, VIEW.height, 2);
    // The first frame compiles: what a material sets up while compiling moves with the second.
    for (const [row, way] of rows.entries()) {
      look(ours, way);
      for (let i = 0; i < 2; i++)
        draw(2, column * (VIEW.width + GAP), row * (VIEW.height + GAP), VIEW.width, VIEW.height);
    }
    stage.resize(FRAME.width, FRAME.height, 2);
    look(ours, 'middle');
    const top = rows.length * (VIEW.height + GAP) + column * (FRAME.height + GAP);
    const left = (canvas.width - across) / 2;
    for (let i = 0; i < FRAMES; i++)
      draw(2 + (SECONDS * i) / (FRAMES - 1), left + i * (FRAME.width + GAP), top, FRAME.width, FRAME.height);
    stage.scene.remove(tree.object);
  }
  return canvas.toDataURL('image/webp', 0.8);
}

Object.assign(window, { windgroveLook: picture });
