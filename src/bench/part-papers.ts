import { PerspectiveCamera, Scene, WebGLRenderer } from 'three';
import { syntheticTree } from '../gpu/crosscheck/synthetic-tree.ts';
import { interleave, type Subject } from '../gpu/interleave.ts';
import { STEP } from '../gpu/step.ts';
import { TreeTextures } from '../gpu/tree-textures.ts';
import { WindPass } from '../gpu/wind-pass.ts';
import { windSource } from '../gpu/wind-source.ts';
import { deformedMesh } from '../view/deformed-mesh.ts';
import { loadWind } from '../view/load.ts';
import { strewnPieces } from '../view/strewn-pieces.ts';
import { timeFrames } from './frame-timer.ts';
import { type Section, SIZE } from './section.ts';
import { words } from './words.ts';

/** Side of the square of pieces, and the paper's steps a second. */
const STEPS = [
  [256, 600],
  [512, 180],
] as const;
/** Vertices, and the paper's frames a second. */
const VERTICES = [
  [165_000, 30],
  [335_000, 15],
] as const;
/** A piece's grid: a hundred vertices. */
const GRID = { sectors: 9, bands: 9, cap: false, bundle: 1 } as const;
const VERTICES_A_PIECE = 100;

/** The papers' headline figures, and the same work here. */
export const PAPERS: Section = {
  id: 'papers',
  title: words.papers.title,
  lead: words.papers.lead,
  async run({ canvas, rounds, milliseconds, step }) {
    const renderer = new WebGLRenderer({ canvas, antialias: false });
    try {
      const rows: (string | number)[][] = [];
      const wind = windSource({ ...(await loadWind('winds/fresh-breeze.json')), model: 'direct', pose: 'lagged' });
      const texel = new Float32Array(4);
      for (const [side, theirs] of STEPS) {
        const what = words.papers.steps(side);
        await step(words.measuring(what));
        const textures = new TreeTextures(syntheticTree(side * side, 7), true);
        const pass = new WindPass(textures);
        let n = 0;
        const subject: Subject = {
          name: what,
          run: () => pass.update(renderer, ++n * STEP, wind),
          wait: () => renderer.readRenderTargetPixels(textures.pose.targets![0]!, 0, 0, 1, 1, texel),
        };
        const [timing] = interleave([subject], rounds, milliseconds);
        rows.push([what, words.papers.source, theirs, 1000 / timing!.median]);
        pass.dispose();
        textures.dispose();
      }
      renderer.setSize(...SIZE, false);
      const camera = new PerspectiveCamera(45, SIZE[0] / SIZE[1], 0.1, 100);
      camera.position.set(0, 0, 16);
      for (const [vertices, theirs] of VERTICES) {
        const what = words.papers.vertices(vertices.toLocaleString('en').replaceAll(',', ' '));
        await step(words.measuring(what));
        const mesh = deformedMesh(strewnPieces(vertices / VERTICES_A_PIECE), GRID);
        const scene = new Scene().add(mesh);
        const frame = { name: what, draw: () => renderer.render(scene, camera) };
        const [timing] = timeFrames(renderer, [frame], rounds, milliseconds);
        rows.push([what, words.papers.source, theirs, 1000 / timing!.median]);
        mesh.geometry.dispose();
      }
      rows.push([words.papers.trees, words.papers.source, words.papers.many, words.papers.above]);
      return { table: { caption: words.papers.caption, columns: words.papers.columns, rows }, pictures: [] };
    } finally {
      renderer.forceContextLoss();
      renderer.dispose();
    }
  },
};
