import { DirectionalLight, HemisphereLight, PerspectiveCamera, Scene, WebGLRenderer } from 'three';
import { DEFAULT_FOREST } from '../../src/core/forest/default-forest.ts';
import { treePixels } from '../../src/core/forest/fade.ts';
import type { TreePlaces } from '../../src/core/forest/forest.ts';
import { levelField } from '../../src/core/forest/height-field.ts';
import { hillsField } from '../../src/core/forest/terrain.ts';
import { growPacked } from '../../src/core/pack/grow-packed.ts';
import { parseSpecies } from '../../src/core/species/parse.ts';
import { Forest, type ForestStats } from '../../src/view/forest/forest.ts';
import { variantSeed } from '../../src/view/forest/forest-plan.ts';
import { newGroveClient } from '../../src/worker/grove-client.ts';
import { small } from './grown.ts';

// Small forests on one renderer, for what must hold of any: nothing is left behind, nothing pops, little is drawn.

const canvas = document.querySelector('canvas') as HTMLCanvasElement;
const renderer = new WebGLRenderer({ canvas, antialias: false, preserveDrawingBuffer: true });
renderer.shadowMap.enabled = true;
renderer.setClearColor('#9fb6c8');
const scene = new Scene();
const sun = new DirectionalLight('#fff', 3);
sun.position.set(3, 5, 2);
scene.add(sun, new HemisphereLight('#dfe8ff', '#8a8060', 1.5));
const camera = new PerspectiveCamera(40, canvas.width / canvas.height, 0.2, 2000);
const client = newGroveClient();
const aspen = parseSpecies(await (await fetch('/species/quaking-aspen.json')).text()).species;
if (!aspen) throw new Error('no aspen');
const shape = small(aspen);
const species = new Map([['quaking-aspen', shape]]);
const pictures = { views: 4, size: 32 };
const MEGABYTE = 2 ** 20;

/** What three has on the GPU. */
export interface Held {
  readonly geometries: number;
  readonly textures: number;
  readonly programs: number;
}

const held = (): Held => ({ ...renderer.info.memory, programs: renderer.info.programs?.length ?? 0 });

const pause = (): Promise<void> => new Promise((done) => setTimeout(done));

let now = 0;

/** Frames until nothing grows, is photographed or fades. `passed`: milliseconds a frame. */
async function settle(forest: Forest, passed = 200): Promise<void> {
  do {
    now += passed;
    forest.update(renderer, camera, 3, now);
    await pause();
  } while (!forest.settled);
}

/** `count` trees on an arc around the origin, `away` metres off. */
function arc(count: number, away: number): TreePlaces {
  const angle = (i: number): number => Math.PI * (0.5 + 0.5 * ((i + 0.5) / count - 0.5));
  return {
    count,
    x: Float32Array.from({ length: count }, (_, i) => away * Math.cos(angle(i))),
    y: Float32Array.from({ length: count }, (_, i) => away * Math.sin(angle(i))),
    z: new Float32Array(count),
    turn: Float32Array.from({ length: count }, (_, i) => i),
    species: new Uint8Array(count),
    variant: Uint32Array.from({ length: count }, (_, i) => i),
  };
}

async function enter(): Promise<Forest> {
  const forest = new Forest({ client, pictures, memoryBudget: 20 * MEGABYTE });
  scene.add(forest);
  // At this height of the picture all classes are there.
  forest.thresholds = { near: 34, middle: 14 };
  forest.setForest({ ...DEFAULT_FOREST, size: 120 }, species, levelField(120), arc(12, 38));
  await settle(forest);
  renderer.render(scene, camera);
  return forest;
}

function leave(forest: Forest): void {
  scene.remove(forest);
  forest.dispose();
}

function look(x: number, y: number, z: number, atX: number, atY: number, atZ: number): void {
  camera.position.set(x, y, z);
  camera.lookAt(atX, atY, atZ);
  camera.updateMatrixWorld();
}

/** Enters and leaves a forest `times` times while another one stands; what is held after one time, and in the end. */
async function comeAndGo(times: number): Promise<{ first: Held; last: Held; drawn: ForestStats }> {
  look(0, 5, 4, 0, 6, -38);
  leave(await enter());
  const first = held();
  // Its programs are shared, as those of a page that shows one forest after the other would be.
  const standing = await enter();
  const drawn = standing.stats();
  for (let i = 0; i < times; i++) leave(await enter());
  leave(standing);
  return { first, last: held(), drawn };
}

function picture(): Uint8Array {
  renderer.render(scene, camera);
  const gl = renderer.getContext();
  const pixels = new Uint8Array(4 * canvas.width * canvas.height);
  gl.readPixels(0, 0, canvas.width, canvas.height, gl.RGBA, gl.UNSIGNED_BYTE, pixels);
  return pixels;
}

/** Metres that the camera goes from frame to frame, and to the trees of a flight at its middle. */
const STEP = 0.05;
const AWAY = 43;

/**
 * Mean differences of consecutive frames of a flight in small steps, in the middle of which `entered` begins for all trees at once: one
 * shape at one distance. `fade`: as `crossFade` of the forest.
 */
async function flight(
  frames: number,
  entered: 'near' | 'middle',
  fade: number,
): Promise<{ steps: number[]; seen: ForestStats[] }> {
  const forest = new Forest({ client, pictures, memoryBudget: 20 * MEGABYTE });
  scene.add(forest);
  forest.crossFade = fade;
  forest.holdStep(0);
  const height = growPacked(shape, variantSeed(DEFAULT_FOREST, 0, 0)).packed.bounds[5] as number;
  const scale = (camera.projectionMatrix.elements[5] as number) * 0.5 * canvas.height;
  const pixels = treePixels([0, AWAY, 0], height, [0, 0, 5], scale);
  forest.thresholds = entered === 'near' ? { near: pixels, middle: pixels / 3 } : { near: 1e4, middle: pixels };
  forest.setForest({ ...DEFAULT_FOREST, size: 120 }, species, levelField(120), arc(12, AWAY));
  const at = (i: number): void => look(0, 5, STEP * (frames / 2 - i - 0.5), 0, 6, -AWAY);
  at(0);
  await settle(forest);
  const steps: number[] = [];
  const seen: ForestStats[] = [];
  let before: Uint8Array | null = null;
  for (let i = 0; i <= frames; i++) {
    at(i);
    now += 100;
    forest.update(renderer, camera, 3, now);
    // What was asked for comes before the next frame, as on a machine that keeps up.
    while (forest.stats().growing > 0) {
      await pause();
      forest.update(renderer, camera, 3, now);
    }
    const drawn = picture();
    if (before) {
      let sum = 0;
      for (let k = 0; k < drawn.length; k++) sum += Math.abs((drawn[k] as number) - (before[k] as number));
      steps.push(sum / (0.75 * drawn.length));
    }
    before = drawn;
    seen.push(forest.stats());
  }
  leave(forest);
  return { steps, seen };
}

/** What a hillside of 300 trees takes. */
async function hillside(): Promise<{ stats: ForestStats; calls: number }> {
  const document = { ...DEFAULT_FOREST, count: 300, size: 200 };
  if (document.terrain.kind !== 'hills') throw new Error('no hills');
  const field = hillsField(document.terrain, document.size);
  const forest = new Forest({ client, pictures, memoryBudget: 60 * MEGABYTE });
  scene.add(forest);
  forest.thresholds = { near: 60, middle: 20 };
  forest.setForest(document, species, field);
  look(0, 12, 90, 0, 20, -40);
  await settle(forest);
  renderer.render(scene, camera);
  const found = { stats: forest.stats(), calls: renderer.info.render.calls };
  leave(forest);
  return found;
}

export type ForestInvariants = {
  readonly comeAndGo: typeof comeAndGo;
  readonly flight: typeof flight;
  readonly hillside: typeof hillside;
};

Object.assign(window, { forestInvariants: { comeAndGo, flight, hillside } satisfies ForestInvariants });
document.body.dataset.ready = 'true';
