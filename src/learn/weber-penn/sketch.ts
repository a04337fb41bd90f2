import { taperRadius } from '../../core/deform/radius.ts';
import { parametersOf } from '../../core/grow/plan.ts';
import type { Tree } from '../../core/grow/tree.ts';
import type { Colours } from '../figure.ts';
import type { Plane } from '../plane.ts';

/** How a grown tree is sketched. */
export interface SketchStyle {
  /** Radians by which it is turned about its vertical. */
  readonly turn?: number;
  /** Metres that it stands to the right. */
  readonly right?: number;
  readonly colours: Colours;
  /** Default true: leaves as dots. */
  readonly leaves?: boolean;
  /** Levels below this one; default all. */
  readonly levels?: number;
  /** One colour for all stems, in place of those of the levels. */
  readonly colour?: string;
  readonly alpha?: number;
}

const levelColours = (c: Colours): string[] => [c.level0, c.level1, c.level2, c.level3];

/** A tree as the grower made it, seen from the side without perspective: stems as thick as they are, in the colours of their levels. */
export function sketchTree(plane: Plane, { species, stems, leaves }: Tree, style: SketchStyle): void {
  const { turn = 0, right = 0, colours, levels = Number.POSITIVE_INFINITY, alpha = 1 } = style;
  const { context } = plane;
  const [scale] = plane.scale;
  const [cos, sin] = [Math.cos(turn), Math.sin(turn)];
  const place = (node: number): readonly [number, number] => {
    const [x, y, z] = stems.nodePosition.subarray(3 * node, 3 * node + 3) as unknown as [number, number, number];
    return plane.toPixel(right + x * cos - y * sin, z);
  };
  context.lineCap = 'round';
  context.globalAlpha = alpha;
  const inks = levelColours(colours);
  // Thick stems lie over thin ones, as a plate shows them.
  for (let level = Math.min(levels, species.tree.levels) - 1; level >= 0; level--) {
    context.strokeStyle = style.colour ?? (inks[Math.min(level, 3)] as string);
    const { taper } = parametersOf(species, level);
    for (let i = 0; i < stems.count; i++) {
      if (stems.level[i] !== level) continue;
      const [first, end] = [stems.nodeStart[i] as number, stems.nodeStart[i + 1] as number];
      const [length, radius, from] = [
        stems.length[i] as number,
        stems.baseRadius[i] as number,
        stems.zStart[i] as number,
      ];
      let [px, py] = place(first);
      for (let node = first + 1; node < end; node++) {
        const [x, y] = place(node);
        const zOf = (part: number): number => from + ((node - 1 - first + part) / (end - 1 - first)) * (1 - from);
        const wide = (part: number): number => 2 * scale * taperRadius(zOf(part), taper, radius, length)[0];
        // A thick stem is drawn in short pieces, so that it tapers evenly however few segments it has.
        const pieces = Math.min(12, Math.max(1, Math.ceil(2 * Math.abs(wide(0) - wide(1)))));
        for (let k = 0; k < pieces; k++) {
          context.lineWidth = Math.max(0.7, wide((k + 0.5) / pieces));
          context.beginPath();
          context.moveTo(px + ((x - px) * k) / pieces, py + ((y - py) * k) / pieces);
          context.lineTo(px + ((x - px) * (k + 1)) / pieces, py + ((y - py) * (k + 1)) / pieces);
          context.stroke();
        }
        [px, py] = [x, y];
      }
    }
  }
  if (style.leaves !== false && levels >= species.tree.levels) {
    context.fillStyle = colours.answer;
    context.globalAlpha = 0.35 * alpha;
    const size = Math.max(1, (leaves.length[0] ?? 0) * scale * 0.8);
    for (let i = 0; i < leaves.count; i++) {
      const stem = leaves.stem[i] as number;
      const [first, end] = [stems.nodeStart[stem] as number, stems.nodeStart[stem + 1] as number];
      const from = stems.zStart[stem] as number;
      const along = Math.min(0.999999, Math.max(0, ((leaves.z[i] as number) - from) / (1 - from))) * (end - 1 - first);
      const node = first + Math.floor(along);
      const part = along - Math.floor(along);
      const [ax, ay] = place(node);
      const [bx, by] = place(node + 1);
      context.fillRect(ax + part * (bx - ax) - size / 2, ay + part * (by - ay) - size / 2, size, size);
    }
  }
  context.globalAlpha = 1;
}

/** Stems of a level that are no clones. */
export function stemsOf({ stems }: Tree, level: number): number[] {
  const found: number[] = [];
  for (let i = 0; i < stems.count; i++) if (stems.level[i] === level && stems.clone[i] === 0) found.push(i);
  return found;
}

/** The angle of a stem's first segment from its parent's direction there, in degrees. */
export function declinationAt({ stems }: Tree, i: number): number {
  const z = stems.nodeFrame[9 * (stems.nodeStart[i] as number) + 8] as number;
  return (Math.acos(Math.min(1, Math.max(-1, z))) * 180) / Math.PI;
}
