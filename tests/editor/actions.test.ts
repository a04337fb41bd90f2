import { beforeEach, describe, expect, it } from 'vitest';
import { decodeLink, encodeLink, OWN_WIND, roundWind } from '../../src/core/link/link.ts';
import { WAVE_NUMBERS } from '../../src/core/link/numbers.ts';
import { windStateAt } from '../../src/core/wind/fade.ts';
import { windForce } from '../../src/core/wind/force.ts';
import { loopWind } from '../../src/core/wind/loop.ts';
import { MOST_GUSTS, MOST_WAVES } from '../../src/core/wind/wind.ts';
import { windText } from '../../src/core/wind/wind-file.ts';
import { type Actions, createActions } from '../../src/editor/actions.ts';
import { createDocument, type DocumentStore } from '../../src/editor/document-store.ts';
import { firstDocument } from '../../src/editor/first-document.ts';
import { createSession, type SessionStore } from '../../src/editor/session.ts';
import { Clock } from '../../src/view/clock.ts';
import { windDirection } from '../../src/view/wind-direction.ts';
import { shippedWind, windNames } from '../core/wind/shipped-winds.ts';
import { fakePreferences, fakeServices } from './fakes.ts';

const shipped = windNames.map((id) => {
  const wind = roundWind(shippedWind(id));
  return { id, name: wind.name, description: wind.description, thumbnail: '', wind };
});
const winds = Object.fromEntries(shipped.map(({ id, wind }) => [id, wind]));
const first = () => firstDocument('auto', false, winds.breeze!);
const options = { defaults: first(), species: ['quaking-aspen'], winds };

let document: DocumentStore;
let session: SessionStore;
let clock: Clock;
let actions: Actions;
let copied: string;

const rule = (key: string) => WAVE_NUMBERS.find((n) => n.key === key)!;

beforeEach(() => {
  document = createDocument(first());
  session = createSession({ winds: shipped });
  clock = new Clock();
  copied = '';
  actions = createActions(document, session, fakePreferences(), clock, {
    ...fakeServices(),
    copy: async (text) => {
      copied = text;
    },
    save: (_, content) => {
      copied = String(content);
    },
  });
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
    actions.turnWind(2.34567, 0.77777);
    actions.throwGust({ x: 3.33333, y: -7.77777 });
    actions.setSpringLevel(2, { frequency: 1.23456 });
    actions.setProfile({ kind: 'log', height: 0.5, roughness: 3 });
    actions.setZeroMean(true);
    actions.addWave();
    actions.setWaveSolo(4, true);
    actions.startCompare('split');
    actions.setPreset('gale');
    actions.loopEvery(7, loopWind);
    actions.setCompareAt(0.12345);
    actions.setOverlays({ arrows: true, handle: false });
    actions.setProbe(17);
    const now = document.getState();
    expect(decodeLink(encodeLink(now), options)).toEqual({ document: now, faults: [] });
  });

  it('keep the crests where they are when speed or wavelength change while time runs', () => {
    actions.seek(100);
    const force = () => windForce(windStateAt(document.getState().wind, 100), 0, 0, 0);
    const before = force();
    actions.setWaveNumber(0, rule('speed'), 9);
    actions.setWaveNumber(0, rule('wavelength'), 21);
    expect(force()[0]).toBeCloseTo(before[0], 5);
    expect(force()[1]).toBeCloseTo(before[1], 5);
    const later = windForce(windStateAt(document.getState().wind, 101), 0, 0, 0);
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

  it('change B where B is chosen, and A stays', () => {
    const { wind } = document.getState();
    actions.startCompare('side');
    actions.setModel('sway');
    actions.removeWave(0);
    expect(document.getState().wind).toBe(wind);
    expect(document.getState().compare!.wind).toMatchObject({ model: 'sway', waves: wind.waves.slice(1) });
    actions.setSide('A');
    actions.setStrength(0.5);
    expect(document.getState().wind.strength).toBe(0.5);
    expect(document.getState().compare!.wind.strength).toBe(1);
    actions.setSide('B');
    actions.setCompare(null);
    expect(session.getState().side).toBe('A');
  });

  it('turn all waves together, however many small turns a hand makes', () => {
    const before = document.getState().wind;
    const towards = windDirection(before)!;
    for (let i = 1; i <= 500; i++) actions.turnWind(towards + i * 0.0123, 0.5);
    actions.turnWind(towards + 1);
    const { waves, strength } = document.getState().wind;
    expect(strength).toBe(0.5);
    waves.forEach((wave, i) => {
      const turned = wave.direction - before.waves[i]!.direction;
      // A tenth of a degree is what a link keeps.
      expect(Math.abs(Math.sin(turned - 1)), `wave ${i}`).toBeLessThan(0.0018);
      expect(Math.cos(turned - 1)).toBeGreaterThan(0);
      expect({ ...wave, direction: 0 }).toEqual({ ...before.waves[i], direction: 0 });
    });
  });

  it('add, copy, move and remove waves, up to eight', () => {
    actions.setWaveNumber(0, rule('wavelength'), 99);
    actions.moveWave(0, 2);
    expect(document.getState().wind.waves[2]!.wavelength).toBe(99);
    actions.copyWave(2);
    expect(document.getState().wind.waves[3]!.wavelength).toBe(99);
    expect(document.getState().wind.waves[3]!.phase).not.toBe(document.getState().wind.waves[2]!.phase);
    for (let i = 0; i < 9; i++) actions.addWave();
    expect(document.getState().wind.waves).toHaveLength(MOST_WAVES);
    expect(actions.addWave()).toBeNull();
    actions.copyWave(0);
    expect(document.getState().wind.waves).toHaveLength(MOST_WAVES);
    actions.removeWave(2);
    expect(document.getState().wind.waves).toHaveLength(MOST_WAVES - 1);
    expect(document.getState().wind.waves[2]!.wavelength).toBe(99);
  });

  it('throw a gust that starts now, towards the tree, and leaves the past as it was', () => {
    actions.seek(12.345);
    const before = document.getState().wind;
    actions.throwGust({ x: 10, y: 10 });
    const { wind } = document.getState();
    const force = (of: typeof wind, time: number) => windForce(windStateAt(of, time), 5, 5, 6);
    for (const time of [0, 5, 12, clock.time]) expect(force(wind, time)).toEqual(force(before, time));
    expect(force(wind, clock.time + 2)).not.toEqual(force(before, clock.time + 2));
    expect(wind.gusts[0]!.start - clock.time).toBeLessThan(0.011);
    expect(wind.gusts[0]!.direction).toBeCloseTo((225 * Math.PI) / 180, 3);
    expect(session.getState().gust).toBe(0);
    actions.removeGust(0);
    expect(document.getState().wind.gusts).toEqual([]);
    for (let i = 0; i < 20; i++) {
      actions.seek(i);
      actions.throwGust();
    }
    const starts = document.getState().wind.gusts.map((g) => g.start);
    expect(starts).toHaveLength(MOST_GUSTS);
    expect(Math.min(...starts)).toBe(4);
    expect(starts.at(-1)).toBe(19);
  });

  it('copy a wind and paste it again; what is no wind gives one message and changes nothing', async () => {
    actions.setStrength(0.3);
    await actions.copyWind();
    const { wind } = document.getState();
    actions.setPreset('gale');
    expect(actions.pasteWind(copied)).toBe(true);
    expect(document.getState()).toMatchObject({ preset: OWN_WIND, wind });
    session.setState({ notices: [] });
    for (const bad of ['', '{', '[]', '{"format":"windgrove-wind"}', windText(wind).replace('"model"', '"modle"')]) {
      const before = document.getState();
      expect(actions.pasteWind(bad), bad).toBe(false);
      expect(document.getState()).toBe(before);
      expect(session.getState().notices).toHaveLength(1);
      expect(session.getState().notices[0]!.lines.length).toBeGreaterThan(0);
    }
  });

  it('make the wind come around', () => {
    const { open } = actions.loopEvery(6, loopWind);
    expect(open).toEqual([]);
    const { wind } = document.getState();
    const at = (time: number) => windForce(windStateAt(wind, time), 1, 2, 3);
    for (const time of [0, 1.7, 5]) {
      expect(at(time + 6)[0]).toBeCloseTo(at(time)[0], 5);
      expect(at(time + 6)[1]).toBeCloseTo(at(time)[1], 5);
    }
  });

  it('take what the wizard was told, and keep how branches answer', () => {
    actions.setModel('direct');
    actions.useWizard({ beaufort: 9 });
    actions.useWizard({ direction: 1 });
    const { wind, preset } = document.getState();
    expect(preset).toBe(OWN_WIND);
    expect(wind).toMatchObject({ name: 'Beaufort 9', model: 'direct' });
    expect(windDirection(wind)).toBeCloseTo(1, 0);
  });

  it('leave one mode after the other', () => {
    actions.throwGust();
    actions.setThrowing(true);
    expect(actions.leave()).toBe(true);
    expect(session.getState()).toMatchObject({ throwing: false, gust: 0 });
    expect(actions.leave()).toBe(true);
    expect(session.getState().gust).toBeNull();
    expect(actions.leave()).toBe(false);
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
