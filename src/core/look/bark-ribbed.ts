import { cloud, drawer, noise, paint, type Relief, smoothstep, stamp } from './bark-relief.ts';

/** Ribs that a tile holds around the stem, and areoles along each. */
export const RIBS_PER_TILE = 4;
const AREOLES = 8;

/**
 * The waxy skin of a cactus; on the crest of each rib a row of areoles, woolly cushions with a star of spines. The straw of
 * wool and spines is paler: darkness above a half stands for them (`BARK_SPINED` in the shader). A rib's crest is at (k + 1/2) / 4 of the tile.
 */
export function ribbed(size: number): Relief {
  const clouds = cloud(4, 3, 71, 3);
  const wax = cloud(64, 64, 72, 2);
  const scar = noise(10, 30, 73);
  const relief = paint(size, (u, v, out) => {
    const a = clouds(u, v);
    const w = wax(u, v);
    const rib = Math.abs(u * RIBS_PER_TILE - Math.floor(u * RIBS_PER_TILE) - 0.5) * 2;
    const crest = 1 - rib;
    const cork = smoothstep(0.32, 0.55, scar(u, v)) * smoothstep(0.5, 0.9, rib);
    out.height = 0.4 + 0.12 * crest + 0.04 * a + 0.02 * w;
    // Both ends of a rib's strip are alike, so that any number of ribs closes around a stem.
    out.dark = 0.06 + 0.12 * rib * rib + 0.08 * a * smoothstep(1, 0.7, rib) + 0.04 * w + 0.16 * cork;
  });
  const { height, dark } = relief;
  const draw = drawer(74);
  const tileOfRow = 1 / AREOLES;
  for (let rib = 0; rib < RIBS_PER_TILE; rib++) {
    const shift = draw();
    for (let k = 0; k < AREOLES; k++) {
      const at = [
        (rib + 0.5) / RIBS_PER_TILE + 0.008 * (draw() - 0.5),
        (k + shift + 0.1 * (draw() - 0.5)) * tileOfRow,
      ] as const;
      // The rib is drawn in around its areoles.
      stamp(size, at, [0.06, 0.05], (t, d) => {
        height[t] = height[t]! + 0.1 * smoothstep(1, 0.2, d);
        dark[t] = dark[t]! + 0.05 * smoothstep(1, 0.5, d);
      });
      stamp(size, at, [0.017, 0.02], (t, d) => {
        const f = smoothstep(1, 0.6, d);
        dark[t] = Math.max(dark[t]!, 0.7 * f);
        height[t] = height[t]! + 0.2 * f;
      });
      const spines = 9 + Math.floor(4 * draw());
      for (let s = 0; s < spines; s++) {
        // A direction without sine: a point of the square's rim, made unit.
        const side = (4 * (s + 0.5 * draw())) / spines;
        const on = 2 * (side - Math.floor(side)) - 1;
        const [x, y] = (
          [
            [1, on],
            [-on, 1],
            [-1, -on],
            [on, -1],
          ] as const
        )[Math.floor(side) % 4]!;
        const n = 1 / Math.sqrt(x * x + y * y);
        spine(size, relief, at, [x * n, y * n], 0.035 + 0.035 * draw());
      }
    }
  }
  return relief;
}

/** A straight thorn from an areole outwards, `long` tiles. */
function spine(
  size: number,
  { height, dark }: Relief,
  [u, v]: readonly [number, number],
  [x, y]: readonly [number, number],
  long: number,
): void {
  const mask = size - 1;
  const steps = Math.ceil(long * size * 1.5);
  for (let i = 0; i < steps; i++) {
    const s = i / steps;
    const px = (u + x * long * s) * size;
    const py = (v + y * long * s) * size;
    const wide = 1.15 * (1 - 0.6 * s);
    for (let cy = Math.floor(py - 1); cy <= py + 2; cy++) {
      for (let cx = Math.floor(px - 1); cx <= px + 2; cx++) {
        const across = Math.abs((cx - px) * y - (cy - py) * x);
        const f = smoothstep(wide + 0.6, wide - 0.4, across);
        const t = (cy & mask) * size + (cx & mask);
        dark[t] = Math.max(dark[t]!, f * (0.95 - 0.1 * s));
        height[t] = Math.max(height[t]!, f * 0.95);
      }
    }
  }
}
