import { describe, expect, test } from 'vitest';
import { PIECE_LAYERS } from '../../src/core/pack/layout.ts';
import { layerStart } from '../../src/core/pack/texel-array.ts';
import { createWindState } from '../../src/core/wind/fade.ts';
import { planeOf, poseOf, poseTreePlainly } from '../../src/core/wind/pose-plainly.ts';
import { syntheticTree } from '../../src/gpu/crosscheck/synthetic-tree.ts';
import { tiledTree } from '../../src/gpu/crosscheck/tiled-tree.ts';
import { timedRounds } from '../../src/gpu/timed-rounds.ts';
import { Measured, type Row } from '../../src/learn/how-fast/measured.ts';
import { ratiosOf, rounds } from '../../src/learn/how-fast/noise.ts';
import { costOf, costThrough, PAPER_FRAMES, PAPER_STEPS, rateAt } from '../../src/learn/how-fast/paper-figures.ts';
import { timeline } from '../../src/learn/how-fast/queue.ts';
import { cellsOf, csvOf } from '../../src/learn/how-fast/rows-text.ts';
import { LONGEST, runAll } from '../../src/learn/how-fast/run-all.ts';

describe("the papers' lines", () => {
  test('go through their points and have the costs that the text quotes', () => {
    const [frames, steps] = [costOf(PAPER_FRAMES), costOf(PAPER_STEPS)];
    expect([frames.start, frames.each]).toEqual([expect.closeTo(0.98, 2), expect.closeTo(196.1, 1)]);
    expect([steps.start, steps.each]).toEqual([expect.closeTo(0.37, 2), expect.closeTo(19.8, 1)]);
    expect(rateAt(frames, 335_000)).toBeCloseTo(15, 9);
    expect(rateAt(frames, 1_000_000)).toBeCloseTo(5.1, 1);
  });

  test('a line is found again from measurements on it; one is too few', () => {
    const line = { start: 0.2, each: 3 };
    const rates = [1e4, 2e5, 1e6].map((size) => ({ size, perSecond: rateAt(line, size) }));
    expect(costThrough(rates)).toEqual({ start: expect.closeTo(0.2, 9), each: expect.closeTo(3, 9) });
    expect(costThrough(rates.slice(1, 2))).toBeNull();
  });
});

describe('a timer', () => {
  test('that waits for nothing sees the handing over, one that waits at the end the work, one that waits each time too much', () => {
    expect(timeline(6, 2, 'none').told).toBeCloseTo(0.8, 9);
    expect(timeline(6, 12, 'none').told).toBeCloseTo(4.6, 1);
    expect(Math.abs(timeline(6, 12, 'end').told / 6 - 1)).toBeLessThan(0.05);
    expect(timeline(6, 12, 'each').told).toBeGreaterThan(8);
  });

  test('in turn, the median of ratios is right where all else is not', () => {
    const [apart, turns] = [ratiosOf(rounds(15, 0.6, false)), ratiosOf(rounds(15, 0.6, true))];
    expect(Math.abs(turns.byRound - 1.5)).toBeLessThan(0.05);
    for (const ratio of Object.values(apart)) expect(Math.abs(ratio - 1.5)).toBeGreaterThan(0.15);
    expect(ratiosOf(rounds(15, 0, false)).means).toBeCloseTo(1.5, 12);
  });
});

describe('measuring', () => {
  const series = (cost: (size: number) => number, log: string[]) => [
    {
      kind: 'frames' as const,
      sizes: [1, 2, 4, 8],
      prepare: (size: number) => {
        log.push(`made ${size}`);
        return Promise.resolve({
          run: () => {},
          done: () => Promise.resolve(),
          dispose: () => log.push(`gone ${size}`),
          cost: cost(size),
        });
      },
    },
  ];
  const time = (work: object) => {
    const median = (work as { cost: number }).cost;
    return Promise.resolve({ median, least: median / 2, rounds: 7, runs: 1 });
  };

  test('leaves out what would take too long, and says how long', async () => {
    const measured = new Measured();
    const log: string[] = [];
    const telling = { doing: () => {}, found: (row: Row) => measured.add(row) };
    await runAll(
      series((size) => size * 0.3 * LONGEST, log),
      telling,
      new AbortController().signal,
      time,
    );
    expect(log).toEqual(['made 1', 'gone 1', 'made 2', 'gone 2']);
    expect(measured.rows.map(({ milliseconds }) => milliseconds)).toEqual([0.3 * LONGEST, 0.6 * LONGEST, null, null]);
    expect(cellsOf(measured.rows[3] as Row, measured.rows)[2]).toContain('2.2 s');
    expect(csvOf(measured.rows, 'a "card"')).toContain('frames,8,,,,"a ""card"""');
  });

  test('stops before the next size when asked to', async () => {
    const stopping = new AbortController();
    const log: string[] = [];
    const telling = { doing: () => {}, found: () => stopping.abort() };
    await expect(
      runAll(
        series(() => 1, log),
        telling,
        stopping.signal,
        time,
      ),
    ).rejects.toThrow();
    expect(log).toEqual(['made 1', 'gone 1']);
  });

  test('a round holds as many runs as fill it, after a warm-up that is not counted', async () => {
    let clock = 0;
    let ran = 0;
    const run = (): void => {
      clock += ran++ === 0 ? 500 : 2;
    };
    const timed = await timedRounds(
      run,
      () => Promise.resolve(),
      { rounds: 3, milliseconds: 100 },
      () => clock,
    );
    expect(timed.median).toBe(2);
    expect(timed.runs * 2).toBeGreaterThanOrEqual(70);
  });

  test('a tiled tree is copies of the tree, each with its own parents', () => {
    const tile = syntheticTree(300, 4);
    const tree = tiledTree(tile, 3);
    expect(tree.pieceCount).toBe(900);
    const pose = new Float32Array(tree.restPose.data);
    poseTreePlainly(tree, createWindState(), 'exact', undefined, pose);
    const attach = layerStart(tree.pieces, PIECE_LAYERS.ATTACH);
    for (let depth = 0; depth < 4; depth++) {
      const [first, end] = [tile.depthStart[depth] as number, tile.depthStart[depth + 1] as number];
      for (let copy = 0; copy < 3; copy++) {
        const at = (tree.depthStart[depth] as number) + copy * (end - first);
        expect(poseOf(pose, planeOf(tree.restPose), at)).toEqual(
          poseOf(tile.restPose.data, planeOf(tile.restPose), first),
        );
        const parent = tree.pieces.data[attach + 4 * at] as number;
        if (depth > 0) expect(parent).toBeGreaterThanOrEqual(tree.depthStart[depth - 1] as number);
        expect(parent).toBeLessThan(tree.depthStart[depth] as number);
      }
    }
  });
});
