import { encode } from 'fast-png';
import type { LeafTriangles } from '../mesh/expand-leaves.ts';
import type { LeafPlacements } from '../mesh/leaf-placements.ts';
import type { GrownPacked } from '../pack/grow-packed.ts';
import { type ChannelSurface, godotColours, leafSurface, stemChannels, windAttributes } from './channels.ts';
import { channelsText } from './channels-text.ts';
import type { ExportFile } from './export-options.ts';
import { textFile } from './export-species.ts';
import type { WriteFormat } from './export-tree.ts';
import { writeExr } from './exr.ts';
import type { GlbAttribute } from './glb/primitives.ts';
import { writeGlb } from './glb/write-glb.ts';
import { axisTexture, type PivotElements, pivotElements, pivotTexture, pivotUv } from './pivot-painter.ts';

/** The channels of a tree for an engine: its mesh with them, what goes beside it, and a text that says what they mean. */
export const exportChannels: WriteFormat = async ({ grown: grow, options, name, report }) => {
  const grown = grow();
  const { engine } = options;
  const elements = engine === 'unreal' ? pivotElements(grown.stems, options.levels) : null;
  const attributesOf = (surface: ChannelSurface): GlbAttribute[] => {
    if (elements) return [elementPlaces(surface, grown, elements)];
    return engine === 'godot' ? [godotColours(surface, grown)] : windAttributes(surface, grown);
  };
  // Every leaf has vertices of its own: an instance could not say where it hangs.
  const leaves = options.leaves === 'none' ? 'none' : 'expanded';
  const mesh = await writeGlb(
    grown,
    { ...options, leaves, lods: 'none', clip: false, quantize: false },
    {
      report,
      attributes: {
        bark: attributesOf,
        leaves: (triangles: LeafTriangles, placements: LeafPlacements) =>
          attributesOf(leafSurface(placements, triangles, grown)),
      },
    },
  );
  const files = {
    mesh: `${name}.glb`,
    ...(engine === 'attributes' ? { stems: `${name}.stems.csv` } : {}),
    ...(elements ? { pivots: `${name}-pivot.exr`, axes: `${name}-axis.png` } : {}),
  };
  return [
    { name: files.mesh, bytes: mesh, type: 'model/gltf-binary' },
    ...(files.stems ? [textFile(files.stems, stemsText(grown), 'text/csv')] : []),
    ...(elements ? textures(grown, elements, `${name}-pivot.exr`, `${name}-axis.png`) : []),
    textFile(`${name}.channels.txt`, channelsText(grown, engine, files, elements), 'text/plain'),
  ];
};

/** Second texture coordinates: the texel of each vertex' element. */
function elementPlaces(
  { vertexCount, piece }: ChannelSurface,
  { pieces }: GrownPacked,
  elements: PivotElements,
): GlbAttribute {
  const array = new Float32Array(2 * vertexCount);
  for (let i = 0; i < vertexCount; i++) array.set(pivotUv(elements, elements.ofStem[pieces.stem[piece[i]!]!]!), 2 * i);
  return { semantic: 'TEXCOORD_1', size: 2, array };
}

function textures({ stems }: GrownPacked, elements: PivotElements, pivots: string, axes: string): ExportFile[] {
  const { width, height } = elements;
  const png = encode({ width, height, data: axisTexture(elements, stems), channels: 4, depth: 8 });
  return [
    { name: pivots, bytes: writeExr(width, height, pivotTexture(elements, stems)), type: 'image/x-exr' },
    { name: axes, bytes: Uint8Array.from(png), type: 'image/png' },
  ];
}

/** The stems as a table: what a shader of one's own needs of the parents. Metres, y up. */
function stemsText({ stems, tree }: GrownPacked): string {
  const { phase } = stemChannels(stems, tree.species.wind.stiffness);
  const lines = ['stem,parent,parent_s,level,clone,x,y,z,length,radius,phase'];
  for (let i = 0; i < stems.count; i++) {
    const [x, y, z] = [stems.base[3 * i]!, stems.base[3 * i + 2]!, -stems.base[3 * i + 1]!];
    const metres = [x, y, z, stems.length[i]!, stems.radius[i]!].map((value) => (value + 0).toFixed(5));
    lines.push(
      `${i},${stems.parent[i]},${stems.parentZ[i]!.toFixed(5)},${stems.level[i]},${stems.clone[i]},${metres.join(',')},${phase[i]!.toFixed(5)}`,
    );
  }
  return `${lines.join('\n')}\n`;
}
