import { encode } from 'fast-png';
import { twigColour } from '../look/bark-colour.ts';
import { barkMaps } from '../look/bark-maps.ts';
import { toSrgb } from '../look/colour.ts';
import { leafRamp } from '../look/leaf-look.ts';
import { expandLeaves } from '../mesh/expand-leaves.ts';
import type { LeafPlacements } from '../mesh/leaf-placements.ts';
import { meshTree, type TreeMesh } from '../mesh/tree-mesh.ts';
import type { Species } from '../species/species.ts';
import type { ExportFile } from './export-options.ts';
import { textFile } from './export-species.ts';
import type { WriteFormat } from './export-tree.ts';

/** Digits behind the point: a hundredth of a millimetre, and as fine for what has no unit. */
const METRES = 5;
const UNIT = 4;

/** Text that grows: joined line by line into bytes, so that no tree is too long for one string. */
class Lines {
  private readonly parts: Uint8Array[] = [];
  private readonly encoder = new TextEncoder();
  private text: string[] = [];

  add(line: string): void {
    this.text.push(line);
    if (this.text.length === 8192) this.flush();
  }

  private flush(): void {
    if (this.text.length > 0) this.parts.push(this.encoder.encode(`${this.text.join('\n')}\n`));
    this.text = [];
  }

  bytes(): Uint8Array<ArrayBuffer> {
    this.flush();
    const all = new Uint8Array(this.parts.reduce((sum, part) => sum + part.length, 0));
    let at = 0;
    for (const part of this.parts) {
      all.set(part, at);
      at += part.length;
    }
    return all;
  }
}

/** A number in few characters, and never as -0. */
const short = (value: number, digits: number): string => String(Math.round(value * 10 ** digits) / 10 ** digits + 0);

/** A vector of tree space as the file has it: y up. */
const upright = (array: ArrayLike<number>, i: number, digits: number): string =>
  `${short(array[3 * i]!, digits)} ${short(array[3 * i + 2]!, digits)} ${short(-array[3 * i + 1]!, digits)}`;

/** What a file of materials says of a tree's. */
export interface ObjMaterials {
  /** Names of the images of the bark, where there are any. */
  readonly colour?: string | undefined;
  readonly normal?: string | undefined;
}

const rgb = (colour: string): string =>
  [1, 3, 5].map((at) => short(Number.parseInt(colour.slice(at, at + 2), 16) / 255, UNIT)).join(' ');

/** The exponent of Phong's highlight that is about as wide as a roughness of 0..1 makes it. */
const shininess = (roughness: number): string => short(Math.max(1, 2 / Math.max(roughness, 0.05) ** 2 - 2), 1);

/** The materials: `bark`, `twigs` (without images), `leaves` and, where there are any, `organs`. Colours are sRGB. */
export function writeMtl({ bark, foliage, organ }: Species, { colour, normal }: ObjMaterials = {}): string {
  const plain = (name: string, kd: string, roughness: number): string[] => [
    `newmtl ${name}`,
    `Kd ${kd}`,
    'Ks 0.04 0.04 0.04',
    `Ns ${shininess(roughness)}`,
    `Pr ${short(roughness, UNIT)}`,
    'illum 2',
  ];
  const twig = twigColour(bark)
    .map((part) => short(toSrgb(part), UNIT))
    .join(' ');
  // One material for all leaves: as far turned as they are on the average.
  const turned = leafRamp(foliage, foliage.second ? foliage.secondShare : 0);
  const leaves = turned.map((part) => short(toSrgb(part), UNIT)).join(' ');
  return [
    '# Windgrove; Pr is the roughness that some programs read',
    ...plain('bark', colour ? '1 1 1' : rgb(bark.colour), bark.roughness),
    ...(colour ? [`map_Kd ${colour}`] : []),
    ...(normal ? [`norm ${normal}`, `map_Bump ${normal}`] : []),
    '',
    ...plain('twigs', twig, bark.roughness),
    '',
    ...plain('leaves', leaves, foliage.roughness),
    '',
    ...(organ.kind === 'none' ? [] : [...plain('organs', rgb(organ.colour), 0.6), '']),
  ].join('\n');
}

/**
 * A tree as a Wavefront OBJ: metres, y up, a group for each level of stems and material, and one for the leaves, each leaf as triangles.
 *
 * `head`: lines of comment. `materials`: name of the file of materials.
 */
export function writeObj(mesh: TreeMesh, materials: string, head: readonly string[] = []): Uint8Array<ArrayBuffer> {
  const out = new Lines();
  for (const line of head) out.add(`# ${line.replace(/[\r\n]/g, ' ')}`);
  out.add('# metres, y up');
  out.add(`mtllib ${materials}`);
  out.add('o tree');
  for (let i = 0; i < mesh.vertexCount; i++) out.add(`v ${upright(mesh.position, i, METRES)}`);
  for (let i = 0; i < mesh.vertexCount; i++)
    out.add(`vt ${short(mesh.uv[2 * i]!, UNIT)} ${short(mesh.uv[2 * i + 1]!, UNIT)}`);
  for (let i = 0; i < mesh.vertexCount; i++) out.add(`vn ${upright(mesh.normal, i, UNIT)}`);
  for (const { name, firstIndex, indexCount } of mesh.parts) {
    const levels = [...new Set(mesh.level)].sort((a, b) => a - b);
    for (const level of levels) {
      let named = false;
      for (let t = firstIndex; t < firstIndex + indexCount; t += 3) {
        if (mesh.level[mesh.index[t]!] !== level) continue;
        if (!named) {
          out.add(`g level-${level}${name === 'twigs' ? '-twigs' : ''}`);
          out.add(`usemtl ${name}`);
          named = true;
        }
        out.add(`f ${[0, 1, 2].map((k) => cornerOf(mesh.index[t + k]! + 1)).join(' ')}`);
      }
    }
  }
  const before: Written = { vertices: mesh.vertexCount, places: mesh.vertexCount };
  if (mesh.leaves) writeLeaves(out, 'leaves', mesh.leaves, before);
  if (mesh.organs) writeLeaves(out, 'organs', mesh.organs, before);
  return out.bytes();
}

const cornerOf = (i: number): string => `${i}/${i}/${i}`;

/** Vertices and texture places that are written already. */
interface Written {
  vertices: number;
  places: number;
}

/** Leaves or organs, which all share the texture places of the one of which they are copies. */
function writeLeaves(out: Lines, name: 'leaves' | 'organs', leaves: LeafPlacements, written: Written): void {
  const { vertexCount, position, normal, index } = expandLeaves(leaves);
  const each = leaves.leaf.position.length / 3;
  for (let i = 0; i < vertexCount; i++) out.add(`v ${upright(position, i, METRES)}`);
  for (let k = 0; k < each; k++)
    out.add(`vt ${short(leaves.leaf.uv[2 * k]!, UNIT)} ${short(leaves.leaf.uv[2 * k + 1]!, UNIT)}`);
  for (let i = 0; i < vertexCount; i++) out.add(`vn ${upright(normal, i, UNIT)}`);
  out.add(`g ${name}`);
  out.add(`usemtl ${name}`);
  const { vertices, places } = written;
  const corner = (i: number): string => `${vertices + i + 1}/${places + (i % each) + 1}/${vertices + i + 1}`;
  for (let t = 0; t < index.length; t += 3)
    out.add(`f ${corner(index[t]!)} ${corner(index[t + 1]!)} ${corner(index[t + 2]!)}`);
  written.vertices += vertexCount;
  written.places += each;
}

/** Colour and relief of the bark, as images that tile. */
function barkImages({ bark }: Species, size: number, name: string): ExportFile[] {
  const maps = barkMaps(bark, size);
  return (['colour', 'normal'] as const).map((map) => ({
    name: `${name}-bark-${map}.png`,
    bytes: new Uint8Array(encode({ width: size, height: size, data: maps[map], channels: 3, depth: 8 })),
    type: 'image/png',
  }));
}

/** OBJ, its materials, and the images that they name. */
export const exportObj: WriteFormat = async ({ species, seed, options, name, grown, report }) => {
  const tree = grown();
  report('mesh', 0);
  const mesh = meshTree(tree, {
    detail: options.detail,
    levels: options.levels,
    leaves: options.leaves !== 'none',
    mostLeaves: options.mostLeaves,
  });
  report('textures', 0.3);
  const images = options.textures === 'none' ? [] : barkImages(species, Number(options.textures), name);
  report('write', 0.5);
  const head = [`${species.name}, seed ${seed}, by Windgrove`, ...(options.link === '' ? [] : [options.link])];
  return [
    { name: `${name}.obj`, bytes: writeObj(mesh, `${name}.mtl`, head), type: 'model/obj' },
    textFile(`${name}.mtl`, writeMtl(species, { colour: images[0]?.name, normal: images[1]?.name }), 'model/mtl'),
    ...images,
  ];
};
