// The page that docs/make-sheet.ts and docs/make-portraits.ts take their pictures from: a species, a seed, a season, a view.

import { faultText } from '../src/core/file/fault.ts';
import type { CameraPose, StageId } from '../src/core/link/document.ts';
import { parseSpecies } from '../src/core/species/parse.ts';
import { inSeason, type Season } from '../src/core/species/season.ts';
import { STILL } from '../src/core/wind/wind.ts';
import { CaptureStage, type Viewpoint } from '../src/view/picture/capture-stage.ts';
import { type GrownTree, growTree } from '../src/view/picture/grow-tree.ts';
import { WindTree } from '../src/view/wind-tree.ts';
import { type Point, sprayOf } from './spray-place.ts';

/** `whole`: as the editor frames it; `close`: as close as the tree allows; `far`: 60 pixels high; the others show parts of it. */
export type SpeciesView = 'whole' | 'close' | 'far' | 'crown' | 'spray' | 'bark' | 'foot';

export interface SpeciesJob {
  /** The text of the species' file. */
  readonly text: string;
  readonly seed: number;
  readonly season: Season;
  readonly stage: StageId;
  readonly hour: number | null;
  readonly view: SpeciesView;
  readonly leaves: boolean;
  /** Pixels; drawn larger by `fine`, which smooths twigs. */
  readonly width: number;
  readonly height: number;
  readonly fine: number;
  /** Without loss, for comparing. */
  readonly png?: boolean;
}

/** Tangent of half the camera's vertical field of view. */
const HALF = Math.tan((15 * Math.PI) / 180);

/** A camera that sees `height` metres around a point of tree space (z up). */
const at = ([x, y, z]: Point, height: number, elevation: number, azimuth = 11): CameraPose => ({
  azimuth,
  elevation,
  distance: height / 2 / HALF,
  target: [x, z, -y],
});

function viewOf(view: SpeciesView, tree: GrownTree, pixels: number): Viewpoint {
  const [x0, y0, , x1, y1, top] = tree.packed.bounds as unknown as [number, number, number, number, number, number];
  const wide = Math.max(x1 - x0, y1 - y0);
  const middle: Point = [(x0 + x1) / 2, (y0 + y1) / 2, top / 2];
  const placed = (pose: CameraPose): Viewpoint => ({ pose, high: 1, wide: 0 });
  switch (view) {
    case 'whole':
    case 'close':
      return view;
    case 'far':
      return placed(at(middle, (Math.max(top, wide) * pixels) / 60, 2));
    case 'crown':
      return placed(at([middle[0], middle[1], 0.62 * top], 0.4 * Math.max(top, 0.6 * wide), 2));
    case 'spray':
      return placed(at(sprayOf(tree, [0.2, -1]), Math.min(1.2, 0.5 * top), 2));
    case 'bark':
      return placed(at([0, 0, Math.min(1.3, 0.3 * top)], Math.min(0.9, 0.4 * top), 2));
    case 'foot':
      return placed(at([0, 0, 0.06 * top], 0.16 * top, 8));
  }
}

let stage: CaptureStage | null = null;
const trees = new Map<string, GrownTree>();

/** Qualities that are tried until a picture is small enough, and pixels of blur: a willow of a million strands is softer, not full of blocks. */
const TRIES = [
  [0.86, 0],
  [0.76, 0],
  [0.64, 0],
  [0.52, 0],
  [0.52, 0.45],
  [0.46, 0.6],
  [0.4, 0.75],
  [0.34, 0.9],
] as const;

/** The picture as a data: address of a WebP of at most `most` bytes, as far as that can be. */
async function picture(job: SpeciesJob, most = Number.POSITIVE_INFINITY): Promise<string> {
  const { species, faults } = parseSpecies(job.text);
  if (!species) throw new Error(faults.map(faultText).join('\n'));
  const key = `${job.seed} ${job.text}`;
  const tree = trees.get(key) ?? (await growTree(species, job.seed));
  if (trees.size > 3) trees.clear();
  trees.set(key, tree);
  stage ??= new CaptureStage('stage', new WindTree());
  const show = { levelsShown: 9, showLeaves: job.leaves, view: 'shaded' } as const;
  stage.take({
    packed: tree.packed,
    stems: tree.stems,
    species: inSeason(species, job.season),
    wind: STILL,
    show,
    dark: false,
    channel: null,
    scene: { stage: job.stage, hour: job.hour },
  });
  const canvas = document.createElement('canvas');
  canvas.width = job.width * job.fine;
  canvas.height = job.height * job.fine;
  await stage.draw(canvas, 0, viewOf(job.view, tree, job.height));
  const small = document.createElement('canvas');
  small.width = job.width;
  small.height = job.height;
  const context = small.getContext('2d', { alpha: false })!;
  context.imageSmoothingQuality = 'high';
  context.drawImage(canvas, 0, 0, job.width, job.height);
  if (job.png) return small.toDataURL('image/png');
  let data = '';
  for (const [quality, blur] of TRIES) {
    if (blur > 0) {
      context.filter = `blur(${blur}px)`;
      context.drawImage(canvas, 0, 0, job.width, job.height);
    }
    data = small.toDataURL('image/webp', quality);
    if (0.75 * (data.length - data.indexOf(',')) <= most) break;
  }
  return data;
}

Object.assign(window, { windgroveSpecies: picture });
