import { newFrame, rectify } from './frame.ts';
import type { Stems } from './tree.ts';

/**
 * Stretches a finished tree along its vertical (ZScale +- ZScaleV, row 18), in place: nodes, frames and lengths.
 * Radii and leaves keep their size, and z still runs in equal steps of the nodes.
 */
export function stretchStems(stems: Stems, factor: number): void {
  const { nodePosition: p, nodeFrame, nodeStart } = stems;
  for (let n = 2; n < p.length; n += 3) p[n] *= factor;
  const f = newFrame();
  for (let i = 0; i < stems.count; i++) {
    const last = nodeStart[i + 1] - 1;
    let length = 0;
    for (let n = nodeStart[i]; n <= last; n++) {
      for (let k = 0; k < 9; k++) f[k] = nodeFrame[9 * n + k];
      f[5] *= factor;
      f[8] *= factor;
      rectify(f);
      nodeFrame.set(f, 9 * n);
      if (n === last) continue;
      const dx = p[3 * n + 3] - p[3 * n];
      const dy = p[3 * n + 4] - p[3 * n + 1];
      const dz = p[3 * n + 5] - p[3 * n + 2];
      length += Math.sqrt(dx * dx + dy * dy + dz * dz);
    }
    // A clone has the length of a whole stem, of which it covers the part from zStart on.
    stems.length[i] = length / (1 - stems.zStart[i]);
  }
}
