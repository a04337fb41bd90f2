import { describe, expect, test } from 'vitest';
import type { CameraPose } from '../../src/core/link/document.ts';
import { cameraOf } from '../../src/element/element-state.ts';
import { Orbit } from '../../src/element/orbit.ts';

const WHOLE: CameraPose = { azimuth: 10, elevation: 4, distance: 20, target: [0, 5, 0] };

describe('the camera about a tree', () => {
  test('stands where the attribute says, the rest as the whole tree wants it', () => {
    const orbit = new Orbit();
    orbit.wish({ azimuth: 90, polar: 75, distance: null }, false);
    orbit.frame(WHOLE);
    expect(orbit.pose).toEqual({ azimuth: 90, elevation: 15, distance: 20, target: [0, 5, 0] });
    expect(orbit.own).toBeNull();
  });

  test('glides to where a key turns it, and rests there', () => {
    const orbit = new Orbit();
    orbit.frame(WHOLE);
    orbit.turn(-30, 0, true);
    expect(orbit.pose.azimuth).toBe(10);
    expect(orbit.step(16)).toBe(true);
    expect(orbit.pose.azimuth).toBeLessThan(10);
    for (let i = 0; i < 100; i++) orbit.step(16);
    expect(orbit.moving).toBe(false);
    expect(orbit.step(16)).toBe(false);
    expect(orbit.pose.azimuth).toBe(340);
    expect(orbit.own).toMatchObject({ azimuth: 340, distance: 20 });
  });

  test('goes the short way around to where the attribute wants it', () => {
    const orbit = new Orbit();
    orbit.frame(WHOLE);
    orbit.wish({ azimuth: 350, polar: null, distance: null }, true);
    orbit.step(16);
    expect(orbit.pose.azimuth).toBeLessThan(10);
    expect(orbit.pose.azimuth).toBeGreaterThan(0);
  });

  test('keeps within reach, shows as much of another tree, and no less than the ground leaves', () => {
    const orbit = new Orbit();
    orbit.frame(WHOLE);
    orbit.zoom(1e-6, false);
    expect(orbit.pose.distance).toBeCloseTo(1.6, 9);
    orbit.zoom(1e9, false);
    expect(orbit.pose.distance).toBe(50);
    orbit.turn(0, 500, false);
    expect(orbit.pose.elevation).toBe(88);
    orbit.frame({ ...WHOLE, distance: 40, target: [0, 9, 0] });
    expect(orbit.pose).toMatchObject({ distance: 100, target: [0, 9, 0] });
    orbit.turn(0, -500, false);
    orbit.stoppedAt(-3);
    expect(orbit.pose.elevation).toBe(-3);
    expect(orbit.moving).toBe(false);
  });

  test('takes a camera of a state, and nothing that is none', () => {
    const camera = { azimuth: 340, elevation: 4, distance: 20, target: [0, 5, 0] };
    expect(cameraOf(JSON.parse(JSON.stringify(camera)))).toEqual(camera);
    const orbit = new Orbit();
    orbit.place(cameraOf(camera)!);
    orbit.frame(WHOLE);
    expect(orbit.own).toEqual(camera);
    for (const bad of [
      null,
      7,
      {},
      { ...camera, distance: 0 },
      { ...camera, target: [0, 5] },
      { ...camera, azimuth: '1' },
    ])
      expect(cameraOf(bad)).toBeUndefined();
  });
});
