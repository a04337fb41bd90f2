import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { beforeEach, describe, expect, it } from 'vitest';
import { decodeLink, encodeLink } from '../../src/core/link/link.ts';
import { STILL } from '../../src/core/wind/wind.ts';
import { type Actions, createActions } from '../../src/editor/actions.ts';
import { createDocument, type DocumentStore } from '../../src/editor/document-store.ts';
import { firstDocument } from '../../src/editor/first-document.ts';
import { createSession, type SessionStore, type ShownTree } from '../../src/editor/session.ts';
import { Clock } from '../../src/view/clock.ts';
import { folder, shipped } from '../core/grow/species.ts';
import { fakePreferences, fakeServices } from './fakes.ts';

const aspen = shipped('quaking-aspen');
const first = () => firstDocument('auto', false, STILL);

let document: DocumentStore;
let session: SessionStore;
let actions: Actions;

beforeEach(() => {
  document = createDocument(first());
  const tree = { species: aspen, base: aspen, source: { species: 'quaking-aspen', ownSpecies: null }, seed: 1 };
  session = createSession({ tree: tree as unknown as ShownTree });
  actions = createActions(document, session, fakePreferences(), new Clock(), fakeServices());
});

const edits = () => document.getState().edits;

describe('what a reader does to the numbers of a species', () => {
  it('is an edit, rounded as a link keeps it; the value of the species is none', () => {
    actions.setProbe(7);
    expect(actions.setParameter('levels.1.downAngle', 45.000000001)).toBe(true);
    expect(document.getState()).toMatchObject({ edits: { 'levels.1.downAngle': 45 }, probe: null });
    actions.setParameter('bark.colour', '#ABCDEF');
    actions.setParameter('tree.crown', [0.5, 1]);
    expect(edits()).toEqual({ 'levels.1.downAngle': 45, 'bark.colour': '#abcdef', 'tree.crown': [0.5, 1] });
    const now = document.getState();
    const options = { defaults: first(), species: ['quaking-aspen'], winds: {} };
    expect(decodeLink(encodeLink(now), options).document.edits).toEqual(now.edits);
    actions.setParameter('levels.1.downAngle', 60);
    actions.setParameter('tree.crown', null);
    expect(edits()).toEqual({ 'bark.colour': '#abcdef' });
  });

  it('is refused where it may not be, and then changes nothing', () => {
    actions.setParameter('tree.scale', 20);
    const before = document.getState();
    for (const [path, value] of [
      ['tree.scale', 1e300],
      ['tree.scale', Number.NaN],
      ['tree.scale', null],
      ['tree.nothing', 1],
      ['__proto__', 1],
      ['bark.colour', 'red'],
      ['wind.stiffness', []],
    ] as const)
      expect(actions.setParameter(path, value), path).toBe(false);
    expect(actions.setParameters({ 'tree.flare': 2, 'tree.scale': -1 })).toBe(false);
    expect(document.getState()).toBe(before);
  });

  it('is set together, and is one step of the history', () => {
    actions.setParameters({ 'tree.scale': 20, 'tree.flare': 2, 'levels.0.curve': 10 });
    expect(Object.keys(edits())).toHaveLength(3);
    actions.undo();
    expect(edits()).toEqual({});
    actions.redo();
    expect(Object.keys(edits())).toHaveLength(3);
  });

  it('goes back one by one, or all but what is locked', () => {
    actions.setParameters({ 'tree.scale': 20, 'tree.flare': 2, 'levels.0.curve': 10 });
    actions.resetParameter('tree.flare');
    expect(Object.keys(edits())).toEqual(['tree.scale', 'levels.0.curve']);
    actions.toggleLock('levels.0.curve');
    actions.resetAll();
    expect(edits()).toEqual({ 'levels.0.curve': 10 });
    actions.resetParameter('levels.0.curve');
    expect(edits()).toEqual({});
    const before = document.getState();
    actions.resetAll();
    actions.resetParameter('tree.scale');
    expect(document.getState()).toBe(before);
  });
});

describe('another species', () => {
  it('begins without edits, name and probe, and keeps what is locked', () => {
    actions.setParameters({ 'tree.scale': 20, 'tree.flare': 2 });
    actions.setName('Mine');
    for (const path of ['tree.scale', 'levels.1.curve', 'no.such']) actions.toggleLock(path);
    actions.setSpecies('black-tupelo');
    expect(document.getState()).toMatchObject({
      species: 'black-tupelo',
      ownSpecies: null,
      treeName: null,
      edits: { 'tree.scale': 20, 'levels.1.curve': -40 },
    });
    // The tupelo has not grown yet: what is locked is what was edited.
    actions.setSpecies('weeping-willow');
    expect(edits()).toEqual({ 'tree.scale': 20, 'levels.1.curve': -40 });
    actions.clearLocks();
    actions.setSpecies('quaking-aspen');
    expect(edits()).toEqual({});
  });

  it('of a file keeps what is locked where it differs', () => {
    actions.toggleLock('tree.scale');
    actions.toggleLock('tree.zScale');
    const text = readFileSync(join(folder, 'black-tupelo.json'), 'utf8');
    actions.openSpecies(text);
    expect(document.getState().ownSpecies).toBe(text);
    expect(edits()).toEqual({ 'tree.scale': 13 });
  });

  it('that has not grown yet takes edits whatever the last one had', () => {
    actions.setSpecies('black-tupelo');
    actions.setParameter('tree.scale', aspen.tree.scale);
    expect(edits()).toEqual({ 'tree.scale': aspen.tree.scale });
  });
});

it('a name is one line, and that of the species is none', () => {
  actions.setName(' My\n\u0000 tree ');
  expect(document.getState().treeName).toBe('My tree');
  actions.setName(aspen.name);
  expect(document.getState().treeName).toBeNull();
  actions.setName('x');
  actions.setName('  ');
  expect(document.getState().treeName).toBeNull();
});
