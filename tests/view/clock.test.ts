import { describe, expect, it } from 'vitest';
import { Clock } from '../../src/view/clock.ts';

describe('clock', () => {
  it('stands still until it plays', () => {
    const clock = new Clock();
    expect(clock.tick(1000)).toBe(0);
    expect([clock.n, clock.time, clock.playing]).toEqual([0, 0, false]);
  });

  it('counts the steps that it passes, and stands between them while it runs', () => {
    const clock = new Clock();
    clock.play();
    clock.tick(0);
    let steps = 0;
    let before = 0;
    for (let i = 1; i <= 100; i++) {
      steps += clock.tick(i * 7);
      // 144 frames a second, and each a little later than the last: nothing judders.
      expect(clock.time - before).toBeCloseTo(0.007, 6);
      before = clock.time;
    }
    expect(steps).toBe(42);
    expect(clock.n).toBe(42);
    expect(clock.time).toBeCloseTo(0.7, 6);
  });

  it('moves at every frame of slow motion', () => {
    const clock = new Clock();
    clock.rate = 0.1;
    clock.play();
    for (let i = 0; i <= 3; i++) clock.tick((i * 1000) / 60);
    expect(clock.n).toBe(0);
    expect(clock.time).toBeCloseTo(0.3 / 60, 6);
  });

  it('rests on whole steps', () => {
    const clock = new Clock();
    clock.play();
    clock.tick(0);
    clock.tick(30);
    expect(clock.time * 60).toBeCloseTo(1.8, 6);
    clock.pause();
    expect(clock.time * 60).toBe(2);
    clock.play();
    clock.tick(100);
    clock.tick(120);
    clock.seek(1);
    expect(clock.time).toBe(1);
  });

  it('follows its rate', () => {
    const clock = new Clock();
    clock.rate = 0.5;
    clock.play();
    for (let now = 0; now <= 1000; now += 100) clock.tick(now);
    expect(clock.n).toBe(30);
    clock.rate = Number.NaN;
    expect(clock.rate).toBe(1);
    clock.rate = -3;
    expect(clock.rate).toBe(0.1);
    clock.rate = 100;
    expect(clock.rate).toBe(2);
  });

  it('does not leap over a time in which the page slept, nor over a pause', () => {
    const clock = new Clock();
    clock.play();
    clock.tick(0);
    clock.tick(60_000);
    expect(clock.n).toBe(15);
    clock.pause();
    clock.tick(61_000);
    clock.play();
    clock.tick(90_000);
    expect(clock.n).toBe(15);
  });

  it('steps and seeks on the grid, never before 0', () => {
    const clock = new Clock();
    clock.seek(2.51);
    expect(clock.n).toBe(151);
    clock.step(-1);
    expect(clock.n).toBe(150);
    clock.step(-1000);
    expect(clock.n).toBe(0);
    clock.seek(Number.NaN);
    expect(clock.n).toBe(0);
  });
});

it('a time that is no number, or has no end, leaves a clock that goes on', () => {
  const clock = new Clock();
  clock.seek(2);
  clock.step(Number.NaN);
  expect(clock.time).toBe(2);
  clock.seek(Number.POSITIVE_INFINITY);
  expect(Number.isFinite(clock.time)).toBe(true);
  clock.step(-1);
  const before = clock.time;
  clock.step(-1);
  expect(clock.time).toBeLessThan(before);
  clock.seek(Number.NEGATIVE_INFINITY);
  expect(clock.time).toBe(0);
});
