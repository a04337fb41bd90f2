import { describe, expect, test } from 'vitest';
import { allowed, type Control, defaultsOf } from '../../src/learn/controls.ts';
import { pressed } from '../../src/learn/handle.ts';
import { figureNamed, readFigure, writeFigure } from '../../src/learn/permalink.ts';
import { mapPlane, niceStep, ticks } from '../../src/learn/plane-map.ts';

describe('the plane of a figure', () => {
  test('a point goes to its pixel and back, y upwards', () => {
    const map = mapPlane({ x: [-2, 4], y: [0, 3], margin: { left: 40, bottom: 30, top: 10, right: 10 } }, 650, 340);
    expect(map.toPixel(-2, 0)).toEqual([40, 310]);
    expect(map.toPixel(4, 3)).toEqual([640, 10]);
    const [x, y] = map.toWorld(...map.toPixel(1.7, 0.3));
    expect(x).toBeCloseTo(1.7, 12);
    expect(y).toBeCloseTo(0.3, 12);
  });

  test('an equal view grows to fill the stage about its middle', () => {
    const map = mapPlane(
      { x: [-1, 1], y: [0, 2], equal: true, margin: { left: 0, right: 0, top: 0, bottom: 0 } },
      400,
      100,
    );
    expect(map.scaleX).toBe(map.scaleY);
    expect(map.y).toEqual([0, 2]);
    expect(map.x).toEqual([-4, 4]);
  });

  test.each([
    [10, 5, 2],
    [1, 5, 0.2],
    [7, 6, 1],
    [0.03, 6, 0.005],
  ])('a span of %d in about %d parts has the step %d', (span, parts, step) => {
    expect(niceStep(span, parts)).toBeCloseTo(step, 12);
  });

  test('ticks are round numbers inside the range', () => {
    expect(ticks([-0.35, 0.31], 0.1)).toEqual([-0.3, -0.2, -0.1, 0, 0.1, 0.2, 0.3]);
  });
});

describe('the address of a figure', () => {
  const controls: readonly Control[] = [
    { id: 'a', label: 'A', min: 0, max: 2, step: 0.1, value: 1 },
    { id: 'b', label: 'B', options: ['x', 'y'].map((value) => ({ value, label: value })), value: 'x' },
    { id: 'c', label: 'C', value: true },
  ];

  test('says what has changed, and brings it back', () => {
    const hash = writeFigure('fig-1', controls, { a: 1.3, b: 'y', c: false });
    expect(hash).toBe('fig=fig-1&a=1.3&b=y&c=false');
    expect(figureNamed(`#${hash}`)).toBe('fig-1');
    expect(readFigure(`#${hash}`, controls)).toEqual({ a: 1.3, b: 'y', c: false });
    expect(writeFigure('fig-1', controls, defaultsOf(controls))).toBe('fig=fig-1');
  });

  test('what is not allowed is left out or made so', () => {
    expect(readFigure('#fig=f&a=9&b=z&d=1', controls)).toEqual({ a: 2 });
    expect(readFigure('#fig=f&a=abc&c=false', controls)).toEqual({ c: false });
    expect(allowed(controls[0]!, 0.3333)).toBe(0.3);
    expect(allowed(controls[0]!, '')).toBeUndefined();
  });
});

describe('an arrow key on a handle', () => {
  /** A handle on a scale with a step of 15 pixels, up to 300. */
  const scale = (turn?: (steps: number) => void) => {
    let at = 150;
    const move = (x: number): void => {
      at = Math.min(300, Math.round(x / 15) * 15);
    };
    const press = (key: string, times = 1) =>
      pressed({ id: 'h', label: 'H', x: at, y: 0, move, ...(turn && { turn }) }, key, times, () => at);
    return { press, at: () => at };
  };

  test('goes as far as it takes for something to change, and stays at the end', () => {
    const { press, at } = scale();
    expect(press('ArrowRight')).toBe(true);
    expect(at()).toBe(165);
    press('ArrowLeft', 10);
    expect(at()).toBe(120);
    press('ArrowUp');
    expect(at()).toBe(120);
    for (let i = 0; i < 30; i++) press('ArrowRight');
    expect(at()).toBe(300);
    expect(press('Home')).toBe(false);
  });

  test('goes round where the handle does', () => {
    const turns: number[] = [];
    const { press } = scale((steps) => turns.push(steps));
    for (const key of ['ArrowRight', 'ArrowUp', 'ArrowLeft', 'ArrowDown']) press(key, 2);
    expect(turns).toEqual([2, 2, -2, -2]);
  });
});
