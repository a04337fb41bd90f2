import type { GrownPacked } from '../pack/grow-packed.ts';
import type { ExportOptions } from './export-options.ts';
import type { PivotElements } from './pivot-painter.ts';

/** Bare names of the files that go with a text. */
export interface ChannelFiles {
  readonly mesh: string;
  readonly stems?: string;
  readonly pivots?: string;
  readonly axes?: string;
}

const attributes = ({ stems = '' }: ChannelFiles): string[] => [
  'Attributes of the vertices, floats:',
  '',
  '  _WT_BRANCH  index of the stem that the vertex is on; of a leaf, of the stem on which it hangs',
  '  _WT_S       part of the way along that stem, 0 base to 1 tip; a stem that split off another goes on from where it split',
  '  _WT_PHASE   turns, 0 to 1, the same for a whole stem, another for each leaf: when it swings',
  '  _WT_PIVOT   x, y, z in metres: the base of the stem; of a leaf, the foot of its stalk',
  '',
  `${stems} has a line for each stem: its parent (-1 for a trunk), where it grows there (part of the parent, 0 to 1), its level,`,
  'whether it is a clone (1: it split off its parent and goes on as it did), its base, length and radius in metres, and its phase.',
  '',
  'A shader that bends a stem turns what is above its pivot by an angle that grows with _WT_S, and adds what its parents do.',
];

const godot = (): string[] => [
  'Colours of the vertices (COLOR_0), linear, 0 to 1:',
  '',
  '  red    how much the place sways: 0 at the foot of the trunk, 1 at the tip that sways most. A stem adds to its parent by the square',
  '         of the way from its base, in proportion to its length and to how soft its level is.',
  '  green  the way along the stem, 0 base to 1 tip; on a leaf the way along its blade',
  '  blue   phase in turns, the same for a whole stem, another for each leaf',
  '  alpha  1',
  '',
  'Godot\'s page "Making trees" multiplies the strength of its sway by COLOR.r: that shader works as it stands there. Green and blue are',
  'for one of your own. Switch off "Vertex Color > Use as Albedo" in the material that the importer makes, or the tree is painted in them.',
];

const unreal = ({ pivots = '', axes = '' }: ChannelFiles, elements: PivotElements): string[] => [
  "Textures for the shader functions of Unreal's Pivot Painter 2; one texel for each of the elements, which are stems:",
  '',
  `  elements           ${elements.count}, in ${elements.width} x ${elements.height} texels, rows from the top; at most three parents above each, as the shader has it`,
  `  ${pivots}`,
  "    red green blue   pivot of the element in centimetres, Unreal's axes (z up, left-handed), 16-bit floats",
  '    alpha            index of its parent; a root has its own. Bits of a 16-bit float: index + 1024 ("Int as float")',
  `  ${axes}`,
  '    red green blue   direction from its base to its tip, -1 to 1 as 0 to 255',
  '    alpha            how far that is: steps of 8 cm, 1 to 256, as 0 to 255; 20.48 m at most',
  '  TEXCOORD_1         second texture coordinates of the mesh: the texel of the element of each vertex',
  '',
  'What is on a stem that is no element (levels beyond the fourth, or more than 30 000 stems) goes with the stem below it.',
  'Import the first texture as HDR (16-bit float, no compression), the second without sRGB (VectorDisplacementmap), both with nearest',
  'filter and no mipmaps. Import the mesh with its second texture coordinates and as it stands; then use PivotPainter2FoliageShader with',
  'texture coordinate 1.',
];

/** What the channels of a file mean, in words for whoever finds the file. */
export function channelsText(
  { tree, packed }: GrownPacked,
  engine: ExportOptions['engine'],
  files: ChannelFiles,
  elements: PivotElements | null,
): string {
  const box = Array.from(packed.bounds, (x) => x.toFixed(2));
  const own =
    engine === 'godot' ? godot() : engine === 'unreal' && elements ? unreal(files, elements) : attributes(files);
  return [
    `${tree.species.name}, seed ${tree.seed}: wind channels, by Windgrove`,
    '',
    `${files.mesh} is the tree at rest: metres, y up, ${(packed.bounds[5]! - packed.bounds[2]!).toFixed(2)} m high.`,
    `Its box, z up: ${box.slice(0, 3).join(' ')} to ${box.slice(3).join(' ')}.`,
    '',
    ...own,
    '',
  ].join('\n');
}
