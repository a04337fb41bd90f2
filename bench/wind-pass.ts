// Milliseconds a step of the wind pass, by each bend model, beside a pass that only attaches and writes, and beside the same step in TypeScript.
import { WebGLRenderer } from 'three';
import { shippedWind } from '../e2e/pages/shipped-wind.ts';
import floorFragment from '../shaders/debug/floor.frag';
import stepFragment from '../shaders/wind/step.frag';
import { createWindState } from '../src/core/wind/fade.ts';
import { poseTree } from '../src/core/wind/pose-tree.ts';
import type { Wind } from '../src/core/wind/wind.ts';
import { syntheticTree } from '../src/gpu/crosscheck/synthetic-tree.ts';
import { interleave, type Subject, type Timing } from '../src/gpu/interleave.ts';
import { rendererName } from '../src/gpu/renderer-name.ts';
import { STEP } from '../src/gpu/step.ts';
import { TreeTextures } from '../src/gpu/tree-textures.ts';
import { WindPass } from '../src/gpu/wind-pass.ts';
import { windSource } from '../src/gpu/wind-source.ts';
import { LaggedStepper } from './lagged-stepper.ts';

interface Row {
  readonly pieces: number;
  readonly depths: number;
  readonly timings: readonly Timing[];
  /** The bend models beside each other; the first is the paper's. */
  readonly models: readonly Timing[];
}

const query = new URLSearchParams(location.search);
const SIZES = (query.get('sizes') ?? '1024,4096,16384,65536,262144').split(',').map(Number);
const ROUNDS = Number(query.get('rounds') ?? 9);
const DEPTHS = Number(query.get('depths') ?? 7);

const renderer = new WebGLRenderer({ antialias: false });
const texel = new Float32Array(4);
const wind: Wind = { ...(await shippedWind('fresh-breeze')), model: 'direct' };

function measure(pieces: number): Row {
  const tree = syntheticTree(pieces, DEPTHS);
  const exact = windSource({ ...wind, pose: 'exact' });
  const lagged = windSource({ ...wind, pose: 'lagged' });

  const stepper = (name: string, fragment: string, defines?: Record<string, number>): Subject & { dispose(): void } => {
    const it = new LaggedStepper(tree, fragment, lagged, defines);
    return {
      name,
      run: () => it.step(renderer, lagged),
      wait: () => it.wait(renderer, texel),
      dispose: () => it.dispose(),
    };
  };
  const textures = new TreeTextures(tree, true);
  const pass = (name: string, source: typeof exact, between = 0): Subject & { dispose(): void } => {
    const it = new WindPass(textures);
    let step = between;
    return {
      name,
      run: () => it.update(renderer, ++step * STEP, source),
      wait: () => renderer.readRenderTargetPixels(textures.pose.targets![0], 0, 0, 1, 1, texel),
      dispose: () => it.dispose(),
    };
  };
  const state = createWindState();
  const pose = tree.restPose.data.slice();
  let time = 0;
  const subjects = [
    stepper('floor: attach and write, all at once', floorFragment),
    stepper('step, all at once', stepFragment),
    pass('WindPass lagged', lagged),
    pass('WindPass exact', exact),
    {
      name: 'TypeScript poseTree',
      run: () => {
        time += STEP;
        exact.fill(time, state);
        poseTree(tree, state, 'exact', undefined, pose);
      },
      wait: () => {},
      dispose: () => {},
    },
  ];
  const timings = interleave(subjects, ROUNDS);
  const passes = (['direct', 'spring', 'sway'] as const).map((model) => pass(model, windSource({ ...wind, model })));
  passes.push(pass('spring between steps', windSource({ ...wind, model: 'spring' }), 0.4));
  const models = interleave(passes, ROUNDS);
  for (const subject of [...subjects, ...passes]) subject.dispose();
  textures.dispose();
  return { pieces, depths: tree.depthStart.length - 1, timings, models };
}

const show = (id: string, text: string) => {
  document.getElementById(id)!.textContent = text;
};

async function run(): Promise<void> {
  const rows: Row[] = [];
  for (const size of SIZES) {
    show('state', `Measuring ${size} pieces …`);
    await new Promise((resolve) => setTimeout(resolve, 20));
    rows.push(measure(size));
  }
  show('state', 'Done.');
  show('report', JSON.stringify({ renderer: rendererName(renderer), unit: 'ms a step', rows }, null, 1));
}

run();
