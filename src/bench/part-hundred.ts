import { Box3, Vector3 } from 'three';
import { Grove } from '../view/forest/grove.ts';
import { loadSpecies, loadWind } from '../view/load.ts';
import { Stage } from '../view/stage.ts';
import { newGroveClient } from '../worker/grove-client.ts';
import { ezTree, presetWith } from './ez.ts';
import { timeFrames } from './frame-timer.ts';
import { type Picture, type Section, SIZE } from './section.ts';
import { words } from './words.ts';

/** The one of about as many triangles as a tree of ours takes in that picture stands beside it. No bush: at the height of an aspen it would fill more of the picture. */
const PRESETS = ['Aspen Small', 'Aspen Medium', 'Aspen Large', 'Ash Small', 'Oak Small', 'Oak Medium'];
/** Metres from tree to tree. */
const APART = 5;

/** So many places (x, y) in rows, a little out of line. */
function placesOf(count: number): (readonly [number, number])[] {
  const side = Math.ceil(Math.sqrt(count));
  return Array.from({ length: count }, (_, i) => {
    const [column, row] = [i % side, Math.floor(i / side)];
    const aside = (((i * 7919) % 101) / 101 - 0.5) * 0.5 * APART;
    return [(column - (side - 1) / 2) * APART + aside, (row - (side - 1) / 2) * APART - aside] as const;
  });
}

/** Many trees of ours, all different, beside as many copies of one of ez-tree's. */
export const HUNDRED: Section = {
  id: 'hundred',
  title: words.hundred.title,
  lead: words.hundred.lead,
  async run({ canvas, rounds, milliseconds, trees, step, signal }) {
    const stage = new Stage(canvas, { antialias: false, preserveDrawingBuffer: true });
    const client = newGroveClient();
    const stop = (): void => client.dispose();
    signal.addEventListener('abort', stop);
    try {
      stage.resize(...SIZE);
      const [species, wind] = await Promise.all([
        loadSpecies('species/quaking-aspen.json'),
        loadWind('winds/breeze.json'),
      ]);
      const places = placesOf(trees);
      const half = (Math.sqrt(trees) / 2) * APART + 3;
      await step(words.growing(words.hundred.ours(trees)));
      const began = performance.now();
      const members = places.map(([x, y], i) => ({ seed: i + 1, x, y, z: 0, turn: i * 2.399963 }));
      const grown = await client.grow({ species, members, form: 'full' }, 0).done;
      const top = grown.packed.bounds[5] as number;
      stage.frame(new Box3(new Vector3(-half, 0, -half), new Vector3(half, top, half)));
      const grove = new Grove();
      grove.setGrove(grown.packed, species, grown.light);
      grove.setWind(wind);
      grove.fade.set(-2, -1, 1e9, 2e9);
      grove.setShadows(true, true);
      stage.scene.add(grove);
      const eye = new Vector3();
      let frame = 0;
      const ours = (n: number): void => {
        const { camera } = stage;
        camera.updateMatrixWorld();
        const scale = (camera.projectionMatrix.elements[5] as number) * SIZE[1] * 0.5;
        grove.update(stage.renderer, n / 30, { eye: camera.getWorldPosition(eye), scale, frame: ++frame });
        stage.render();
      };
      const shot = (name: string): Picture => ({ name, url: canvas.toDataURL('image/webp', 0.86) });
      ours(60);
      stage.renderer.getContext().finish();
      const first = (performance.now() - began) / 1000;
      const mine = shot(words.hundred.ours(trees));
      grove.visible = false;
      await step(words.growing(words.hundred.other));
      const preset = await presetWith(grove.stats().triangles / trees, PRESETS);
      const from = performance.now();
      const other = await ezTree(preset, 0.9 * top, places);
      stage.scene.add(other.object);
      other.update(2);
      stage.render();
      stage.renderer.getContext().finish();
      const second = (performance.now() - from) / 1000;
      const name = words.hundred.theirs(trees, other.name);
      const theirs = shot(name);
      await step(words.measuring(words.hundred.title));
      const show = (own: boolean): void => {
        grove.visible = own;
        other.object.visible = !own;
      };
      const timings = timeFrames(
        stage.renderer,
        [
          {
            name,
            draw: (n) => {
              show(false);
              other.update(n / 30);
              stage.render();
            },
          },
          {
            name: mine.name,
            draw: (n) => {
              show(true);
              ours(n + 60);
            },
          },
        ],
        rounds,
        milliseconds,
      );
      const more = [
        [other.bytes, second],
        [grove.stats().bytes, first],
      ] as const;
      const rows = timings.map((timing, i) => {
        const [bytes, seconds] = more[i] as readonly [number, number];
        return [timing.name, timing.triangles, timing.calls, timing.median, timing.ratio, bytes / 1e6, seconds];
      });
      return {
        table: { caption: words.hundred.caption(trees), columns: words.hundred.columns, rows },
        pictures: [theirs, mine],
      };
    } finally {
      signal.removeEventListener('abort', stop);
      client.dispose();
      stage.renderer.forceContextLoss();
      stage.dispose();
    }
  },
};
