// Our GLB in a bare three.js page: GLTFLoader, a sun, a sky, the clip playing. Nothing of Windgrove is imported here.
// `glb.html?file=tree.glb`: where the file lies; `&near` looks at the foot of the tree; `&still` shows the picture of `seek` alone.
import {
  ACESFilmicToneMapping,
  AnimationMixer,
  Box3,
  CircleGeometry,
  Color,
  DirectionalLight,
  HemisphereLight,
  Mesh,
  MeshStandardMaterial,
  PCFShadowMap,
  PerspectiveCamera,
  Scene,
  Timer,
  Vector3,
  WebGLRenderer,
} from 'three';
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';
import { GLTFLoader } from 'three/addons/loaders/GLTFLoader.js';

const asked = new URLSearchParams(location.search);
const canvas = document.querySelector('canvas')!;
const renderer = new WebGLRenderer({ canvas, antialias: true, preserveDrawingBuffer: true });
renderer.setSize(innerWidth, innerHeight, false);
renderer.toneMapping = ACESFilmicToneMapping;
renderer.shadowMap.enabled = true;
renderer.shadowMap.type = PCFShadowMap;

const scene = new Scene();
scene.background = new Color('#dfe7ea');
scene.add(new HemisphereLight('#d9ecff', '#a3a98a', 2.4));
const sun = new DirectionalLight('#fff1d8', 3.4);
sun.castShadow = true;
sun.shadow.mapSize.set(2048, 2048);
sun.shadow.normalBias = 0.04;
scene.add(sun, sun.target);

const { scene: tree, animations } = await new GLTFLoader().loadAsync(asked.get('file') ?? 'tree.glb');
tree.traverse((part) => {
  part.castShadow = true;
  part.receiveShadow = true;
  part.frustumCulled = false; // the wind moves bones out of the box of the rest pose
});
scene.add(tree);

const box = new Box3().setFromObject(tree);
const size = box.getSize(new Vector3());
const centre = box.getCenter(new Vector3());
sun.position.copy(centre).add(new Vector3(-0.55, 0.75, 0.6).multiplyScalar(2 * size.y));
sun.target.position.copy(centre);
const reach = 0.75 * Math.max(size.x, size.y, size.z);
Object.assign(sun.shadow.camera, { left: -reach, right: reach, top: reach, bottom: -reach, near: 1, far: 5 * size.y });

const ground = new Mesh(
  new CircleGeometry(6 * size.y, 64),
  new MeshStandardMaterial({ color: '#a9b48a', roughness: 1 }),
);
ground.rotation.x = -Math.PI / 2;
ground.receiveShadow = true;
scene.add(ground);

const camera = new PerspectiveCamera(30, innerWidth / innerHeight, 0.05, 500);
const controls = new OrbitControls(camera, canvas);
if (asked.has('near')) {
  controls.target.set(0, 1.6, 0);
  camera.position.set(1.8, 1.7, 3.4);
} else {
  const fit = Math.max(size.y, size.x / camera.aspect, size.z / camera.aspect);
  controls.target.set(0, centre.y, 0);
  camera.position
    .set(0.35, 0, 1)
    .setLength((0.54 * fit) / Math.tan((15 * Math.PI) / 180))
    .setY(1.6);
}
controls.update();

const mixer = new AnimationMixer(tree);
const [clip] = animations;
if (clip) mixer.clipAction(clip).play();
const line = document.querySelector('p')!;
let triangles = 0;
tree.traverse((part) => {
  if (part instanceof Mesh) triangles += (part.geometry.index?.count ?? 0) / 3;
});

/** Draws the clip at a time in seconds. */
function seek(time: number): void {
  mixer.setTime(time);
  renderer.render(scene, camera);
  const moving = clip ? ` · ${clip.name}, ${time.toFixed(2)} of ${clip.duration.toFixed(2)} s` : '';
  line.textContent = `${triangles.toLocaleString('en')} triangles${moving}`;
}

const timer = new Timer();
function play(): void {
  timer.update();
  controls.update();
  seek(clip ? timer.getElapsed() % clip.duration : 0);
  requestAnimationFrame(play);
}

seek(0);
if (!asked.has('still')) requestAnimationFrame(play);
Object.assign(window, { windgroveGlb: { seek, scene, tree, animations, clip } });
document.documentElement.dataset.ready = 'true';
