import {
  AmbientLight,
  DirectionalLight,
  Fog,
  Mesh,
  MeshLambertMaterial,
  PerspectiveCamera,
  Plane,
  PlaneGeometry,
  PMREMGenerator,
  PointLight,
  Raycaster,
  Scene,
  SpotLight,
  Vector3,
  WebGLRenderer,
} from 'three';
import { RoomEnvironment } from 'three/addons/environments/RoomEnvironment.js';
import { POSE_TARGETS, TEXEL } from '../../src/core/pack/layout.ts';
import type { Wind } from '../../src/core/wind/wind.ts';
import { type Mode, WindTree } from '../../src/view/wind-tree.ts';
import { grown, small } from './grown.ts';
import { shippedWind } from './shipped-wind.ts';

// WindTree in a plain three.js scene, for e2e/view.spec.ts: each function of `window.home` tries one thing and tells what it saw.
const canvas = document.querySelector('canvas') as HTMLCanvasElement;
const renderer = new WebGLRenderer({ canvas, antialias: false, preserveDrawingBuffer: true });
renderer.setSize(320, 240, false);
renderer.shadowMap.enabled = true;
renderer.info.autoReset = true;
const tree = await grown('quaking-aspen', 1, small);
const camera = new PerspectiveCamera(35, 4 / 3, 0.1, 200);
const look = (from: Vector3, to: Vector3) => {
  camera.position.copy(from);
  camera.lookAt(to);
};
const whole = () => look(new Vector3(8, 6, 32), new Vector3(0, 8, 0));

// Without state: what is tried here is the tree in its scene, and any time comes at once.
const winds = {
  still: await directWind('still'),
  'fresh-breeze': await directWind('fresh-breeze'),
  gale: await directWind('gale'),
};
async function directWind(id: string): Promise<Wind> {
  return { ...(await shippedWind(id)), model: 'direct' };
}

function newTree(wind: keyof typeof winds = 'fresh-breeze'): WindTree {
  const windTree = new WindTree();
  windTree.setTree(tree.packed, tree.species);
  windTree.setWind(winds[wind]);
  return windTree;
}

function litScene(...trees: WindTree[]): Scene {
  const scene = new Scene();
  const sun = new DirectionalLight('#ffffff', 3);
  sun.position.set(12, 20, 6);
  sun.castShadow = true;
  sun.shadow.mapSize.setScalar(512);
  Object.assign(sun.shadow.camera, { left: -12, right: 12, top: 12, bottom: -12, far: 60 });
  const ground = new Mesh(new PlaneGeometry(60, 60), new MeshLambertMaterial({ color: '#b0b0a0' }));
  ground.rotation.x = -Math.PI / 2;
  ground.receiveShadow = true;
  scene.add(new AmbientLight('#ffffff', 0.8), sun, ground, ...trees);
  return scene;
}

function pixels(): Uint8Array {
  const gl = renderer.getContext();
  const data = new Uint8Array(320 * 240 * 4);
  gl.readPixels(0, 0, 320, 240, gl.RGBA, gl.UNSIGNED_BYTE, data);
  return data;
}

function draw(scene: Scene, trees: WindTree[], time: number): Uint8Array {
  for (const windTree of trees) windTree.update(renderer, time);
  renderer.render(scene, camera);
  return pixels();
}

/** Part of the pixels that differ between two pictures. */
function changed(a: Uint8Array, b: Uint8Array): number {
  let n = 0;
  for (let i = 0; i < a.length; i += 4) if (a[i] !== b[i] || a[i + 1] !== b[i + 1] || a[i + 2] !== b[i + 2]) n++;
  return n / (a.length / 4);
}

/** Mean displacement of the pieces' ends from rest, world x and z. */
function meanSway(windTree: WindTree): [number, number] {
  const { packed } = tree;
  const pose = windTree.readPose(renderer) as Float32Array;
  const first = POSE_TARGETS.P3 * packed.restPose.width * packed.restPose.height * TEXEL;
  const sum = new Vector3();
  for (let i = 0; i < packed.pieceCount; i++) {
    const t = first + i * TEXEL;
    const d = [0, 1, 2].map((k) => pose[t + k] - packed.restPose.data[t + k]);
    sum.add(new Vector3(d[0], d[2], -d[1]).transformDirection(windTree.matrixWorld).multiplyScalar(Math.hypot(...d)));
  }
  return [sum.x / packed.pieceCount, sum.z / packed.pieceCount];
}

const home = {
  /** Every kind of light with shadows, fog, an environment map and a clipping plane at once. */
  everything() {
    const windTree = newTree();
    const scene = litScene(windTree);
    const point = new PointLight('#ffd0a0', 300);
    point.position.set(-4, 9, 5);
    const spot = new SpotLight('#a0c0ff', 600, 0, 0.5);
    spot.position.set(-9, 16, 9);
    spot.target.position.set(0, 8, 0);
    for (const light of [point, spot]) {
      light.castShadow = true;
      light.shadow.mapSize.setScalar(256);
      scene.add(light);
    }
    scene.add(spot.target);
    scene.fog = new Fog('#c0d0e0', 10, 80);
    scene.environment = new PMREMGenerator(renderer).fromScene(new RoomEnvironment(), 0.04).texture;
    whole();
    const plain = draw(scene, [windTree], 1);
    renderer.clippingPlanes = [new Plane(new Vector3(0, -1, 0), 9)];
    const clipped = draw(scene, [windTree], 1);
    renderer.clippingPlanes = [];
    const upper = (p: Uint8Array) => p.slice(320 * 150 * 4);
    const result = {
      clipped: changed(upper(plain), upper(clipped)),
      colours: new Set(new Uint32Array(plain.buffer)).size,
    };
    windTree.dispose();
    return result;
  },

  /** Part of the picture, and how much of 255, by which leaves differ that are lit at their corners from those lit pixel by pixel, whole and near. */
  corners() {
    const windTree = newTree();
    const scene = litScene(windTree);
    const dark = new PointLight('#ffffff', 0);
    const views = {
      whole,
      near: () => look(new Vector3(1.5, 9, 3.5), new Vector3(0, 9, 0)),
    };
    const result: Record<string, { changed: number; mean: number; reach: number }> = {};
    for (const [name, go] of Object.entries(views)) {
      go();
      const plain = draw(scene, [windTree], 1);
      // A lamp that gives no light asks for pixels all the same.
      scene.add(dark);
      const byPixel = draw(scene, [windTree], 1);
      windTree.showLeaves = false;
      const bare = draw(scene, [windTree], 1);
      windTree.showLeaves = true;
      scene.remove(dark);
      const sum = plain.reduce((all, value, i) => all + Math.abs(value - byPixel[i]!), 0);
      result[name] = { changed: changed(plain, byPixel), mean: sum / plain.length, reach: changed(byPixel, bare) };
    }
    windTree.dispose();
    return result;
  },

  /** Only the ground and the tree's shadow are in the picture. */
  shadows() {
    const trees = { wind: newTree(), still: newTree('still') };
    const result: Record<string, number> = {};
    look(new Vector3(-9, 14, 0), new Vector3(-9, 0, -4));
    for (const [name, windTree] of Object.entries(trees)) {
      const scene = litScene(windTree);
      const first = draw(scene, [windTree], 1);
      const second = draw(scene, [windTree], 1.5);
      windTree.setShadows(false, true);
      const bare = draw(scene, [windTree], 1.5);
      result[name] = changed(first, second);
      result[`${name} against no shadow`] = changed(second, bare);
      windTree.dispose();
    }
    return result;
  },

  /** Trees at one place, one of them turned, and one farther down the wind. */
  placement() {
    const trees = [newTree('gale'), newTree('gale'), newTree('gale')];
    trees[1].rotation.y = Math.PI / 2;
    trees[2].position.set(9, 0, 0);
    const scene = litScene(...trees);
    whole();
    draw(scene, trees, 2);
    const sway = trees.map(meanSway);
    for (const windTree of trees) windTree.dispose();
    return sway;
  },

  /** Textures, geometries and programs before a tree came, while it was there, and after it went. */
  memory() {
    const scene = litScene();
    whole();
    renderer.render(scene, camera);
    const count = () => [
      renderer.info.memory.geometries,
      renderer.info.memory.textures,
      renderer.info.programs?.length,
    ];
    const windTree = newTree();
    const before = count();
    scene.add(windTree);
    for (const mode of ['shaded', 'control', 'levels', 'wireframe'] as Mode[]) {
      windTree.mode = mode;
      draw(scene, [windTree], 1);
    }
    look(new Vector3(1, 2, 3), new Vector3(0, 4, 0)); // other geometry near by
    draw(scene, [windTree], 1);
    windTree.setTree(tree.packed, tree.species);
    draw(scene, [windTree], 1);
    const during = count();
    scene.remove(windTree);
    windTree.dispose();
    renderer.render(scene, camera);
    return { before, during, after: count() };
  },

  /** What rays meet: the trunk from the side, the air beside it, the crown. */
  rays() {
    const windTree = newTree();
    windTree.position.set(3, 0, 1);
    windTree.updateMatrixWorld(true);
    const hit = (origin: Vector3, way: Vector3) => {
      const found = new Raycaster(origin, way.normalize()).intersectObject(windTree, true);
      return found.map(({ distance, object }) => [Number(distance.toFixed(2)), object === windTree]);
    };
    const result = {
      trunk: hit(new Vector3(3, 1, 11), new Vector3(0, 0, -1)),
      beside: hit(new Vector3(5, 1, 11), new Vector3(0, 0, -1)),
      crown: hit(new Vector3(3, 40, 1), new Vector3(0.02, -1, 0.01)).length,
    };
    windTree.dispose();
    return result;
  },

  /** Draw calls with the tree in the picture and behind the camera. */
  culling() {
    const windTree = newTree();
    const scene = new Scene();
    scene.add(windTree);
    whole();
    draw(scene, [windTree], 1);
    const seen = renderer.info.render.calls;
    look(new Vector3(0, 6, 40), new Vector3(0, 6, 80));
    draw(scene, [windTree], 1);
    const behind = renderer.info.render.calls;
    windTree.dispose();
    return { seen, behind };
  },

  /** Triangles from near and far, by levels and with a budget of leaves. */
  detail() {
    const windTree = newTree();
    const scene = new Scene();
    scene.add(windTree);
    const stats = (distance: number) => {
      look(new Vector3(0, 8, distance), new Vector3(0, 8, 0));
      draw(scene, [windTree], 1);
      return windTree.stats();
    };
    const far = stats(120);
    const near = stats(5);
    windTree.levelsShown = 1;
    const trunk = stats(14);
    windTree.levelsShown = 4;
    windTree.leafBudget = 100;
    const few = stats(14);
    windTree.showLeaves = false;
    const bare = stats(14);
    windTree.dispose();
    return { far, near, trunk, few, bare, pieces: tree.packed.pieceCount, leaves: tree.packed.leafCount };
  },

  /** Each mode's picture differs from the shaded one, and shading again gives the first picture back. */
  modes() {
    const windTree = newTree();
    const scene = litScene(windTree);
    whole();
    const shaded = draw(scene, [windTree], 1);
    const result = (['wireframe', 'control', 'levels', 'shaded'] as Mode[]).map((mode) => {
      windTree.mode = mode;
      return changed(shaded, draw(scene, [windTree], 1));
    });
    windTree.dispose();
    return result;
  },

  /** Two winds on one tree, against two trees with one wind each: parts of the picture that differ, shadows and all. */
  compare() {
    const windTree = newTree();
    windTree.compareWith(winds.gale);
    const scene = litScene(windTree);
    whole();
    const a = draw(scene, [windTree], 1);
    windTree.show('B');
    renderer.render(scene, camera);
    const b = pixels();
    const textures = renderer.info.memory.textures;
    windTree.compareWith(null);
    const again = draw(scene, [windTree], 1);
    const result = {
      apart: changed(a, b),
      again: changed(a, again),
      dropped: textures - renderer.info.memory.textures,
    };
    windTree.dispose();
    const alone = (['fresh-breeze', 'gale'] as const).map((wind) => {
      const one = newTree(wind);
      const picture = draw(litScene(one), [one], 1);
      one.dispose();
      return picture;
    });
    return { ...result, a: changed(a, alone[0] as Uint8Array), b: changed(b, alone[1] as Uint8Array) };
  },
};

Object.assign(window, { home });
declare global {
  interface Window {
    home: typeof home;
  }
}
