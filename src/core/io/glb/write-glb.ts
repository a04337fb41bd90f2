import { Document, type Mesh, type Node, VertexLayout, WebIO } from '@gltf-transform/core';
import { EXTMeshGPUInstancing, KHRMaterialsDiffuseTransmission, KHRMeshQuantization } from '@gltf-transform/extensions';
import { treeLight } from '../../look/tree-light.ts';
import { expandLeaves, type LeafTriangles } from '../../mesh/expand-leaves.ts';
import type { LeafPlacements } from '../../mesh/leaf-placements.ts';
import { gradesFrom, type MeshGrade } from '../../mesh/mesh-detail.ts';
import { pieceTable } from '../../mesh/piece-table.ts';
import { restJoints, type Skeleton, skeletonOf } from '../../mesh/skeleton.ts';
import { MOST_JOINTS, skinOf } from '../../mesh/skin.ts';
import { meshTree, type TreeMesh } from '../../mesh/tree-mesh.ts';
import type { GrownPacked } from '../../pack/grow-packed.ts';
import { STILL, type Wind } from '../../wind/wind.ts';
import type { ExportOptions } from '../export-options.ts';
import type { ReportExport } from '../export-tree.ts';
import { Accessors } from './accessors.ts';
import { bakeClip } from './bake-clip.ts';
import { clipTracks } from './clip-tracks.ts';
import { hangLeaves, leafNode } from './leaf-instances.ts';
import { treeMaterials } from './materials.ts';
import { MsftLod } from './msft-lod.ts';
import {
  barkPrimitives,
  type GlbAttribute,
  leafPrimitive,
  oneLeafPrimitive,
  oneOrganPrimitive,
  organPrimitive,
  type VertexWriter,
} from './primitives.ts';
import { quantumOf } from './quantize.ts';
import { type SkinNodes, skinNodes } from './skin-nodes.ts';
import { barkTint, leafTints, organColours } from './tint.ts';
import { yUp, yUpJoints } from './y-up.ts';

export type { GlbAttribute } from './primitives.ts';

/** The options that a GLB reads. */
export type GlbOptions = Omit<ExportOptions, 'format' | 'engine'>;

/** What a GLB may be given besides. */
export interface GlbExtras {
  /** The wind of the clip; still air by default. */
  readonly wind?: Wind;
  readonly report?: ReportExport;
  /** Further attributes of the vertices, in tree space: by the caller's own maps. */
  readonly attributes?: {
    readonly bark?: (mesh: TreeMesh) => readonly GlbAttribute[];
    readonly leaves?: (leaves: LeafTriangles, placements: LeafPlacements) => readonly GlbAttribute[];
  };
}

/** Part of the height of the screen that a tree covers at least for each level of detail (MSFT_screencoverage). */
const COVERAGE = [0.5, 0.2, 0.02];

/** A level of detail, meshed. */
interface Level {
  readonly name: string;
  readonly mesh: TreeMesh;
  /** Leaves and organs as triangles; null where there are none, or instances are written. */
  readonly expanded: Readonly<Record<'leaves' | 'organs', LeafTriangles | null>>;
}

/**
 * A tree as one binary glTF file: metres, y up, counter-clockwise from outside.
 *
 * With `clip`, stems below `boneLevels` have bones and an animation that comes around after `seconds`, sampled from the reference's poses.
 * The same tree and options give the same bytes in Node and in a browser. Throws RangeError for more than 65 536 joints.
 */
export async function writeGlb(
  grown: GrownPacked,
  options: GlbOptions,
  { wind = STILL, report = () => {}, attributes = {} }: GlbExtras = {},
): Promise<Uint8Array<ArrayBuffer>> {
  const { tree, packed, pieces } = grown;
  const { species } = tree;
  const document = new Document();
  const accessors = new Accessors(document);
  document.getRoot().getAsset().generator = 'Windgrove';
  report('textures', 0);
  const size = options.textures === 'none' ? 0 : Number(options.textures);
  const materials = treeMaterials(document, species, size, (done) => report('textures', 0.2 * done));
  report('mesh', 0.2);
  const skeleton = options.clip ? skeletonOf(grown, Math.min(options.boneLevels, options.levels)) : null;
  if (skeleton && skeleton.count > MOST_JOINTS) throw tooManyJoints(skeleton);
  // Bones carry one set of instances: several levels of detail have triangles of their own.
  const instanced = options.leaves === 'instances' && (!skeleton || options.lods === 'none');
  const levels = meshLevels(grown, options, skeleton !== null, instanced, (done) => report('mesh', 0.2 + 0.2 * done));
  const quantum = options.quantize ? quantumOf(levels.flatMap(pointsOf)) : null;
  if (quantum) document.createExtension(KHRMeshQuantization).setRequired(true);
  const writer: VertexWriter = { document, accessors, quantum };
  const rest = skeleton ? restJoints(grown, skeleton) : null;
  const bones: SkinNodes | null = skeleton && rest ? skinNodes(document, accessors, skeleton, rest, quantum) : null;
  const scene = document.createScene(species.name);
  document.getRoot().setDefaultScene(scene).setExtras(provenance(grown, options));
  const table = pieceTable(packed);
  const light = treeLight(packed, species);
  const skinFor = (piece: ArrayLike<number>, u: ArrayLike<number>) =>
    skeleton ? skinOf(skeleton, pieces, piece, u) : null;
  const joints = skeleton?.count ?? 0;
  const tintsOf = (placed: LeafPlacements): Float32Array<ArrayBuffer> =>
    leafTints(placed, species, light, materials.leafBase, materials.leafGain);
  const nodes = levels.map(({ name, mesh, expanded }): Node => {
    const tint = barkTint(mesh, table, light);
    const body: Mesh = document.createMesh(name);
    const skin = skinFor(mesh.piece, mesh.u);
    const more = attributes.bark?.(mesh) ?? [];
    for (const each of barkPrimitives(writer, mesh, materials, tint, skin, joints, more)) body.addPrimitive(each);
    const node = document.createNode(name).setMesh(body);
    if (bones) node.setSkin(bones.skin);
    else if (quantum) {
      node.setTranslation([...quantum.offset]).setScale([quantum.scale, quantum.scale, quantum.scale]);
    }
    const instances: Node[] = [];
    for (const kind of ['leaves', 'organs'] as const) {
      const placed = mesh[kind];
      if (!placed) continue;
      const triangles = expanded[kind];
      if (triangles) {
        const at = skeleton ? perVertex(triangles, placed) : null;
        const own = at ? skinFor(at.piece, at.u) : null;
        const others = attributes.leaves?.(triangles, placed) ?? [];
        body.addPrimitive(
          kind === 'leaves'
            ? leafPrimitive(writer, triangles, materials, tintsOf(placed), packed.crown, own, joints, others)
            : organPrimitive(writer, triangles, materials, organColours(triangles.uv, species), own, joints, others),
        );
        continue;
      }
      const one = document
        .createMesh(kind === 'leaves' ? 'leaf' : 'organ')
        .addPrimitive(
          kind === 'leaves'
            ? oneLeafPrimitive(writer, placed, materials)
            : oneOrganPrimitive(writer, placed, materials, organColours(placed.leaf.uv, species)),
        );
      const tints = kind === 'leaves' ? tintsOf(placed) : new Float32Array(3 * placed.count).fill(1);
      if (skeleton && bones && rest) {
        const skinned = skinOf(skeleton, pieces, placed.piece, placed.u);
        hangLeaves(document, accessors, kind, one, placed, tints, skeleton, skinned, yUpJoints(rest), bones.joints);
      } else instances.push(leafNode(document, accessors, `${name}_${kind}`, one, placed, tints));
    }
    if (instances.length === 0) return node;
    // The scale of short numbers is the stems' own.
    const whole = quantum ? document.createNode(name).addChild(node.setName(`${name}_stems`)) : node;
    for (const each of instances) whole.addChild(each);
    return whole;
  });
  report('mesh', 0.5);
  stand(document, nodes, options.lods);
  for (const node of options.lods === 'MSFT_lod' ? nodes.slice(0, 1) : nodes) scene.addChild(node);
  if (bones) scene.addChild(bones.root);
  if (skeleton && bones && rest) {
    report('wind', 0.5);
    const { clip, poses } = bakeClip(grown, skeleton, yUpJoints(rest), wind, options, (done) =>
      report('wind', 0.5 + 0.3 * done),
    );
    clipTracks(document, accessors, clip, bones.joints, wind.name || 'wind', {
      wind: wind.name,
      model: wind.model,
      seconds: clip.seconds,
      start: options.start,
      speedChange: Number(poses.change.toPrecision(4)),
      open: [...poses.open],
    });
  }
  report('write', 0.8);
  const io = new WebIO()
    .setVertexLayout(VertexLayout.SEPARATE)
    .registerExtensions([EXTMeshGPUInstancing, KHRMaterialsDiffuseTransmission, KHRMeshQuantization, MsftLod]);
  const bytes = await io.writeBinary(document);
  report('write', 1);
  return bytes as Uint8Array<ArrayBuffer>;
}

const tooManyJoints = ({ count }: Skeleton): RangeError =>
  new RangeError(`${count} bones are more than the ${MOST_JOINTS} of a skin: give bones to fewer levels.`);

/** The levels of detail that are asked for, meshed. */
function meshLevels(
  grown: GrownPacked,
  options: GlbOptions,
  bent: boolean,
  instanced: boolean,
  report: (done: number) => void,
): Level[] {
  const grades: readonly MeshGrade[] = options.lods === 'none' ? [options.detail] : gradesFrom(options.detail);
  return grades.map((detail, i) => {
    const mesh = meshTree(grown, {
      detail,
      levels: options.levels,
      leaves: options.leaves !== 'none',
      mostLeaves: options.mostLeaves,
      ...(bent
        ? { leastBands: detail === 'high' ? 4 : detail === 'medium' ? 3 : 2, bentLevels: options.boneLevels }
        : {}),
    });
    const triangles = (placed: LeafPlacements | null): LeafTriangles | null =>
      placed && !instanced ? expandLeaves(placed) : null;
    const expanded = { leaves: triangles(mesh.leaves), organs: triangles(mesh.organs) };
    report((i + 1) / grades.length);
    return { name: options.lods === 'none' ? 'tree' : `tree_LOD${i}`, mesh, expanded };
  });
}

const pointsOf = ({ mesh, expanded }: Level): Float32Array[] =>
  [mesh, expanded.leaves, expanded.organs].flatMap((part) => (part ? [yUp(part.position)] : []));

/** Piece and Bezier parameter of each vertex of the leaves: those of its stalk. */
function perVertex({ leaf }: LeafTriangles, { piece, u }: LeafPlacements): { piece: Uint32Array; u: Float32Array } {
  const out = { piece: new Uint32Array(leaf.length), u: new Float32Array(leaf.length) };
  for (let i = 0; i < leaf.length; i++) {
    out.piece[i] = piece[leaf[i]!]!;
    out.u[i] = u[leaf[i]!]!;
  }
  return out;
}

/** Where a tree comes from, for whoever finds the file. */
const provenance = ({ tree, stats }: GrownPacked, { link }: GlbOptions): Record<string, unknown> => ({
  species: tree.species.name,
  latin: tree.species.latin,
  seed: tree.seed,
  height: Number(stats.height.toFixed(3)),
  ...(link ? { link } : {}),
});

/** Ties the levels of detail together. */
function stand(document: Document, nodes: readonly Node[], lods: ExportOptions['lods']): void {
  const [first, ...others] = nodes;
  if (lods !== 'MSFT_lod' || !first || others.length === 0) return;
  const levels = document.createExtension(MsftLod).createLevels();
  for (const node of others) levels.addNode(node);
  first.setExtension('MSFT_lod', levels).setExtras({ MSFT_screencoverage: COVERAGE.slice(0, nodes.length) });
}
