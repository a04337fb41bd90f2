import { barkWrap } from '../look/bark-wrap.ts';
import type { GrownPacked } from '../pack/grow-packed.ts';
import { planeOf, poseOf } from '../wind/pose-plainly.ts';
import { levelShape } from './level-shape.ts';
import { GRADES, type MeshGrade, sectorsOf } from './mesh-detail.ts';
import { type PieceTable, pieceTable } from './piece-table.ts';
import { ringsOf } from './stem-rings.ts';
import { StemWriter } from './stem-writer.ts';

/** A run of vertices and of indices that belong together; the indices count from 0, as the mesh does. */
export interface MeshPart {
  readonly name: 'bark' | 'twigs';
  readonly firstVertex: number;
  readonly vertexCount: number;
  readonly firstIndex: number;
  readonly indexCount: number;
}

/** The stems of a tree as one indexed mesh: triangles counter-clockwise from outside, metres, tree space (z up). */
export interface BarkMesh {
  readonly vertexCount: number;
  readonly triangleCount: number;
  /** 3 a vertex. */
  readonly position: Float32Array;
  /** Outward, of length 1; 3 a vertex. */
  readonly normal: Float32Array;
  /** Direction of growing u of the texture, and 1: normal x tangent points along the stem; 4 a vertex. */
  readonly tangent: Float32Array;
  /** Tiles around and along the stem; 2 a vertex. A tile is as wide as it is high, so that bark has its size in metres. */
  readonly uv: Float32Array;
  /** The piece that the vertex is on, and where: Bezier parameter on the piece, part of the whole stem (0..1). */
  readonly piece: Uint32Array;
  readonly u: Float32Array;
  readonly v: Float32Array;
  /** Level of the stem. */
  readonly level: Uint8Array;
  /** 3 a triangle. */
  readonly index: Uint32Array;
  /** Stems with a pattern of bark, then thin ones, which need none; either may be empty. */
  readonly parts: readonly MeshPart[];
}

export interface BarkMeshOptions {
  readonly grade: MeshGrade;
  /** Levels of stems that are meshed, from the trunk on. */
  readonly levels: number;
  /** A pose laid out as POSE_TARGETS; the rest pose by default. The triangles are the same in every pose. */
  readonly pose?: Float32Array;
  /** Bands of every piece at least, on levels below `bentLevels`: what wind bends needs rings to bend at. */
  readonly leastBands?: number;
  readonly bentLevels?: number;
}

/** Stems thinner than this at their start, metres, have no pattern of bark. */
export const TWIG_RADIUS = 0.009;

/** Stems thinner or shorter than this, metres, have no surface in 32 bits. */
const NO_SIZE = 2e-5;

/** A stem of the mesh, planned. */
interface PlannedStem {
  readonly stem: number;
  readonly sectors: number;
  /** Its pieces, and the rings of each beside the first of all. */
  readonly pieces: readonly number[];
  readonly rings: readonly number[][];
  readonly thin: boolean;
}

/** Meshes the stems of a grown tree. */
export function meshBark(grown: GrownPacked, options: BarkMeshOptions): BarkMesh {
  const { packed, tree } = grown;
  const { species } = tree;
  const table = pieceTable(packed);
  const stems = planStems(grown, table, options);
  const ordered = [...stems.filter(({ thin }) => !thin), ...stems.filter(({ thin }) => thin)];
  let vertices = 0;
  let triangles = 0;
  for (const { sectors, rings } of ordered) {
    const count = rings.reduce((sum, list) => sum + list.length, 1);
    vertices += count * (sectors + 1) + sectors;
    triangles += (count - 1) * sectors * 2 + sectors;
  }
  const writer = new StemWriter(vertices, triangles, table, barkWrap(species.bark));
  const pose = options.pose ?? packed.restPose.data;
  const plane = planeOf(packed.restPose);
  const marks: number[] = [];
  let thin = false;
  for (const planned of ordered) {
    if (planned.thin && !thin) {
      thin = true;
      marks.push(writer.vertices, writer.indices);
    }
    const level = tree.stems.level[planned.stem]!;
    writer.begin(levelShape(species, level), level, planned.sectors);
    planned.pieces.forEach((piece, k) => {
      writer.enter(piece, poseOf(pose, plane, piece));
      if (k === 0) writer.ring(0);
      for (const u of planned.rings[k]!) writer.ring(u);
    });
    writer.close();
  }
  const [firstThin, firstThinIndex] = thin ? (marks as [number, number]) : [writer.vertices, writer.indices];
  const part = (name: MeshPart['name'], from: number, to: number, first: number, last: number): MeshPart => ({
    name,
    firstVertex: from,
    vertexCount: to - from,
    firstIndex: first,
    indexCount: last - first,
  });
  return {
    ...writer.done(),
    parts: [
      part('bark', 0, firstThin, 0, firstThinIndex),
      part('twigs', firstThin, writer.vertices, firstThinIndex, writer.indices),
    ],
  };
}

function planStems({ tree, pieces, packed }: GrownPacked, table: PieceTable, options: BarkMeshOptions): PlannedStem[] {
  const { stems, species } = tree;
  const rule = GRADES[options.grade];
  const { leastBands = 1, bentLevels = 0 } = options;
  const rest = packed.restPose.data;
  const plane = planeOf(packed.restPose);
  const out: PlannedStem[] = [];
  for (let stem = 0; stem < stems.count; stem++) {
    const level = stems.level[stem]!;
    const radius = stems.baseRadius[stem]!;
    if (level >= options.levels || radius < Math.max(NO_SIZE, rule.thinnest)) continue;
    if (stems.length[stem]! * (1 - stems.zStart[stem]!) < NO_SIZE) continue;
    const shape = levelShape(species, level);
    const least = level < bentLevels ? leastBands : 1;
    const list: number[] = [];
    const rings: number[][] = [];
    for (let p = pieces.firstOfStem[stem]!; p >= 0; p = pieces.next[p]!) {
      list.push(p);
      rings.push(ringsOf(p, poseOf(rest, plane, p).curve, table, shape, rule, least));
    }
    out.push({
      stem,
      sectors: sectorsOf(radius * (1 + shape.flare * 0.3), rule, shape.lobes, shape.lobeDepth),
      pieces: list,
      rings,
      thin: level > 0 && radius < TWIG_RADIUS,
    });
  }
  return out;
}
