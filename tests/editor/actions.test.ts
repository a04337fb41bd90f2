import { beforeEach, describe, expect, it } from 'vitest';
import { decodeLink, encodeLink } from '../../src/core/link/link.ts';
import { WAVE_NUMBERS } from '../../src/core/link/numbers.ts';
import { wavesAt, windForce } from '../../src/core/wind/force.ts';
import { presets } from '../../src/core/wind/presets.ts';
import { type Actions, createActions } from '../../src/editor/actions.ts';
import { createDocument, type DocumentStore } from '../../src/editor/document-store.ts';
import { firstDocument } from '../../src/editor/first-document.ts';
import { createSession, type SessionStore } from '../../src/editor/session.ts';
import { Clock } from '../../src/view/clock.ts';

let document: DocumentStore;
let session: SessionStore;
let clock: Clock;
let actions: Actions;

const preferences = () => ({ theme: 'auto' as const, folds: {}, shortcuts: true, visited: false });
const rule = (key: string) => WAVE_NUMBERS.find((n) => n.key === key)!;

beforeEach(() => {
  document = createDocument(firstDocument('auto', false));
  session = createSession();
  clock = new Clock();
  actions = createActions(document, session, preferences(), clock, { share: async () => {}, cancelGrowing: () => {} });
});

describe('actions', () => {
  it('leave a document that its own link gives back, whatever was done', () => {
    actions.seek(12.3456);
    actions.setWaveNumber(1, rule('speed'), 7.777);
    actions.setWaveNumber(2, rule('wavelength'), 3.3333);
    actions.setWaveNumber(3, rule('direction'), 359.97);
    actions.setStrength(0.123456);
    actions.setRate(0.3333);
    actions.setCamera({ azimuth: -17.12345, elevation: 3.00049, distance: 21.99999, target: [0.12345, 5, -1] });
    actions.pause();
    const now = document.getState();
    const options = { defaults: firstDocument('auto', false), species: ['quaking-aspen'], winds: presets };
    expect(decodeLink(encodeLink(now), options)).toEqual({ document: now, faults: [] });
  });

  it('keep the crests where they are when speed or wavelength change while time runs', () => {
    actions.seek(100);
    const force = () => windForce(wavesAt(document.getState().wind, 100), 0, 0);
    const before = force();
    actions.setWaveNumber(0, rule('speed'), 9);
    actions.setWaveNumber(0, rule('wavelength'), 21);
    expect(force()[0]).toBeCloseTo(before[0], 5);
    expect(force()[1]).toBeCloseTo(before[1], 5);
    const later = windForce(wavesAt(document.getState().wind, 101), 0, 0);
    expect(Math.hypot(later[0] - before[0], later[1] - before[1])).toBeGreaterThan(1e-4);
  });

  it('touch no species, seed or camera when the wind changes', () => {
    const before = document.getState();
    actions.setPreset('gale');
    actions.setWaveOn(2, false);
    const now = document.getState();
    expect({ ...now, wind: 0, preset: 0 }).toEqual({ ...before, wind: 0, preset: 0 });
    expect(now.wind.waves[2]!.on).toBe(false);
    expect(before.wind.waves[2]!.on).toBe(true);
  });

  it('step by a sixtieth of a second and stand still then', () => {
    actions.play();
    actions.step(1);
    expect(clock.playing).toBe(false);
    expect(document.getState()).toMatchObject({ paused: true, time: 1 / 60 });
    actions.step(-5);
    expect(document.getState().time).toBe(0);
  });

  it('keep one message about one thing, and take it away', () => {
    actions.notify('error', 'No good', ['first']);
    actions.notify('error', 'No good', ['second']);
    actions.notify('note', 'Other');
    const { notices } = session.getState();
    expect(notices.map((n) => n.lines[0] ?? n.title)).toEqual(['second', 'Other']);
    actions.dismiss(notices[0]!.id);
    expect(session.getState().notices.map((n) => n.title)).toEqual(['Other']);
  });

  it('keep the latest four messages: twenty bad files do not cover the picture', () => {
    for (let i = 0; i < 20; i++) actions.notify('error', `${i}.json was not opened`);
    expect(session.getState().notices.map((n) => n.title)).toEqual(
      [16, 17, 18, 19].map((i) => `${i}.json was not opened`),
    );
  });
});
