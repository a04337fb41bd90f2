// One tree of ours beside ez-tree's on the same stage: a still of either (?tree=windgrove&species=..&seed=..&view=near or
// ?tree=ez-tree&preset=..), or, with ?measure, the time that a frame of each takes, in turn, in one context.
import { Mesh } from 'three';
import { interleave } from '../src/gpu/interleave.ts';
import { rendererName } from '../src/gpu/renderer-name.ts';
import { Stage } from '../src/view/stage.ts';
import { type Contestant, ezTree, windgroveTree } from './contestants.ts';
import { PAIRS } from './pairs.ts';
import type { BenchReport, FailedReport } from './report.ts';

type View = 'near' | 'whole' | 'far';

const asked = new URLSearchParams(location.search);
const ROUNDS = Number(asked.get('rounds') ?? 9);
const canvas = document.querySelector<HTMLCanvasElement>('#stage')!;
/** Height to which ez-tree's tree is scaled: that of the tree beside it. */
const heightOf = (tree: Contestant): number => tree.box.max.y;

/** Both trees are framed by the same box: the whole of it, three times as far, or a part of the crown from close by. */
function look(stage: Stage, tree: Contestant, view: View): void {
  const { position, target } = stage.frame(tree.box);
  const eye = position.y;
  const factor = { near: 0.36, whole: 1, far: 2.2 }[view];
  stage.controls.target.copy(target);
  stage.camera.position.copy(position).sub(target).multiplyScalar(factor).add(target);
  stage.camera.position.y = view === 'near' ? 0.28 * heightOf(tree) : eye;
}

/** A still: the tree of the query on the stage, once. */
async function still(): Promise<void> {
  const stage = new Stage(canvas, { shadows: 2048, preserveDrawingBuffer: true });
  stage.resize(innerWidth, innerHeight);
  const ours = await windgroveTree(
    asked.get('species') ?? 'quaking-aspen',
    Number(asked.get('seed') ?? 1),
    stage.renderer,
  );
  const theirs = asked.get('tree') === 'ez-tree';
  const tree = theirs ? await ezTree(asked.get('preset') ?? 'Ash Large', heightOf(ours)) : ours;
  stage.scene.add(tree.object);
  look(stage, ours, (asked.get('view') ?? 'whole') as View);
  // The first frame compiles: what a material sets up while compiling moves with the second.
  for (let i = 0; i < 2; i++) {
    tree.update(Number(asked.get('time') ?? 2));
    stage.render();
  }
  document.body.dataset.ready = 'true';
}

const columns = [
  'tree',
  'setting',
  'ours',
  'ez-tree',
  'ratio',
  'leaves, ours',
  'ez-tree',
  'triangles, ours',
  'ez-tree',
  'draws, ours',
  'ez-tree',
] as const;

/** Frame times of both in one setting; a row of the table. */
function row(
  stage: Stage,
  ours: Contestant,
  theirs: Contestant,
  setting: string,
  [rounds, milliseconds] = [ROUNDS, 1000],
): (string | number)[] {
  const { renderer } = stage;
  const gl = renderer.getContext();
  const texel = new Uint8Array(4);
  const drawn = new Map<Contestant, { triangles: number; calls: number }>();
  let n = 0;
  // The wind pass draws as well; the picture alone is counted, as the other has no such pass.
  renderer.info.autoReset = false;
  const subject = (tree: Contestant, other: Contestant) => ({
    name: tree.name,
    run: () => {
      tree.object.visible = true;
      other.object.visible = false;
      tree.update(++n / 30);
      renderer.info.reset();
      stage.render();
      drawn.set(tree, { ...renderer.info.render });
      // Frames must not pile up: a page waits for each.
      gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, texel);
    },
    wait: () => {},
  });
  // Ours comes second: its ratio is by the first of the same round.
  const [b, a] = interleave([subject(theirs, ours), subject(ours, theirs)], rounds, milliseconds);
  return [
    ours.name,
    setting,
    a!.median,
    b!.median,
    a!.ratio,
    ours.leaves(),
    theirs.leaves(),
    drawn.get(ours)!.triangles,
    drawn.get(theirs)!.triangles,
    drawn.get(ours)!.calls,
    drawn.get(theirs)!.calls,
  ];
}

async function measure(): Promise<BenchReport> {
  const stage = new Stage(canvas, { antialias: false, shadows: 1024 });
  stage.resize(1024, 576);
  // Sky, ground and what grows on it.
  const setting = stage.scene.children.filter((object) => object instanceof Mesh);
  const rows: (string | number)[][] = [];
  for (const [species, leafBudget] of [
    ['quaking-aspen', undefined],
    ['california-black-oak', undefined],
    ['california-black-oak', 15_000],
  ] as const) {
    const ours = await windgroveTree(species, 1, stage.renderer, leafBudget === undefined ? {} : { leafBudget });
    const theirs = await ezTree('Ash Large', heightOf(ours));
    stage.scene.add(ours.object, theirs.object);
    for (const [name, surroundings, view] of [
      ['whole tree alone', false, 'whole'],
      ['whole tree on the stage: sky, ground, shadow', true, 'whole'],
      ['far, alone', false, 'far'],
    ] as const) {
      for (const object of setting) object.visible = surroundings;
      stage.sun.castShadow = surroundings;
      look(stage, ours, view);
      rows.push(row(stage, ours, theirs, name));
      console.log(rows.at(-1)!.join(' | '));
      await new Promise((next) => setTimeout(next, 0));
    }
    stage.scene.remove(ours.object, theirs.object);
  }
  const pairs: (string | number)[][] = [];
  for (const object of setting) object.visible = true;
  stage.sun.castShadow = true;
  for (const { preset, species, seed, season } of PAIRS) {
    const ours = await windgroveTree(species, seed, stage.renderer, { season });
    const theirs = await ezTree(preset, heightOf(ours));
    stage.scene.add(ours.object, theirs.object);
    for (const view of ['near', 'whole', 'far'] as const) {
      look(stage, ours, view);
      pairs.push(row(stage, ours, theirs, `${preset}, ${view}`, [5, 250]));
      console.log(pairs.at(-1)!.join(' | '));
      await new Promise((next) => setTimeout(next, 0));
    }
    stage.scene.remove(ours.object, theirs.object);
  }
  return {
    title: 'One whole tree with its wind on, beside ez-tree',
    renderer: rendererName(stage.renderer),
    tables: [
      {
        caption:
          "Milliseconds a frame, median of 9 rounds in turn; ez-tree's Ash Large scaled to the same height; aim: a ratio of at most 0.5",
        columns,
        rows,
      },
      {
        caption:
          'Each preset of ez-tree beside a species of ours on the stage, median of 5 rounds; aim: a ratio of at most 1',
        columns,
        rows: pairs,
      },
    ],
    notes: [
      'Canvas 1024 x 576, no multisampling, the same camera, sun and hemisphere light, each library with its own materials. Ours moves every branch and ' +
        'leaf, and its time includes the wind pass; ez-tree moves its leaves alone. A leaf of ez-tree is a picture of a small twig on two crossed quads. The ' +
        'second oak has a `leafBudget` of 15 000: the rest is left out evenly and the others grow to cover as much.',
    ],
  };
}

if (asked.has('measure')) {
  const report: BenchReport | FailedReport = await measure().catch((error: Error) => ({ error: String(error.stack) }));
  document.querySelector('#report')!.textContent = JSON.stringify(report, null, 2);
} else {
  await still();
}
