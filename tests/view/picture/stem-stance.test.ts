import { PerspectiveCamera } from 'three';
import { describe, expect, it } from 'vitest';
import type { Vec3 } from '../../../src/core/math/vec3.ts';
import {
  draggedCurve,
  draggedDown,
  draggedLength,
  handlePlaces,
  type StemView,
  stemStance,
} from '../../../src/view/picture/stem-stance.ts';

/** A straight piece from `a` to `b` with the orientation vector O, as readPiece gives one. */
function piece(a: Vec3, b: Vec3, o: Vec3): number[] {
  return [0, 1, 2, 3].flatMap((k) => [...a.map((x, i) => x + ((b[i]! - x) * k) / 3), o[k] ?? 0]);
}

// A limb of 3 m that leaves a trunk at 2 m of height by 60 degrees, in the plane that the camera sees.
const down = Math.PI / 3;
const base: Vec3 = [0, 0, 2];
const tip: Vec3 = [3 * Math.sin(down), 0, 2 + 3 * Math.cos(down)];
const trunk = piece([0, 0, 0], [0, 0, 4], [1, 0, 0]);
// y of a limb's frame points back up to the parent: at right angles to the limb, in that plane.
const limb = piece(base, tip, [-Math.cos(down), 0, Math.sin(down)]);
const stance = stemStance(
  { base: limb, middle: limb, tip: limb, parent: trunk },
  { middle: { piece: 1, v: 0.55 }, parent: { piece: 0, v: 0.5 } },
);

/** Seen from 20 m in front, the x of tree space to the right. */
function view(azimuth = 0): StemView {
  const camera = new PerspectiveCamera(30, 1.5, 0.1, 100);
  camera.position.set(20 * Math.sin(azimuth), 2.5, 20 * Math.cos(azimuth));
  camera.lookAt(0, 2.5, 0);
  return { camera, area: { left: 40, top: 20, width: 1200, height: 800 } };
}

describe('the handles of a stem', () => {
  it('knows how a stem stands on its parent', () => {
    expect(stance.angle).toBeCloseTo(down, 6);
    stance.base.forEach((x, i) => {
      expect(x).toBeCloseTo(base[i]!, 6);
    });
    // A curve that grows bends it down: away from the y of its frame.
    expect(stance.bend[2]).toBeCloseTo(-Math.sin(down), 6);
  });

  it('stand beyond the tip, past the middle, and on an arc about the base', () => {
    const { length, curve, down: arc } = handlePlaces(stance, view());
    // The limb rises to the right.
    expect(length!.x).toBeGreaterThan(curve!.x + 20);
    expect(length!.y).toBeLessThan(curve!.y - 10);
    expect(arc!.x).toBeLessThan(curve!.x - 20);
  });

  it('leave out the curve of a stem that is short on the screen', () => {
    const far = view();
    far.camera.position.z = 120;
    const places = handlePlaces(stance, far);
    expect(places.curve).toBeNull();
    expect(places.length).not.toBeNull();
  });

  it('make the stem as long as it is dragged, from the front and half from the side', () => {
    for (const azimuth of [0, 0.9]) {
      const seen = view(azimuth);
      const { length } = handlePlaces(stance, seen);
      const longer = handlePlaces(
        { ...stance, tip: [tip[0] * 1.5, 0, 2 + (tip[2] - 2) * 1.5], middle: stance.middle },
        seen,
      ).length!;
      const ratio = draggedLength(stance, seen, longer.x - length!.x, longer.y - length!.y);
      expect(ratio).toBeGreaterThan(1.46);
      expect(ratio).toBeLessThan(1.52);
    }
    expect(draggedLength(stance, view(), 0, 0)).toBe(1);
    expect(draggedLength(stance, view(), -5000, 5000)).toBe(0.05);
  });

  it('open and close the angle to the parent along the arc', () => {
    const seen = view();
    const from = handlePlaces(stance, seen).down!;
    for (const degrees of [20, -25]) {
      const angle = down + (degrees * Math.PI) / 180;
      const to = handlePlaces({ ...stance, angle }, seen).down!;
      expect(draggedDown(stance, seen, to.x - from.x, to.y - from.y, 0)).toBeCloseTo(degrees, 0);
    }
    // Upright is as far as it goes.
    let last = 0;
    for (let k = 1; k <= 8; k++) last = draggedDown(stance, seen, -30 * k, -10, last);
    expect(last).toBeCloseTo(-60, 0);
  });

  it('bend the stem to where its middle is dragged', () => {
    const seen = view();
    const degrees = 30;
    // Where the part f of an evenly curved stem of length L comes to: L c f^2 / 2 aside.
    const aside = (3 * ((degrees * Math.PI) / 180) * 0.55 * 0.55) / 2;
    const from = handlePlaces(stance, seen).curve!;
    const middle = stance.middle.map((x, i) => x + aside * stance.bend[i]!) as Vec3;
    const to = handlePlaces({ ...stance, middle }, seen).curve!;
    expect(draggedCurve(stance, seen, to.x - from.x, to.y - from.y)).toBeCloseTo(degrees, 0);
    expect(draggedCurve(stance, seen, from.x - to.x, from.y - to.y)).toBeCloseTo(-degrees, 0);
  });

  it('do not run away where the stem bends towards the eye', () => {
    const edge = view(Math.PI / 2);
    expect(Math.abs(draggedCurve(stance, edge, 10, 0))).toBeLessThan(40);
  });
});
