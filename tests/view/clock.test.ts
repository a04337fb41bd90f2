import { describe, expect, it } from 'vitest';
import { Clock } from '../../src/view/clock.ts';

describe('clock', () => {
  it('stands still until it plays', () => {
    const clock = new Clock();
    expect(clock.tick(1000)).toBe(0);
    expect([clock.n, clock.time, clock.playing]).toEqual([0, 0, false]);
  });

  it('goes on in whole steps and keeps the rest', () => {
    const clock = new Clock();
    clock.play();
    clock.tick(0);
    let steps = 0;
    for (let i = 1; i <= 100; i++) steps += clock.tick(i * 7);
    expect(steps).toBe(42);
    expect(clock.n).toBe(42);
    expect(clock.time).toBeCloseTo(0.7, 12);
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
    expect(clock.rate).toBe(0);
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
