import { byte, type Colour, colourOf, mixColours } from '../../look/colour.ts';
import { type CrownLight, lightAt } from '../../look/crown-light.ts';
import { leafColour } from '../../look/leaf-look.ts';
import type { BarkMesh } from '../../mesh/bark-mesh.ts';
import type { LeafPlacements } from '../../mesh/leaf-placements.ts';
import type { PieceTable } from '../../mesh/piece-table.ts';
import type { Species } from '../../species/species.ts';

/** How much of the shelter of a crown is laid into the colours: programs that light by the sky alone know nothing of it. */
const SHELTER = 0.35;

const smoothstep = (a: number, b: number, x: number): number => {
  const t = Math.min(1, Math.max(0, (x - a) / (b - a)));
  return t * t * (3 - 2 * t);
};

/** COLOR_0 of the stems, 4 bytes a vertex: darker inside the crown and where a branch leaves its parent, as the shader has it. */
export function barkTint(mesh: BarkMesh, table: PieceTable, crown: CrownLight): Uint8Array<ArrayBuffer> {
  const out = new Uint8Array(4 * mesh.vertexCount).fill(255);
  for (let i = 0; i < mesh.vertexCount; i++) {
    const p = mesh.position;
    const sky = 0.4 + 0.6 * lightAt(crown, p[3 * i]!, p[3 * i + 1]!, p[3 * i + 2]!);
    const piece = mesh.piece[i]!;
    const parent = table.parentRadius[piece]!;
    const reach = parent + 2.5 * table.baseRadius[piece]!;
    const joint = parent > 0 ? smoothstep(0.6, 1, (mesh.v[i]! * table.length[piece]!) / reach) : 1;
    out.fill(byte(1 - SHELTER * (1 - sky * (0.6 + 0.4 * joint))), 4 * i, 4 * i + 3);
  }
  return out;
}

/** COLOR_0 of organs, 4 bytes a vertex: their two colours, and how far each vertex is from one to the other (`uv`). */
export function organColours(uv: Float32Array, { organ }: Species): Uint8Array<ArrayBuffer> {
  const [first, second] = [colourOf(organ.colour), colourOf(organ.second)];
  const out = new Uint8Array(2 * uv.length).fill(255);
  for (let i = 0; i < uv.length / 2; i++) {
    const colour = mixColours(first, second, uv[2 * i]!);
    for (const k of [0, 1, 2] as const) out[4 * i + k] = byte(colour[k]);
  }
  return out;
}

/** The colour of each leaf as a part of the material's, 3 a leaf, 0..1. */
export function leafTints(
  { count, own, position }: LeafPlacements,
  { foliage }: Species,
  crown: CrownLight,
  base: Colour,
  gain: number,
): Float32Array<ArrayBuffer> {
  const out = new Float32Array(3 * count);
  for (let i = 0; i < count; i++) {
    const colour = leafColour(foliage, own[i]!);
    const sky = lightAt(crown, position[3 * i]!, position[3 * i + 1]!, position[3 * i + 2]!);
    const light = gain * (1 - SHELTER * (1 - sky));
    for (let k = 0; k < 3; k++)
      out[3 * i + k] = Math.min(1, Math.max(0, (colour[k]! * light) / Math.max(base[k]!, 1e-6)));
  }
  return out;
}
