import { Color, DirectionalLight, HemisphereLight, PerspectiveCamera, Scene, WebGLRenderer } from 'three';
import { growTree, inSeason, shipped, WindTree } from 'windgrove';

const renderer = new WebGLRenderer({ canvas: document.querySelector('canvas'), antialias: true });
const camera = new PerspectiveCamera(30, 320 / 240, 0.1, 500);
camera.position.set(0, 1.6, 12);
camera.lookAt(0, 2.4, 0);

const scene = new Scene();
scene.background = new Color('#cfe0ee');
const sun = new DirectionalLight('#fff4e0', 3);
sun.position.set(8, 20, 12);
scene.add(sun, new HemisphereLight('#bcd4f0', '#6a6250', 1.5));

const species = await shipped.speciesOf('young-oak');
const { packed } = await growTree(species, 7); // in a worker
const tree = new WindTree();
tree.setTree(packed, inSeason(species, 'autumn'));
tree.setWind(await shipped.windOf('fresh-breeze'));
scene.add(tree);

renderer.setAnimationLoop((milliseconds) => {
  tree.update(renderer, milliseconds / 1000); // the same time gives the same pose
  renderer.render(scene, camera);
});
