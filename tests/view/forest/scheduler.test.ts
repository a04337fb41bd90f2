import { describe, expect, test } from 'vitest';
import { BudgetMeter, FOREST_STEPS } from '../../../src/view/forest/budget.ts';
import { cellGrid, distanceToCell, MIDDLE_CELL, NEAR_CELL } from '../../../src/view/forest/cells.ts';
import { isWanted, NEAR_PIXELS } from '../../../src/view/forest/classes.ts';
import { Stream, type Wish } from '../../../src/view/forest/stream.ts';

const wish = (key: string, urgency: number, inView = true, bytes = 10): Wish => ({ key, urgency, inView, bytes });

describe('what is wanted', () => {
  test('a camera that moves back and forth over a threshold changes nothing once it has been crossed', () => {
    let wanted = false;
    let changes = 0;
    for (let i = 0; i < 200; i++) {
      // An eighth to either side of where it is first asked for.
      const pixels = NEAR_PIXELS * 0.8 * (1 + 0.12 * Math.sin(i));
      const now = isWanted(pixels, NEAR_PIXELS, wanted);
      if (now !== wanted) changes++;
      wanted = now;
    }
    expect(changes).toBe(1);
    expect(isWanted(NEAR_PIXELS * 0.6, NEAR_PIXELS, true)).toBe(false);
  });
});

describe('cells', () => {
  const n = 400;
  const places = {
    count: n,
    x: Float32Array.from({ length: n }, (_, i) => ((i * 37) % 300) - 150),
    y: Float32Array.from({ length: n }, (_, i) => ((i * 91) % 300) - 150),
    z: new Float32Array(n),
    turn: new Float32Array(n),
    species: Uint8Array.from({ length: n }, (_, i) => i % 3),
    variant: new Uint32Array(n),
  };
  const heights = new Float32Array(n).fill(10);
  const near = cellGrid(places, n, heights, 300, NEAR_CELL);
  const middle = cellGrid(places, n, heights, 300, MIDDLE_CELL);

  test('hold every tree once, and nine near ones fill a middle one', () => {
    for (const grid of [near, middle]) {
      const ranks = grid.cells.flatMap(({ bySpecies }) => [...bySpecies.values()].flat());
      expect(ranks.sort((a, b) => a - b)).toEqual(Array.from({ length: n }, (_, i) => i));
    }
    expect(near.origin).toBe(middle.origin);
    expect(near.columns).toBe(3 * middle.columns);
  });

  test('are as far as the nearest place where a tree may stand', () => {
    const cell = near.cells[0]!;
    expect(distanceToCell(cell, NEAR_CELL, cell.x, cell.y, 5)).toBe(0);
    expect(distanceToCell(cell, NEAR_CELL, cell.x + 30 + NEAR_CELL / 2, cell.y, 5)).toBe(30);
    expect(distanceToCell(cell, NEAR_CELL, cell.x, cell.y, 30)).toBe(20);
  });
});

describe('the stream of groves', () => {
  test('grows what is in view first and of that what is missed most, two at a time', () => {
    const stream = new Stream();
    const wishes = [wish('behind', 9, false), wish('far', 1.2), wish('near', 4)];
    expect(stream.plan(wishes, 100).grow).toEqual(['near', 'far']);
    expect(stream.plan(wishes, 100).grow).toEqual([]);
    stream.arrived('near', 10);
    expect(stream.plan(wishes, 100).grow).toEqual(['behind']);
  });

  test('calls off what nobody wants any more', () => {
    const stream = new Stream();
    stream.plan([wish('a', 1)], 100);
    expect(stream.plan([wish('b', 1)], 100)).toEqual({ grow: ['b'], cancel: ['a'], drop: [] });
  });

  test('keeps what was seen until memory asks for it, and then drops what was wanted longest ago', () => {
    const stream = new Stream();
    for (const key of ['a', 'b', 'c']) {
      stream.plan([wish(key, 1)], 30);
      stream.arrived(key, 10);
    }
    expect(stream.plan([], 30).drop).toEqual([]);
    expect(stream.plan([wish('a', 1)], 30).drop).toEqual([]);
    expect(stream.plan([wish('a', 1), wish('d', 2)], 30)).toEqual({ grow: ['d'], cancel: [], drop: ['b'] });
    expect(stream.bytes).toBe(20);
  });

  test('never takes more than memory holds, nor lets two thrash for the same place', () => {
    const stream = new Stream();
    // The guess is too low.
    const wishes = [wish('near', 2, true, 30), wish('next', 1.5, true, 30), wish('small', 1, true, 10)];
    let grown = 0;
    for (let frame = 0; frame < 50; frame++) {
      const { grow } = stream.plan(wishes, 100);
      for (const key of grow) {
        grown++;
        stream.arrived(key, 60);
      }
    }
    expect(grown).toBe(2);
    expect(stream.bytes).toBeLessThanOrEqual(100);
  });
});

describe('the frame budget', () => {
  const look = (meter: BudgetMeter, ms: number, looks = 1): void => {
    for (let i = 0; i < 30 * looks; i++) meter.frame(ms);
  };

  test('gives up one step at a time, in order, down to the last', () => {
    const meter = new BudgetMeter(16);
    const seen = [meter.step];
    for (let i = 0; i < 12; i++) {
      look(meter, 40);
      seen.push(meter.step);
    }
    expect(seen.slice(0, 8)).toEqual([0, 1, 2, 3, 4, 5, 6, 7]);
    expect(meter.step).toBe(FOREST_STEPS.length - 1);
  });

  test('a single slow frame, a page that slept, and a frame time within the budget change nothing', () => {
    const meter = new BudgetMeter(16);
    for (let i = 0; i < 300; i++) meter.frame(i % 10 === 0 ? 400 : 15);
    meter.frame(60_000);
    look(meter, 18, 10);
    expect(meter.step).toBe(0);
  });

  test('a machine that needs seconds for a frame is not kept waiting for thirty of them', () => {
    const meter = new BudgetMeter(16);
    for (let i = 0; i < 1 + 5 * (FOREST_STEPS.length - 1); i++) meter.frame(4000);
    expect(meter.step).toBe(FOREST_STEPS.length - 1);
  });

  test('takes back late, and ever later where that was too much', () => {
    const meter = new BudgetMeter(20);
    look(meter, 50);
    expect(meter.step).toBe(1);
    const waits: number[] = [];
    for (let tries = 0; tries < 3; tries++) {
      let looks = 0;
      while (meter.step === 1) {
        look(meter, 10);
        looks++;
      }
      waits.push(looks);
      look(meter, 50);
    }
    expect(waits).toEqual([4, 8, 16]);
    // Another budget is a new wish.
    meter.budget = 60;
    look(meter, 10, 4);
    expect(meter.step).toBe(0);
  });

  test('a screen of 60 Hz gets its fineness back under a budget of one of its frames', () => {
    const meter = new BudgetMeter(16.7);
    look(meter, 33);
    look(meter, 16.7, 20);
    expect(meter.step).toBe(0);
  });
});
