import type { ExportOptions } from '../../core/io/export-options.ts';
import { coverCount } from '../../core/look/leaf-count.ts';
import { leafMesh } from '../../core/look/leaf-mesh.ts';
import { leafSpecOf } from '../../core/look/leaf-shapes.ts';
import type { BarkMeshOptions } from '../../core/mesh/bark-mesh.ts';
import { GRADES, gradesFrom, type MeshGrade } from '../../core/mesh/mesh-detail.ts';
import type { MeshCount } from '../../view/picture/export-in-worker.ts';
import type { ShownTree } from '../session.ts';
import { isPicture, type Kind } from './kinds.ts';
import type { PictureOptions } from './picture-options.ts';

/** What a file will be, as far as can be said before it is made: triangles exactly, bytes within a third or so. */
export interface Estimate {
  readonly triangles?: number;
  readonly frames?: number;
  readonly bytes?: number;
  /** So much that it helps to take less. */
  readonly large: boolean;
}

/** From there on most programs wait noticeably. */
const LARGE = { triangles: 1_500_000, bytes: 150e6 } as const;

/** Bytes: measured on the files of the shipped species. */
const VERTEX = {
  plain: 28,
  textured: 44,
  short: 16,
  channels: { attributes: 24, godot: 16, unreal: 8 },
  skin: 8,
} as const;
const IMAGES: Readonly<Record<ExportOptions['textures'], number>> = {
  none: 0,
  '128': 80e3,
  '256': 190e3,
  '512': 520e3,
};
const INSTANCE = 40;
const KEY = 24;
const SWC_PIECE = 180;
/** Of a text of triangles: a vertex, a triangle, and what packing leaves of it. */
const OBJ = { vertex: 78, triangle: 36, packed: 0.3 } as const;
/** Bytes a pixel of a PNG, on the meadow and alone; bits a pixel of a video at each quality. */
const PIXEL = { picture: 1.9, transparent: 0.7, medium: 0.06, high: 0.12, 'very-high': 0.24 } as const;

/** The meshes of the stems that a file has, the finest first: those that are counted for it. */
export function meshesOf(kind: Kind, options: ExportOptions): BarkMeshOptions[] {
  if (kind !== 'glb' && kind !== 'obj' && kind !== 'channels') return [];
  const { detail, levels, lods, clip, boneLevels } = options;
  const grades = kind === 'glb' && lods !== 'none' ? gradesFrom(detail) : [detail];
  return grades.map((grade) => {
    const bent = kind === 'glb' && clip ? { leastBands: BENT[grade], bentLevels: boneLevels } : {};
    return { grade, levels, ...bent };
  });
}

/** Bands that a clip's bones need on every piece. */
const BENT: Readonly<Record<MeshGrade, number>> = { high: 4, medium: 3, low: 2, far: 2 };

/** The leaves at a grade, and how many there are. */
function leafLoad(
  { species, figures }: ShownTree,
  grade: MeshGrade,
  options: ExportOptions,
): MeshCount & { count: number } {
  const none = options.leaves === 'none' || options.levels < figures.levels || figures.leaves === 0;
  if (none) return { count: 0, triangles: 0, vertices: 0 };
  const rule = GRADES[grade];
  const leaf = leafMesh(leafSpecOf(species), rule.leaf, 1);
  const count = Math.min(options.mostLeaves, Math.ceil(rule.leaves * coverCount(figures.leaves, species.foliage)));
  return { count, triangles: count * leaf.trianglesPerCopy, vertices: count * leaf.verticesPerCopy };
}

/** What will come out, `meshes` being the counts of `meshesOf`; null where there is nothing to say beforehand, or not yet. */
export function estimateOf(
  kind: Kind,
  tree: ShownTree,
  options: ExportOptions | PictureOptions,
  meshes: readonly MeshCount[] | null,
): Estimate | null {
  if (isPicture(kind)) return pictures(kind, options as PictureOptions);
  if (kind === 'swc') return { bytes: tree.stems.stemOfPiece.length * SWC_PIECE, large: false };
  if (kind === 'species' || kind === 'project') return null;
  return meshes && models(kind, tree, options as ExportOptions, meshes);
}

function models(
  kind: 'glb' | 'obj' | 'channels',
  tree: ShownTree,
  options: ExportOptions,
  meshes: readonly MeshCount[],
): Estimate {
  const { lods, clip, leaves: how, textures, quantize } = options;
  const instanced = kind === 'glb' && how === 'instances' && !(clip && lods !== 'none');
  const textured = textures !== 'none' && kind !== 'channels';
  let bytes = kind === 'obj' ? 0 : IMAGES[kind === 'channels' ? '512' : textures];
  let triangles = 0;
  for (const [i, { grade }] of meshesOf(kind, options).entries()) {
    const bark = meshes[i]!;
    const leaves = leafLoad(tree, grade, options);
    if (i === 0) triangles = bark.triangles + leaves.triangles;
    const leafVertices = instanced ? 0 : leaves.vertices;
    const vertices = bark.vertices + leafVertices;
    const meshed = bark.triangles + (instanced ? 0 : leaves.triangles);
    if (kind === 'obj') {
      bytes += OBJ.packed * (OBJ.vertex * vertices + OBJ.triangle * meshed);
      continue;
    }
    const own = kind === 'channels' ? VERTEX.channels[options.engine] : clip ? VERTEX.skin : 0;
    const each = quantize && kind === 'glb' ? VERTEX.short + (textured ? 8 : 0) : VERTEX.plain;
    const uv = textured || kind === 'channels' ? VERTEX.textured - VERTEX.plain : 0;
    bytes += vertices * (each + own) + bark.vertices * uv + (leafVertices * uv) / 2 + 3 * meshed * wide(bark.vertices);
    if (instanced) bytes += INSTANCE * leaves.count;
  }
  if (kind === 'obj') bytes += IMAGES[textures];
  if (kind === 'glb' && clip) bytes += KEY * bones(tree, options) * (options.seconds * options.rate + 1);
  return { triangles, bytes, large: triangles > LARGE.triangles || bytes > LARGE.bytes };
}

/** Bytes of an index. */
const wide = (vertices: number): number => (vertices > 65_535 ? 4 : 2);

/** Pieces that have a bone. */
function bones({ stems }: ShownTree, { boneLevels, levels }: ExportOptions): number {
  let count = 0;
  for (const stem of stems.stemOfPiece) if (stems.level[stem]! < Math.min(boneLevels, levels)) count++;
  return count;
}

function pictures(kind: 'picture' | 'sequence' | 'video', options: PictureOptions): Estimate {
  const pixels = options.width * options.height;
  const frames = kind === 'picture' ? 1 : Math.max(1, Math.round(options.rate * options.seconds));
  const each = kind === 'video' ? PIXEL[options.quality] / 8 : options.transparent ? PIXEL.transparent : PIXEL.picture;
  const bytes = pixels * frames * each;
  return { ...(kind === 'picture' ? {} : { frames }), bytes, large: bytes > 4 * LARGE.bytes };
}
