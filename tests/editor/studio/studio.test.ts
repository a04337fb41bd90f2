import { afterEach, beforeEach, describe, expect, test, vi } from 'vitest';
import type { LinkDocument } from '../../../src/core/link/link.ts';
import { growPacked } from '../../../src/core/pack/grow-packed.ts';
import { windStateAt } from '../../../src/core/wind/fade.ts';
import type { Wind } from '../../../src/core/wind/wind.ts';
import { createDocument } from '../../../src/editor/document-store.ts';
import { firstDocument } from '../../../src/editor/first-document.ts';
import { FeltByProbe } from '../../../src/editor/studio/felt.ts';
import { createStudio, type Studio, type StudioHost } from '../../../src/editor/studio/studio.ts';
import type { Picture } from '../../../src/view/picture/picture.ts';
import { shippedSpecies } from '../../core/pack/shipped-species.ts';
import { GALE } from '../../core/wind/some-winds.ts';
import { fakePreferences } from '../fakes.ts';

const { packed } = growPacked(shippedSpecies('quaking-aspen'), 3, { levels: 2 });
const other = growPacked(shippedSpecies('quaking-aspen'), 4, { levels: 2 }).packed;

/** The studio with a clock that a test sets, frames that it makes, and a GPU that says what it is told to. */
function studioOf(change: Partial<LinkDocument> = {}) {
  const document = createDocument({ ...firstDocument('auto', false, GALE), wind: GALE, ...change });
  const clock = { time: 0 };
  const listeners = new Set<(time: number) => void>();
  const gpu = { piece: null as Float32Array | null };
  const host = {
    document,
    session: undefined as never,
    preferences: { ...fakePreferences(), folds: { studio: true } },
    actions: { time: () => clock.time } as never,
    onFrame: (listener) => {
      listeners.add(listener);
      return () => listeners.delete(listener);
    },
  } satisfies StudioHost as StudioHost;
  const picture = { readPiece: async () => gpu.piece } as unknown as Picture;
  const studio: Studio = createStudio(host, picture);
  const frame = (time = clock.time): void => {
    clock.time = time;
    for (const listener of listeners) listener(time);
  };
  /** Frames without end until the past is there. */
  const settle = (time = clock.time): void => {
    do frame(time);
    while (studio.store.getState().catchingUp !== null);
  };
  return { studio, document, frame, settle, gpu };
}

beforeEach(() => {
  vi.stubGlobal('requestAnimationFrame', () => 1);
});
afterEach(() => {
  vi.unstubAllGlobals();
});

describe('the studio', () => {
  test('puts a probe on the tree, where the document says or else where it is of use', () => {
    const { studio, document } = studioOf();
    expect(studio.store.getState().place).toBeNull();
    studio.setTree(packed);
    expect(studio.store.getState().place?.level).toBe(1);
    document.setState({ probe: 0 });
    expect(studio.store.getState().place).toMatchObject({ piece: 0, level: 0 });
    // A piece that the next tree has not got.
    document.setState({ probe: packed.pieceCount + 5 });
    expect(studio.store.getState().place?.level).toBe(1);
    studio.setTree(other);
    expect(studio.recorder('a')!.probe.chain.crown).toBe(other.crown);
  });

  test('listens while it is open, and rests while it is closed', () => {
    const { studio, settle, frame } = studioOf();
    studio.setTree(packed);
    settle(2);
    expect(studio.recorder('a')!.history.last).toBe(120);
    studio.store.setState({ open: false });
    frame(3);
    expect(studio.recorder('a')!.history.last).toBe(120);
    studio.store.setState({ open: true });
    settle(3);
    expect(studio.recorder('a')!.history.count).toBe(181);
    expect(studio.store.getState().natural).toBeGreaterThan(0);
  });

  test('keeps what was while time runs, and takes the past anew while it stands', () => {
    const { studio, document, settle } = studioOf();
    const along = (): number[] => [...studio.recorder('a')!.history.column('along', 0)];
    studio.setTree(packed);
    settle(2);
    const before = along();
    document.setState({ wind: { ...GALE, strength: 0.3 } });
    settle(2.5);
    expect(along().slice(0, before.length)).toEqual(before);
    document.setState({ paused: true });
    settle(2.5);
    const after = along();
    expect(after).not.toEqual([...before, ...after.slice(before.length)]);
    const fresh = studioOf({ wind: { ...GALE, strength: 0.3 } });
    fresh.studio.setTree(packed);
    fresh.settle(2.5);
    expect(after).toEqual([...fresh.studio.recorder('a')!.history.column('along', 0)]);
  });

  test('has a second probe under the second wind', () => {
    const { studio, document, settle } = studioOf({ paused: true });
    studio.setTree(packed);
    expect(studio.recorder('b')).toBeNull();
    document.setState({ compare: { wind: { ...GALE, strength: 0.5 }, preset: 'own', layout: 'split', at: 0.5 } });
    settle(1);
    const last = (side: 'a' | 'b') => studio.recorder(side)!.history.reading(60)!;
    expect(last('b').fx).toBeCloseTo(last('a').fx / 2, 9);
    document.setState({ blowing: false });
    settle(1);
    expect([last('a').fx, last('b').fx]).toEqual([0, 0]);
    document.setState({ compare: null });
    expect(studio.recorder('b')).toBeNull();
  });

  test('holds the piece of the GPU against its own', async () => {
    const { studio, settle, frame, gpu } = studioOf();
    studio.setTree(packed);
    gpu.piece = new Float32Array(16);
    settle(1);
    const end = studio.recorder('a')!.probe.endAt(1)!;
    gpu.piece.set([end[0] + 0.003, end[1], end[2] - 0.004], 12);
    vi.spyOn(performance, 'now').mockReturnValue(1e9);
    frame(1);
    await vi.waitFor(() => expect(studio.store.getState().trust).not.toBeNull());
    expect(studio.store.getState().trust!.difference).toBeCloseTo(0.005, 6);
    vi.restoreAllMocks();
  });
});

describe('the wind that the probe feels', () => {
  const calm: Wind = { ...GALE, strength: 0.2 };

  test('fades as that of the picture, and does not take a look at the past for a seek', () => {
    const felt = new FeltByProbe(GALE);
    felt.set(calm, 10, 1);
    const middle = felt.at(10.5).waves[2];
    expect(felt.at(3).waves).toEqual(windStateAt(calm, 3).waves);
    expect(felt.at(10.5).waves[2]).toBe(middle);
    expect(middle).not.toBe(windStateAt(calm, 10.5).waves[2]);
  });

  test('has always been the newest once the clock was sought, or time stands', () => {
    const felt = new FeltByProbe(GALE);
    felt.set(calm, 10, 1);
    const { epoch } = felt;
    felt.follow(4);
    expect(felt.epoch).not.toBe(epoch);
    expect(felt.at(10.5).waves).toEqual(windStateAt(calm, 10.5).waves);
    felt.set(GALE, 12, 0);
    expect(felt.at(12.1).waves).toEqual(windStateAt(GALE, 12.1).waves);
  });
});
