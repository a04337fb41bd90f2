// Milliseconds of a frame of bent pieces beside one static mesh of the same triangles in the same material.
import { DirectionalLight, HemisphereLight, type Mesh, PerspectiveCamera, Scene, WebGLRenderer } from 'three';
import { interleave, type Subject } from '../src/gpu/interleave.ts';
import { rendererName } from '../src/gpu/renderer-name.ts';
import { deformedMesh } from '../src/view/deformed-mesh.ts';
import { branchGrid } from '../src/view/grid.ts';
import { strewnPieces } from '../src/view/strewn-pieces.ts';
import { CASES, staticMesh } from './deform-subjects.ts';
import type { BenchReport, Table } from './report.ts';

const query = new URLSearchParams(location.search);
const ROUNDS = Number(query.get('rounds') ?? 7);
const show = (id: string, text: string) => {
  document.getElementById(id)!.textContent = text;
};

const canvas = document.getElementById('picture') as HTMLCanvasElement;
const renderer = new WebGLRenderer({ canvas, antialias: false, preserveDrawingBuffer: true });
renderer.setSize(canvas.width, canvas.height, false);
renderer.setClearColor(0xdfe6ea);
const gl = renderer.getContext();
const camera = new PerspectiveCamera(30, canvas.width / canvas.height, 0.1, 100);
camera.position.set(4, 5, 19);
camera.lookAt(0, 0, 0);
const pixel = new Uint8Array(4);

function sceneOf(mesh: Mesh): Scene {
  const scene = new Scene();
  const sun = new DirectionalLight('#fff0d6', 3);
  sun.position.set(3, 4, 2);
  scene.add(mesh, sun, new HemisphereLight('#cfe4ff', '#8a8f5c', 1));
  return scene;
}

const subject = (name: string, scene: Scene): Subject => ({
  name,
  run: () => renderer.render(scene, camera),
  wait: () => gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, pixel),
});

/** Pixels that differ by more than a few steps: both ways must draw the same picture for their times to mean anything. */
function difference(a: Scene, b: Scene): number {
  const read = (scene: Scene) => {
    renderer.render(scene, camera);
    const data = new Uint8Array(canvas.width * canvas.height * 4);
    gl.readPixels(0, 0, canvas.width, canvas.height, gl.RGBA, gl.UNSIGNED_BYTE, data);
    return data;
  };
  const [p, q] = [read(a), read(b)];
  let differ = 0;
  // The shape alone: the background's blue is told from the bark's, whose texture coordinates differ here.
  for (let i = 0; i < p.length; i += 4) {
    const [inA, inB] = [p, q].map((d) => d[i + 2] === 234 && d[i] === 223);
    if (inA !== inB) differ++;
  }
  return differ / (p.length / 4);
}

async function run(): Promise<void> {
  const rows: (string | number)[][] = [];
  const shares: string[] = [];
  for (const { pieces, spec } of CASES) {
    show('state', `Measuring ${pieces} pieces …`);
    await new Promise((resolve) => setTimeout(resolve, 20));
    const tree = strewnPieces(pieces);
    const [fixed, bent] = [staticMesh(tree, spec), deformedMesh(tree, spec)];
    const scenes = [sceneOf(fixed), sceneOf(bent)] as const;
    const differ = difference(...scenes);
    shares.push(`${(100 * differ).toFixed(2)} %`);
    const grid = branchGrid({ ...spec, bundle: 1 });
    const drawn = interleave([subject('static', scenes[0]), subject('bent', scenes[1])], ROUNDS);
    // All of it behind the far plane: what is left is the work on vertices and triangles.
    camera.far = 1;
    camera.updateProjectionMatrix();
    for (const mesh of [fixed, bent]) mesh.frustumCulled = false;
    const clipped = interleave([subject('static', scenes[0]), subject('bent', scenes[1])], ROUNDS);
    camera.far = 100;
    camera.updateProjectionMatrix();
    rows.push([
      pieces,
      pieces * grid.verticesPerCopy,
      pieces * grid.trianglesPerCopy,
      drawn[0].median,
      drawn[1].median,
      drawn[1].ratio,
      clipped[0].median,
      clipped[1].median,
      clipped[1].ratio,
    ]);
    for (const mesh of [fixed, bent]) {
      mesh.geometry.dispose();
      (mesh.material as { dispose(): void }).dispose();
    }
  }
  const table: Table = {
    caption: 'Milliseconds a frame, 1024 x 576, standard material with bark, no shadows',
    columns: [
      'pieces',
      'vertices',
      'triangles',
      'static',
      'bent',
      'ratio',
      'static, clipped',
      'bent, clipped',
      'ratio, clipped',
    ],
    rows,
  };
  const report: BenchReport = {
    title: 'Deformer beside a static mesh',
    tables: [table],
    notes: [
      `Both draw the same triangles with the same fragment shader; their silhouettes differ in ${shares.join(' and ')} of the pixels. The aim is a ratio of 1.4 on software GL.`,
    ],
    renderer: rendererName(renderer),
  };
  show('state', 'Done.');
  show('report', JSON.stringify(report, null, 1));
}

run().catch((error: unknown) => {
  show('state', 'Failed.');
  show('report', JSON.stringify({ error: String(error) }));
});
