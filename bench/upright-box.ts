import { Box3, Vector3 } from 'three';

/** The box of a packed tree (z up: min x, y, z, max x, y, z) as the box that it fills in a scene (y up). */
export function uprightBox(bounds: Float32Array): Box3 {
  const [x0, y0, z0, x1, y1, z1] = bounds as unknown as [number, number, number, number, number, number];
  return new Box3(new Vector3(x0, z0, -y1), new Vector3(x1, z1, -y0));
}
