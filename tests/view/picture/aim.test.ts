import { PerspectiveCamera } from 'three';
import { expect, test } from 'vitest';
import { groundAt, groundTowards, metresAPixel, windowPoint } from '../../../src/view/picture/aim.ts';

const area = { left: 50, top: 20, width: 800, height: 600 };
const camera = new PerspectiveCamera(30, 800 / 600, 0.1, 1000);
camera.position.set(3, 1.6, 20);
camera.lookAt(0, 2, 0);
camera.setViewOffset(800, 600, 40, -30, 800, 600);
camera.updateMatrixWorld();

test('the ground under a point of the window is where that point was', () => {
  for (const [x, y] of [
    [0, 0],
    [4, -3],
    [-2, 6],
  ] as const) {
    const seen = windowPoint(x, y, 0, area, camera)!;
    const ground = groundAt(seen.x, seen.y, area, camera)!;
    expect(ground.x).toBeCloseTo(x, 6);
    expect(ground.y).toBeCloseTo(y, 6);
  }
});

test('there is no ground in the sky, and what lies behind the eye is nowhere', () => {
  expect(groundAt(450, 40, area, camera)).toBeNull();
  expect(windowPoint(3, -40, 0, area, camera)).toBeNull();
  // A hand that drags into the sky holds on to the far meadow below it.
  const far = groundTowards(450, 40, area, camera, 100);
  expect(Math.hypot(far.x - 3, -far.y - 20)).toBeCloseTo(100, 6);
  expect(far.y).toBeGreaterThan(50);
});

test('a pixel is as wide as it is', () => {
  const a = windowPoint(0, 0, 2, area, camera)!;
  const b = windowPoint(0, 0, 2.1, area, camera)!;
  const distance = Math.hypot(3, 0.4, 20);
  expect((0.1 / Math.hypot(a.x - b.x, a.y - b.y) / distance) * 1).toBeCloseTo(metresAPixel(camera, 600), 5);
});
