import { PerspectiveCamera, Vector3 } from 'three';
import { describe, expect, it } from 'vitest';
import { ownFocalLength } from '../../src/editor/photo/focal-length.ts';
import { ASPECTS, frameIn } from '../../src/editor/photo/photo-frame.ts';
import { exposureText, NO_SETTINGS, shotOf } from '../../src/editor/photo/photo-settings.ts';
import { exposedLook } from '../../src/view/exposed-look.ts';
import { putOn } from '../../src/view/lens.ts';
import type { Stage } from '../../src/view/stage.ts';
import { lookAt } from '../../src/view/stage-look.ts';

describe('the frame of photo mode', () => {
  it('has its shape, and lies in the window above the bar', () => {
    for (const aspect of ASPECTS) {
      for (const [w, h] of [
        [1280, 760],
        [390, 780],
      ] as const) {
        const { left, top, width, height } = frameIn(w, h, aspect, 120);
        expect(left).toBeGreaterThanOrEqual(16);
        expect(top).toBeGreaterThanOrEqual(16);
        expect(left + width).toBeLessThanOrEqual(w - 15);
        expect(top + height).toBeLessThanOrEqual(h - 119);
        const [a, b] = aspect.split(':').map(Number);
        if (a && b) expect(width / height).toBeCloseTo(a / b, 2);
      }
    }
  });

  it('names the lens by its diagonal: 24 mm of film high is 44.8 mm at 30 degrees', () => {
    expect(ownFocalLength({ width: 900, height: 600 }, 600)).toBeCloseTo(12 / Math.tan(Math.PI / 12), 6);
    // A part of the picture is a longer lens.
    expect(ownFocalLength({ width: 450, height: 300 }, 600)).toBeCloseTo(24 / Math.tan(Math.PI / 12), 6);
  });
});

describe('another lens', () => {
  const target = new Vector3(0, 5, 0);
  const stage = () => {
    const camera = new PerspectiveCamera(30, 1.5, 0.04, 400);
    camera.position.set(4, 1.6, 20);
    camera.lookAt(target);
    return { camera, controls: { target } } as unknown as Stage;
  };
  /** How large a metre across is at the tree. */
  const size = ({ camera }: Stage): number =>
    1 / (Math.tan((camera.fov * Math.PI) / 360) * Math.hypot(camera.position.x, camera.position.z));

  it.each([0.4, 1, 4])('%s times as long leaves the tree as large, and the eye above the ground', (zoom) => {
    const s = stage();
    const before = size(s);
    putOn(s, { zoom, keepsSize: true });
    expect(size(s)).toBeCloseTo(before, 9);
    expect(s.camera.position.y).toBe(1.6);
    s.camera.updateMatrixWorld();
    const middle = target.clone().project(s.camera);
    expect(Math.hypot(middle.x, middle.y)).toBeLessThan(1e-9);
  });

  it('enlarges where the camera stays, and comes off without a trace', () => {
    const s = stage();
    const [before, matrix, place] = [size(s), s.camera.projectionMatrix.toArray(), s.camera.position.toArray()];
    const off = putOn(s, { zoom: 2, keepsSize: false });
    expect(size(s)).toBeCloseTo(2 * before, 9);
    expect(s.camera.position.toArray()).toEqual(place);
    off();
    expect(size(s)).toBe(before);
    expect(s.camera.projectionMatrix.toArray()).toEqual(matrix);
  });
});

describe('exposure', () => {
  it('lights sky and ground by the same steps, up and down, and never beyond the screen', () => {
    const look = lookAt('golden', null, false);
    for (let stops = -3; stops < 3; stops++) {
      const [less, more] = [exposedLook(look, stops), exposedLook(look, stops + 1)];
      expect(more.exposure).toBeCloseTo(2 * less.exposure, 9);
      for (const part of ['zenith', 'middle', 'horizon', 'cloud'] as const) {
        less[part].forEach((c, i) => {
          expect(more[part][i]).toBeGreaterThan(c);
        });
        for (const c of more[part]) expect(c).toBeLessThanOrEqual(1);
      }
    }
    expect(exposedLook(look, 0)).toBe(look);
  });

  it('asks nothing of the stage where nothing is set, and is written as a camera writes it', () => {
    expect(shotOf(NO_SETTINGS, 45)).toBeNull();
    expect(shotOf({ ...NO_SETTINGS, lens: 85 }, 45)).not.toBeNull();
    expect([0, 1.33, -0.67, 3].map(exposureText)).toEqual(['0', '+1.3', '−0.7', '+3']);
  });
});
