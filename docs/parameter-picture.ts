// The page that docs/make-parameter-pictures.ts takes its pictures from: one parameter low and high, seen from the same place.
import type { CameraPose } from '../src/core/link/document.ts';
import { editSpecies, type ParameterValue, type SpeciesEdits } from '../src/core/species/edits.ts';
import { parseSpecies } from '../src/core/species/parse.ts';
import { inSeason } from '../src/core/species/season.ts';
import { STILL } from '../src/core/wind/wind.ts';
import { type GrownTree, growTree } from '../src/view/picture/grow-tree.ts';
import { openPicture } from '../src/view/picture/open-picture.ts';
import { PARAMETER_PICTURES, type ParameterPicture, placeOf } from './parameter-pictures.ts';
import { type Point, sprayOf } from './spray-place.ts';
import { textOf } from './tree-page.ts';

/** Pixels: twice what the help shows; drawn twice as large again, which smooths twigs. */
const SIZE = { width: 280, height: 280 };
/** A hazy sky behind all of them, in both themes: white bark and dark bark both stand out from it. */
const PAPER = '#c3d0d3';
/** Tangent of half the camera's vertical field of view, and room about what is shown. */
const HALF = Math.tan((15 * Math.PI) / 180);
const AIR = 1.05;

const { picture } = await openPicture(document.querySelector<HTMLElement>('#host')!, {
  onChange: () => undefined,
  onCamera: () => undefined,
  onLost: () => undefined,
});
picture.setWind(STILL, 0);
picture.setDark(false);

/** Stems without leaves are thin and pale from afar: what every bare tree gets on top. */
const BARE: SpeciesEdits = { 'tree.ratio': 0.028, 'bark.colour': '#5d4a3a', 'bark.dark': '#2c221b' };

/** Direction of the camera about the trunk. */
const TOWARDS = [0.5, -0.87] as const;

/** Tree space, z up, as the camera has it, y up. */
const upright = ([x, y, z]: Point): Point => [x, z, -y];

/** A camera that sees `height` metres around a point of tree space. */
const at = (point: Point, height: number, elevation = 4, azimuth = 30): CameraPose => ({
  azimuth,
  elevation,
  distance: (height / 2 / HALF) * AIR,
  target: upright(point),
});

/** Box around both trees. */
function boxOf(trees: readonly GrownTree[]): Float32Array {
  const box = trees[0]!.packed.bounds.slice();
  for (const { packed } of trees.slice(1)) {
    for (let i = 0; i < 6; i++) box[i] = (i < 3 ? Math.min : Math.max)(box[i]!, packed.bounds[i]!);
  }
  return box;
}

/** Where a pair is seen from: the same place for both. */
function cameraOf({ view }: ParameterPicture, trees: readonly GrownTree[]): CameraPose {
  const [x0, y0, , x1, y1, top] = boxOf(trees) as unknown as [number, number, number, number, number, number];
  const wide = Math.max(x1 - x0, y1 - y0);
  const middle: Point = [(x0 + x1) / 2, (y0 + y1) / 2, top / 2];
  switch (view) {
    case 'whole':
      return at(middle, Math.max(top, wide * (SIZE.height / SIZE.width)));
    case 'above':
      return at(middle, wide, 89.9, 0);
    case 'foot':
      return at([0, 0, 0.055 * top], 0.13 * top, 14);
    case 'trunk':
      return at([0, 0, 0.3 * top], 0.62 * top);
    case 'bark':
      return at([0, 0, 1.3], 0.5, 2);
    case 'limb':
      return at([0.1 * wide, 0, 0.5 * top], 0.3 * top);
    case 'spray':
      return at(sprayOf(trees[0]!, TOWARDS), 1.1);
    case 'leaf':
      return at(sprayOf(trees[0]!, TOWARDS), 0.42);
  }
}

async function taken(entry: ParameterPicture): Promise<readonly string[]> {
  const base = parseSpecies(await textOf(`species/${entry.species}.json`)).species!;
  const bare = !entry.leaves && (entry.view === 'whole' || entry.view === 'above') ? BARE : {};
  const made = (value: ParameterValue) => editSpecies(base, { ...bare, ...entry.edits, [placeOf(entry)]: value });
  const season = entry.path.startsWith('autumn.') ? 'autumn' : 'summer';
  const kinds = [made(entry.low), made(entry.high)].map((species) => inSeason(species, season));
  const trees: GrownTree[] = [];
  for (const species of kinds) trees.push(await growTree(species, entry.seed));
  const camera = cameraOf(entry, trees);
  const pictures: string[] = [];
  for (const [i, tree] of trees.entries()) {
    picture.setTree(tree, kinds[i]!);
    picture.show({ levelsShown: entry.levelsShown ?? 9, showLeaves: entry.leaves, view: 'shaded' });
    const capture = await picture.openCapture({
      width: 2 * SIZE.width,
      height: 2 * SIZE.height,
      transparent: true,
      camera,
    });
    await capture.draw(0);
    const canvas = document.createElement('canvas');
    Object.assign(canvas, SIZE);
    const context = canvas.getContext('2d', { alpha: false })!;
    context.fillStyle = PAPER;
    context.fillRect(0, 0, SIZE.width, SIZE.height);
    context.imageSmoothingQuality = 'high';
    context.drawImage(capture.canvas, 0, 0, SIZE.width, SIZE.height);
    capture.close();
    pictures.push(canvas.toDataURL('image/webp', 0.72));
  }
  return pictures;
}

Object.assign(window, { windgrovePictures: (path: string) => taken(PARAMETER_PICTURES.find((p) => p.path === path)!) });
