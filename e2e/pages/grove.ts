import {
  Color,
  DirectionalLight,
  HemisphereLight,
  Mesh,
  MeshLambertMaterial,
  type Object3D,
  PerspectiveCamera,
  PlaneGeometry,
  Scene,
  Vector3,
  WebGLRenderer,
} from 'three';
import { groveLight } from '../../src/core/look/grove-light.ts';
import { mergeTrees } from '../../src/core/pack/merge-trees.ts';
import { Grove } from '../../src/view/forest/grove.ts';
import { WindTree } from '../../src/view/wind-tree.ts';
import { grown, small } from './grown.ts';
import { shippedWind } from './shipped-wind.ts';

// Three small aspens on a meadow, as trees and as a grove; tells how their pictures differ.
const [WIDTH, HEIGHT] = [240, 150];
const renderer = new WebGLRenderer();
renderer.setSize(WIDTH, HEIGHT);
renderer.shadowMap.enabled = true;
const scene = new Scene();
scene.background = new Color('#9fb8cc');
const sun = new DirectionalLight('#fff4e0', 3);
sun.position.set(12, 20, 10);
sun.castShadow = true;
Object.assign(sun.shadow.camera, { left: -14, right: 14, top: 14, bottom: -14, far: 60 });
const ground = new Mesh(new PlaneGeometry(80, 80), new MeshLambertMaterial({ color: '#6d7a48' }));
ground.rotation.x = -Math.PI / 2;
ground.receiveShadow = true;
scene.add(sun, new HemisphereLight('#bcd4ee', '#6b6a4a', 1.4), ground);
const camera = new PerspectiveCamera(40, WIDTH / HEIGHT, 0.1, 200);
camera.position.set(0, 5.5, 17);
camera.lookAt(0, 5, 0);
camera.updateMatrixWorld();

const { species, packed } = await grown('quaking-aspen', 1, small);
const other = (await grown('quaking-aspen', 2, small)).packed;
const wind = await shippedWind('gale');
const standings = [
  { tree: packed, x: -6, y: 1, z: 0, turn: 0.4 },
  { tree: other, x: 0.5, y: -2, z: 0, turn: 2.1 },
  { tree: packed, x: 6, y: 2, z: 0, turn: -1.3 },
];
const merged = () => mergeTrees(standings);
const light = groveLight(packed, species);
const scale = 0.5 * HEIGHT * (camera.projectionMatrix.elements[5] as number);

function picture(things: readonly Object3D[], time: number): Uint8Array {
  for (const thing of things) scene.add(thing);
  for (const thing of things) {
    if (thing instanceof WindTree) thing.update(renderer, time);
    if (thing instanceof Grove)
      thing.update(renderer, time, { eye: new Vector3().copy(camera.position), scale, frame: 0 });
  }
  renderer.render(scene, camera);
  const gl = renderer.getContext();
  const pixels = new Uint8Array(4 * WIDTH * HEIGHT);
  gl.readPixels(0, 0, WIDTH, HEIGHT, gl.RGBA, gl.UNSIGNED_BYTE, pixels);
  for (const thing of things) scene.remove(thing);
  return pixels;
}

/** Part of the pixels that differ by more than `by` of 255 in any colour. */
function apart(a: Uint8Array, b: Uint8Array, by: number): number {
  let count = 0;
  for (let i = 0; i < a.length; i += 4) {
    if ([0, 1, 2].some((k) => Math.abs((a[i + k] as number) - (b[i + k] as number)) > by)) count++;
  }
  return count / (a.length / 4);
}

/** The meadow with the shadow of a grove that has been drawn before, without the grove. */
function shadowOf(grove: Grove): Uint8Array {
  const show = (visible: boolean) =>
    grove.traverse((each) => {
      if (each instanceof Mesh) Object.assign(each.material, { colorWrite: visible, depthWrite: visible });
    });
  show(false);
  const pixels = picture([grove], 3);
  show(true);
  return pixels;
}

const newGrove = (): Grove => {
  const grove = new Grove();
  grove.setWind(wind);
  grove.setGrove(merged(), species, light);
  return grove;
};

function look() {
  const once = newGrove();
  picture([once], 2);
  once.dispose();
  const bare = picture([], 0);
  const memory = { ...renderer.info.memory };
  const trees = standings.map(({ tree, x, y, turn }) => {
    const alone = new WindTree();
    alone.startsNear = true;
    alone.setTree(tree, species);
    alone.setWind(wind);
    alone.position.set(x, 0, -y);
    alone.rotation.y = turn;
    return alone;
  });
  const alone = picture(trees, 3);
  const [near, middle] = [newGrove(), newGrove()];
  const together = picture([near], 3);
  const shadow = shadowOf(near);
  // All trees stand between 80 and 250 pixels high: each class has a part of every tree, and they share it out between them.
  near.fade.set(50, 300, 1e9, 2e9);
  const half = picture([near], 3);
  const halfShadow = shadowOf(near);
  middle.fade.set(-1, 0, 50, 300);
  const shared = picture([near, middle], 3);
  for (let i = 0; i < 3; i++) near.share(i, 0, 0);
  const none = picture([near], 3);
  const calls = { alone: trees.reduce((n, tree) => n + tree.stats().drawCalls, 0), together: near.stats().drawCalls };
  for (const each of [...trees, near, middle]) each.dispose();
  picture([], 0);
  return {
    trees: apart(bare, alone, 8),
    'grove against trees': apart(alone, together, 40),
    'half of it against all': apart(together, half, 8),
    shadow: apart(bare, shadow, 8),
    'half its shadow against all': apart(shadow, halfShadow, 8),
    'both halves against all': apart(together, shared, 8),
    'none of it against the meadow': apart(bare, none, 0),
    calls,
    leaks: [renderer.info.memory.geometries - memory.geometries, renderer.info.memory.textures - memory.textures],
  };
}

declare global {
  interface Window {
    grove: ReturnType<typeof look>;
  }
}
document.body.append(renderer.domElement);
window.grove = look();
