import { beforeEach, expect, it, vi } from 'vitest';
import { Loop } from '../../src/editor/loop.ts';
import { Clock } from '../../src/view/clock.ts';

let frames: ((now: number) => void)[];
let clock: Clock;
let draw: ReturnType<typeof vi.fn<(time: number) => void>>;
let moving: boolean;
let loop: Loop;

/** Runs the frames that were asked for, as the browser would. */
function run(now: number): number {
  const asked = frames;
  frames = [];
  for (const frame of asked) frame(now);
  return asked.length;
}

beforeEach(() => {
  frames = [];
  moving = false;
  clock = new Clock();
  draw = vi.fn<(time: number) => void>();
  vi.stubGlobal('requestAnimationFrame', (frame: (now: number) => void) => frames.push(frame));
  loop = new Loop(clock, draw, () => moving);
});

it('draws nothing unasked, and once however often it is asked', () => {
  expect(run(0)).toBe(0);
  loop.invalidate();
  loop.invalidate();
  expect(run(16)).toBe(1);
  expect(run(32)).toBe(0);
  expect(draw).toHaveBeenCalledTimes(1);
  expect(loop.idle).toBe(true);
});

it('draws on while time runs or the camera moves, and rests afterwards', () => {
  clock.play();
  loop.invalidate();
  run(0);
  run(100);
  expect(draw.mock.calls).toEqual([[0], [0.1]]);
  clock.pause();
  moving = true;
  run(200);
  expect(loop.idle).toBe(false);
  moving = false;
  run(300);
  expect(loop.idle).toBe(true);
  expect(draw).toHaveBeenLastCalledWith(0.1);
});

it('tells its listeners the time, until they have heard enough', () => {
  const heard: number[] = [];
  const stop = loop.onFrame((time) => heard.push(time));
  clock.seek(2);
  loop.invalidate();
  run(0);
  stop();
  loop.invalidate();
  run(16);
  expect(heard).toEqual([2]);
});

it('lets time stand and draws nothing while nothing of the picture can be seen', () => {
  let covered = true;
  loop = new Loop(
    clock,
    draw,
    () => moving,
    () => covered,
  );
  clock.play();
  loop.invalidate();
  run(0);
  expect([draw.mock.calls.length, loop.idle]).toEqual([0, true]);
  covered = false;
  loop.invalidate();
  run(5000);
  run(5100);
  expect(draw.mock.calls).toEqual([[0], [0.1]]);
});
