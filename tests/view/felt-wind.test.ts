import { Matrix4 } from 'three';
import { expect, test } from 'vitest';
import { createWindState } from '../../src/core/wind/fade.ts';
import { DEFAULT_GUST, DEFAULT_WAVE, STILL, type Wind } from '../../src/core/wind/wind.ts';
import { FeltWind } from '../../src/view/felt-wind.ts';

const windOf = (amplitude: number): Wind => ({ ...STILL, waves: [{ ...DEFAULT_WAVE, amplitude }] });

/** A wind that has been felt at `time`. */
function felt(time: number): FeltWind {
  const wind = new FeltWind();
  wind.set(windOf(0.05), 0, 0);
  wind.fill(time, createWindState());
  return wind;
}

test('what comes first has always blown, and fades in from nothing', () => {
  const wind = new FeltWind();
  wind.set(windOf(0.05), 3, 2);
  const state = createWindState();
  wind.fill(3, state);
  expect(state.waves[2]).toBeCloseTo(0.05, 6);
});

test('an edit that fades lets the springs swing on; one at once makes the past anew', () => {
  const wind = felt(5);
  const { epoch, revision, past } = wind;
  wind.set(windOf(0.1), 5, 1);
  expect([wind.epoch, wind.revision > revision, wind.past > past]).toEqual([epoch, true, true]);
  wind.set(windOf(0.1), 5.5, 0);
  expect(wind.epoch).not.toBe(epoch);
});

test('a gust that starts later changes nothing of the past', () => {
  const wind = felt(5);
  const { epoch, past, revision } = wind;
  const gust = {
    start: 12,
    x: 0,
    y: 0,
    direction: 0,
    speed: 10,
    amplitude: 0.3,
    rise: 0.5,
    fall: 1,
    width: 0,
    repeat: 0,
  };
  wind.set({ ...windOf(0.05), gusts: [gust] }, 5, 1);
  expect([wind.epoch, wind.past]).toEqual([epoch, past]);
  expect(wind.revision).toBeGreaterThan(revision);
});

test('a tree that is carried along swings on; one that is set down has always stood there', () => {
  const there = new Matrix4().makeTranslation(3, 0, -4);
  const carried = felt(5);
  const { epoch, past, revision } = carried;
  carried.moveTo(there);
  expect(carried.epoch).toBe(epoch);
  expect(carried.past).toBeGreaterThan(past);
  expect(carried.revision).toBeGreaterThan(revision);
  const seen = carried.revision;
  carried.moveTo(there);
  expect(carried.revision).toBe(seen);
  const set = new FeltWind();
  const before = set.epoch;
  set.moveTo(there);
  expect(set.epoch).not.toBe(before);
});

test('a document that is written to after it was set blows as it was', () => {
  const wind = felt(5);
  const document = structuredClone(windOf(0.1));
  wind.set(document, 5, 0);
  const [wave] = document.waves;
  if (wave) wave.amplitude = 9;
  document.waves.push({ ...DEFAULT_WAVE });
  const state = createWindState();
  wind.fill(6, state);
  expect([state.count, state.waves[2]]).toEqual([1, Math.fround(0.1)]);
  // Set again it is another wind, and its past another.
  const { epoch } = wind;
  wind.set(document, 6, 0);
  expect(wind.epoch).not.toBe(epoch);
});

test('a record stays the very one, so that it is sent to the GPU once', () => {
  const record = { name: 'r', step: 1, speed: [1, 2], direction: [0, 0] };
  const wind = felt(5);
  wind.set({ ...windOf(0.1), record }, 5, 0);
  expect(wind.wind.record).toBe(record);
});

test('a gust thrown from 16 m upwind of a tree of 8 m changes nothing of its past; one from within its crown does', () => {
  const thrown = (x: number): boolean => {
    const wind = felt(5);
    wind.reach = 8;
    const { epoch, past } = wind;
    wind.set({ ...windOf(0.05), gusts: [{ ...DEFAULT_GUST, x, start: 5.01 }] }, 5, 0.4);
    return wind.epoch === epoch && wind.past === past;
  };
  expect(thrown(-16)).toBe(true);
  expect(thrown(-6)).toBe(false);
});
