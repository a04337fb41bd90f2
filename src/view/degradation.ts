import { type Box3, type Camera, type Matrix4, Vector3 } from 'three';
import { calibratedRange } from '../core/lod/calibrated-range.ts';
import type { TableRow } from '../core/lod/table-2.ts';
import type { Season } from '../core/species/season.ts';

/** What is left out at range: what does not show on the screen, or what Weber & Penn's rules leave out. */
export type Degradation = 'screen' | 'paper';

/** How the paper's rules are applied. */
export interface PaperRange {
  /** 0..1 by the paper. */
  quality: number;
  season: Season;
  evergreen: boolean;
  /** Calibrated range to degrade for; null: that of the camera. */
  r2: number | null;
}

/** Elements that the last frame drew by the paper's rules, in the rows of its Table 2. */
export type DrawnElements = Readonly<Record<TableRow, number>>;

const eye = new Vector3();
const middle = new Vector3();

/** The calibrated range of what stands in `box` (of the frame of `matrixWorld`) for a camera whose picture is `height` pixels high. */
export function rangeFor(camera: Camera, matrixWorld: Matrix4, box: Box3, height: number): number {
  const { elements } = camera.projectionMatrix;
  const focal = Math.max(1e-6, elements[5] as number);
  const scale = matrixWorld.getMaxScaleOnAxis();
  // Without perspective there is no range but by size: that at which 60 degrees show things as large.
  if (elements[15] === 1) return (1000 * Math.sqrt(3)) / (focal * height * scale);
  box.getCenter(middle).applyMatrix4(matrixWorld);
  const away = eye.setFromMatrixPosition(camera.matrixWorld).distanceTo(middle) / scale;
  return calibratedRange(away, height, (2 * Math.atan(1 / focal) * 180) / Math.PI);
}
