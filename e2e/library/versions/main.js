import { REVISION } from 'three';
import { growTree, Stage, shipped, uprightBox, WindTree } from 'windgrove';

// No bundler: a stage with everything on it, drawn twice by the three that the import map names; the title says what was seen.
const canvas = document.querySelector('canvas');
const { width, height } = canvas;
const stage = new Stage(canvas, { environment: true, preserveDrawingBuffer: true, antialias: false, shadows: 256 });
const species = await shipped.speciesOf('young-oak');
const { packed } = await growTree(species, 7, { quality: 0.3 });
const tree = new WindTree();
tree.setTree(packed, species);
tree.setWind(await shipped.windOf('fresh-breeze'));
stage.scene.add(tree);
stage.resize(width, height);
stage.frame(uprightBox(packed.bounds));

function picture(time) {
  tree.update(stage.renderer, time);
  stage.blow(tree.windSource(), time);
  stage.render();
  const gl = stage.renderer.getContext();
  const bytes = new Uint8Array(4 * width * height);
  gl.readPixels(0, 0, width, height, gl.RGBA, gl.UNSIGNED_BYTE, bytes);
  return new Uint32Array(bytes.buffer);
}

const first = picture(1);
const second = picture(1.5);
const changed = second.filter((pixel, i) => pixel !== first[i]).length;
document.title = `three ${REVISION}: ${new Set(first).size} colours, ${changed} pixels moved`;
