import { Box3, PerspectiveCamera, Vector3 } from 'three';
import { describe, expect, it } from 'vitest';
import { frameTree } from '../../src/view/framing.ts';

const FOV = 30;

/** Extent of a box on screen, -1..1 both ways. */
function onScreen(box: Box3, aspect: number, azimuth: number) {
  const { position, target } = frameTree(box, FOV, aspect, azimuth);
  const camera = new PerspectiveCamera(FOV, aspect, 0.01, 10000);
  camera.position.copy(position);
  camera.lookAt(target);
  camera.updateMatrixWorld();
  const seen = new Box3();
  // The crown is round: points of an ellipsoid in the box, not its corners.
  const centre = box.getCenter(new Vector3());
  const half = box.getSize(new Vector3()).multiplyScalar(0.5);
  for (let i = 0; i < 400; i++) {
    const y = 1 - (2 * i) / 399;
    const r = Math.sqrt(1 - y * y);
    const p = new Vector3(r * Math.cos(i * 2.4), y, r * Math.sin(i * 2.4)).multiply(half).add(centre);
    seen.expandByPoint(p.project(camera));
  }
  return { seen, foot: new Vector3(centre.x, 0, centre.z).project(camera), position };
}

const trees: [string, Box3][] = [
  ['aspen', new Box3(new Vector3(-4.6, -0.4, -4.7), new Vector3(4.8, 18.1, 4.4))],
  ['willow', new Box3(new Vector3(-9, 0, -9), new Vector3(9, 14, 9))],
  ['shrub', new Box3(new Vector3(-1, 0, -1), new Vector3(1.2, 1.1, 1))],
  ['giant', new Box3(new Vector3(-20, 0, -20), new Vector3(20, 60, 20))],
];

describe.each(trees)('framing of %s', (_, box) => {
  it.each([0.46, 0.75, 1, 1.5, 2.4])('shows all of it with air above at aspect %s', (aspect) => {
    for (const azimuth of [0, 1, 3]) {
      const { seen, foot } = onScreen(box, aspect, azimuth);
      expect(seen.max.y).toBeLessThan(0.95);
      expect(seen.min.x).toBeGreaterThan(-0.97);
      expect(seen.max.x).toBeLessThan(0.97);
      expect(foot.y).toBeGreaterThan(-0.92);
      expect(foot.y).toBeLessThan(-0.2);
      expect(seen.min.y).toBeGreaterThan(-1);
    }
  });

  it('does not waste the window: a wide one is filled in height, a tall one in width', () => {
    const wide = onScreen(box, 2.4, 0).seen;
    expect(wide.max.y).toBeGreaterThan(0.5);
    const tall = onScreen(box, 0.46, 0).seen;
    expect(Math.max(tall.max.x - tall.min.x, tall.max.y - tall.min.y)).toBeGreaterThan(1.1);
  });
});
