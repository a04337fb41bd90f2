import fc from 'fast-check';
import { Vector3 } from 'three';
import { expect, it } from 'vitest';
import { roundCamera } from '../../../src/core/link/link.ts';
import { placeOf, poseOf } from '../../../src/view/picture/camera-pose.ts';

const number = (min: number, max: number) => fc.double({ min, max, noNaN: true });

it('gives a camera back that went through the numbers of a link, to the millimetre and thousandth of a degree', () => {
  fc.assert(
    fc.property(
      number(-40, 40),
      number(-3, 40),
      number(-40, 40),
      fc.tuple(number(-9, 9), number(0, 20), number(-9, 9)),
      (x, y, z, at) => {
        const position = new Vector3(x, y, z);
        const target = new Vector3(...at);
        const distance = position.distanceTo(target);
        fc.pre(distance > 0.5);
        const back = { position: new Vector3(), target: new Vector3() };
        placeOf(roundCamera(poseOf(position, target)), back.position, back.target);
        expect(back.target.distanceTo(target)).toBeLessThan(1e-3);
        expect(back.position.distanceTo(position)).toBeLessThan(2e-3 + distance * 2e-5);
      },
    ),
  );
});

it('looks from +z at azimuth 0 and from +x at 90 degrees', () => {
  const position = new Vector3();
  const target = new Vector3();
  placeOf({ azimuth: 90, elevation: 0, distance: 2, target: [1, 1, 1] }, position, target);
  expect(position.distanceTo(new Vector3(3, 1, 1))).toBeLessThan(1e-12);
  placeOf({ azimuth: 0, elevation: 30, distance: 2, target: [0, 0, 0] }, position, target);
  expect(position.distanceTo(new Vector3(0, 1, Math.sqrt(3)))).toBeLessThan(1e-12);
});
