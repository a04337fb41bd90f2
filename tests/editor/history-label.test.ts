import { describe, expect, it, test } from 'vitest';
import { type LinkDocument, roundWind } from '../../src/core/link/link.ts';
import { WAVE_NUMBERS } from '../../src/core/link/numbers.ts';
import { GUST_NUMBERS } from '../../src/core/link/wind-numbers.ts';
import { type Actions, createActions } from '../../src/editor/actions.ts';
import { createDocument } from '../../src/editor/document-store.ts';
import { firstDocument } from '../../src/editor/first-document.ts';
import { changeLabel, type Names } from '../../src/editor/history-label.ts';
import { madeOf } from '../../src/editor/made.ts';
import { createSession, type ShownTree } from '../../src/editor/session.ts';
import { Clock } from '../../src/view/clock.ts';
import { shipped } from '../core/grow/species.ts';
import { shippedWind, windNames } from '../core/wind/shipped-winds.ts';
import { fakePreferences, fakeServices } from './fakes.ts';

const winds = windNames.map((id) => {
  const wind = roundWind(shippedWind(id));
  return { id, name: wind.name, description: '', thumbnail: '', wind };
});
const aspen = shipped('quaking-aspen');
const names: Names = {
  base: ({ species, ownSpecies }) => (ownSpecies === null && species === 'quaking-aspen' ? aspen : null),
  species: ({ species, ownSpecies }) => (ownSpecies === null ? species.replaceAll('-', ' ') : 'own'),
};

const page = () => {
  const document = createDocument(firstDocument('auto', true, winds.find(({ id }) => id === 'breeze')!.wind));
  const tree = { species: aspen, base: aspen, seed: 1 } as unknown as ShownTree;
  const session = createSession({ tree, winds });
  const services = fakeServices((shown: LinkDocument) => document.setState(shown));
  return { document, actions: createActions(document, session, fakePreferences(), new Clock(), services) };
};

/** What the list says of the last thing that is done. */
const said = (...deeds: ((actions: Actions) => unknown)[]): string => {
  const { document, actions } = page();
  for (const deed of deeds) deed(actions);
  const { states } = document.history;
  expect(states).toHaveLength(deeds.length + 1);
  return changeLabel(states.at(-2)!, states.at(-1)!, names);
};

const wave = (key: string) => WAVE_NUMBERS.find((n) => n.key === key)!;
const gust = (key: string) => GUST_NUMBERS.find((n) => n.key === key)!;

describe('the list says what was done', () => {
  test.each<[string, ((actions: Actions) => unknown)[]]>([
    ['Species: black tupelo', [(a) => a.setSpecies('black-tupelo')]],
    ['Species: own', [(a) => a.openSpecies(JSON.stringify(aspen))]],
    ['Seed 7', [(a) => a.setSeed(7)]],
    ['Name: Old one', [(a) => a.setName('Old one')]],
    ['Down angle of limbs 60° → 50°', [(a) => a.setParameter('levels.1.downAngle', 50)]],
    [
      'Down angle of limbs 50° → 60°',
      [(a) => a.setParameter('levels.1.downAngle', 50), (a) => a.resetParameter('levels.1.downAngle')],
    ],
    ['Size 13.0 m → 20.0 m', [(a) => a.setParameter('tree.scale', 20)]],
    ['Bark colour #d9dac6 → #112233', [(a) => a.setParameter('bark.colour', '#112233')]],
    ['2 parameters of limbs', [(a) => a.setParameters({ 'levels.1.downAngle': 50, 'levels.1.curve': 3 })]],
    ['2 parameters', [(a) => a.setParameters({ 'levels.1.downAngle': 50, 'tree.scale': 3 })]],
    [
      'All parameters put back',
      [(a) => a.setParameters({ 'levels.1.downAngle': 50, 'tree.scale': 3 }), (a) => a.resetAll()],
    ],
    [
      'Down angle of limbs 50°',
      [(a) => a.setSpecies('weeping-willow'), (a) => a.setParameter('levels.1.downAngle', 50)],
    ],
    ['Wind: Gale', [(a) => a.setPreset('gale')]],
    ['Wind: Gale', [(a) => a.setBlowing(false), (a) => a.setPreset('gale')]],
    ['Wind off', [(a) => a.setBlowing(false)]],
    ['Strength of the wind 0.50', [(a) => a.setStrength(0.5)]],
    ['Direction of the wind', [(a) => a.turnWind(2)]],
    ['Direction and strength of the wind', [(a) => a.turnWind(2, 0.5)]],
    ['Wave 2 amplitude', [(a) => a.setWaveNumber(1, wave('amplitude'), 0.3)]],
    [
      // At this time its phase goes along, so that the crests stay where they are.
      'Wave 1 speed',
      [
        (a) => {
          a.seek(100);
          a.setWaveNumber(0, wave('speed'), 9);
        },
      ],
    ],
    ['Wave 3 off', [(a) => a.setWaveOn(2, false)]],
    ['Wave 3 alone', [(a) => a.setWaveSolo(2, true)]],
    ['Wave 5 added', [(a) => a.addWave()]],
    ['Wave 2 added', [(a) => a.copyWave(0)]],
    ['Wave 2 removed', [(a) => a.removeWave(1)]],
    ['Waves in another order', [(a) => a.moveWave(0, 2)]],
    ['Gust added', [(a) => a.throwGust()]],
    ['Gust 1 rise', [(a) => a.throwGust(), (a) => a.setGustNumber(0, gust('rise'), 3)]],
    ['Gust removed', [(a) => a.throwGust(), (a) => a.removeGust(0)]],
    ['Wind: bend', [(a) => a.setModel('sway')]],
    ['Wind: spring damping', [(a) => a.setSpring({ damping: 0.7 })]],
    ['Two winds compared', [(a) => a.startCompare()]],
    ['B: Wind: Gale', [(a) => a.startCompare(), (a) => a.setPreset('gale')]],
    ['A and B swapped', [(a) => a.startCompare(), (a) => a.setPreset('gale'), (a) => a.swapCompare()]],
    ['Line between A and B', [(a) => a.startCompare(), (a) => a.setCompareAt(0.2)]],
    ['Comparison ended', [(a) => a.startCompare(), (a) => a.setCompare(null)]],
    ['View: wireframe', [(a) => a.setView('wireframe')]],
    ['Drawn as far as limbs', [(a) => a.setLevels(2)]],
    ['Leaves off', [(a) => a.setShowLeaves(false)]],
    ['Arrows of the wind on', [(a) => a.setOverlays({ arrows: true })]],
    ['Probe on another branch', [(a) => a.setProbe(4)]],
  ])('%s', (label, deeds) => {
    expect(said(...deeds)).toBe(label);
  });

  it('of several things the first, and how many more', () => {
    const before = madeOf(page().document.getState());
    expect(changeLabel(before, { ...before, seed: 5, view: 'levels', showLeaves: false }, names)).toBe(
      'Seed 5, and 2 more',
    );
    const gale = winds.find(({ id }) => id === 'gale')!.wind;
    expect(changeLabel(before, { ...before, species: 'black-tupelo', preset: 'gale', wind: gale }, names)).toBe(
      'Tree and wind: black tupelo',
    );
  });

  it('never nothing, whatever differs', () => {
    const before = madeOf(page().document.getState());
    for (const key of Object.keys(before) as (keyof typeof before)[]) {
      const after = { ...before, [key]: key === 'wind' ? { ...before.wind, description: 'x' } : before[key] };
      expect(changeLabel(before, after, names)).not.toBe('');
    }
  });
});
