import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { beforeEach, describe, expect, it, vi } from 'vitest';
import { growPacked } from '../../src/core/pack/grow-packed.ts';
import type { Species } from '../../src/core/species/species.ts';
import { STILL } from '../../src/core/wind/wind.ts';
import { type Actions, createActions } from '../../src/editor/actions.ts';
import { createDocument, type DocumentStore } from '../../src/editor/document-store.ts';
import { firstDocument } from '../../src/editor/first-document.ts';
import { Grower } from '../../src/editor/grower.ts';
import { createSession, type SessionStore } from '../../src/editor/session.ts';
import { Clock } from '../../src/view/clock.ts';
import type { GrownTree, GrowSettings } from '../../src/view/picture/grow-tree.ts';
import { folder } from '../core/grow/species.ts';
import { fakePreferences, fakeServices } from './fakes.ts';

/** A tree that somebody asked the worker for. */
interface Asked {
  readonly species: Species;
  readonly seed: number;
  readonly options: GrowSettings & { readonly signal: AbortSignal };
  stand(milliseconds?: number): Promise<void>;
  fail(why: string): Promise<void>;
}

const asked = vi.hoisted(() => [] as Asked[]);

vi.mock('../../src/view/picture/grow-tree.ts', () => ({
  growTree: (species: Species, seed: number, options: Asked['options']) =>
    new Promise<GrownTree>((resolve, reject) => {
      const after = async (act: () => void): Promise<void> => {
        act();
        for (let i = 0; i < 20; i++) await Promise.resolve();
      };
      options.signal.addEventListener('abort', () => reject(new Error('cancelled')));
      asked.push({
        species,
        seed,
        options,
        // As if it had taken so long; a small tree does for all.
        stand: (milliseconds = 20) =>
          after(() => {
            const grown = growPacked(species, seed, { levels: 2 });
            resolve({ ...grown, milliseconds: { grow: milliseconds, fit: 0, pack: 0 } });
          }),
        fail: (why) => after(() => reject(new Error(why))),
      });
    }),
}));

const willow = readFileSync(join(folder, 'weeping-willow.json'), 'utf8');

let document: DocumentStore;
let session: SessionStore;
let actions: Actions;
let grower: Grower;
/** What was put on the screen: scale of the species, colour of its bark, draft or not. */
let drawn: [scale: number, colour: string, draft: boolean][];

const soon = async (): Promise<void> => {
  for (let i = 0; i < 20; i++) await Promise.resolve();
};
const latest = (): Asked => asked.at(-1)!;
const scale = (metres: number): boolean => actions.setParameter('tree.scale', metres);

beforeEach(async () => {
  asked.length = 0;
  drawn = [];
  document = createDocument({ ...firstDocument('auto', true, STILL), ownSpecies: willow });
  session = createSession();
  actions = createActions(document, session, fakePreferences(), new Clock(), {
    ...fakeServices(),
    cancelGrowing: () => grower.cancel(),
  });
  grower = new Grower(document, session, actions, (_, species, draft) =>
    drawn.push([species.tree.scale, species.bark.colour, draft]),
  );
  void grower.grow();
  await soon();
  await latest().stand(800);
  // A second growth says how fast the worker is once it is warm.
  actions.setSeed(5);
  await soon();
  await latest().stand(800);
  asked.length = 0;
  drawn.length = 0;
});

describe('the grower', () => {
  it('grows base and edits, and tells both', async () => {
    expect(scale(17)).toBe(true);
    await soon();
    expect(asked.map((a) => [a.species.tree.scale, a.seed])).toEqual([[17, 5]]);
    expect(grower.current).toBe(false);
    await latest().stand();
    expect(grower.current).toBe(true);
    const { tree, growing } = session.getState();
    expect([tree!.species.tree.scale, tree!.base.tree.scale, tree!.draft, growing]).toEqual([17, 15, false, null]);
    expect(tree!.stems.count).toBeGreaterThan(1);
    expect(drawn.map(([s, , draft]) => [s, draft])).toEqual([[17, false]]);
  });

  it('lets the latest wish win where no hand is on a control', async () => {
    scale(16);
    await soon();
    scale(17);
    await soon();
    expect(asked.map((a) => a.options.signal.aborted)).toEqual([true, false]);
    await asked[0]!.stand();
    expect(drawn).toEqual([]);
    await asked[1]!.stand();
    expect(drawn.map(([s]) => s)).toEqual([17]);
  });

  it('follows a drag with drafts, one at a time, and grows the whole tree when the hand rests', async () => {
    actions.holdEdit();
    for (const metres of [16, 17, 18]) {
      scale(metres);
      await soon();
    }
    // One grows; those in between are left out.
    expect(asked.map((a) => a.species.tree.scale)).toEqual([16]);
    expect(asked[0]!.options).toMatchObject({ leaves: false });
    await asked[0]!.stand(30);
    expect(drawn).toEqual([[16, expect.any(String), true]]);
    expect(session.getState().tree).toMatchObject({ draft: true, figures: { leaves: expect.any(Number) } });
    expect(asked.map((a) => a.species.tree.scale)).toEqual([16, 18]);
    await asked[1]!.stand(30);
    expect(asked).toHaveLength(2);
    expect(grower.current).toBe(false);
    actions.releaseEdit();
    await soon();
    expect(asked).toHaveLength(3);
    expect(asked[2]!.options).not.toHaveProperty('leaves');
    await asked[2]!.stand(800);
    expect(drawn.map(([s, , draft]) => [s, draft])).toEqual([
      [16, true],
      [18, true],
      [18, false],
    ]);
    expect(session.getState().tree!.draft).toBe(false);
    expect(grower.current).toBe(true);
  });

  it('gives up a whole tree for a hand that comes back, and a draft for a hand that went', async () => {
    actions.holdEdit();
    scale(16);
    await soon();
    actions.releaseEdit();
    await soon();
    expect(asked.map((a) => [a.options.signal.aborted, a.options.leaves ?? true])).toEqual([
      [true, false],
      [false, true],
    ]);
    actions.holdEdit();
    scale(17);
    await soon();
    expect(asked.map((a) => a.options.signal.aborted)).toEqual([true, true, false]);
    expect(latest().options.leaves).toBe(false);
  });

  it('grows no draft that lacks what is being changed', async () => {
    actions.holdEdit();
    actions.setParameter('leaves.scale', 0.3);
    await soon();
    expect(latest().options).not.toHaveProperty('levels');
    expect(latest().options).not.toHaveProperty('leaves');
    await latest().stand(30);
    actions.setParameter('levels.3.curve', 33);
    await soon();
    expect(latest().options).not.toHaveProperty('levels');
  });

  it('shows whole trees while a hand drags where they are quick, and settles the last', async () => {
    for (const metres of [15.1, 15.2, 15.3, 15.4, 15.5]) {
      scale(metres);
      await soon();
      await latest().stand(0.5);
    }
    drawn.length = 0;
    asked.length = 0;
    actions.holdEdit();
    scale(16);
    await soon();
    expect(Object.keys(latest().options).sort()).toEqual(['onProgress', 'signal']);
    await latest().stand(0.5);
    actions.releaseEdit();
    await soon();
    expect(asked).toHaveLength(1);
    expect(drawn.map(([s, , draft]) => [s, draft])).toEqual([
      [16, true],
      [16, false],
    ]);
  });

  it('grows nothing for another colour, another name, or for the tree before', async () => {
    actions.setParameter('bark.colour', '#ABCDEF');
    actions.setName('  Mine  ');
    await soon();
    expect(asked).toEqual([]);
    expect(drawn.map(([, colour]) => colour)).toEqual(['#abcdef']);
    expect(session.getState().tree!.species).toMatchObject({ name: 'Mine', bark: { colour: '#abcdef' } });
    expect(grower.current).toBe(true);
    scale(20);
    await soon();
    await latest().stand();
    actions.undo();
    await soon();
    expect(asked).toHaveLength(1);
    expect(drawn.at(-1)![0]).toBe(15);
    expect(grower.current).toBe(true);
  });

  it('shows the species without the edits while it is compared', async () => {
    scale(20);
    actions.setParameter('bark.colour', '#abcdef');
    await soon();
    await latest().stand();
    actions.setPeek(true);
    await soon();
    expect(asked).toHaveLength(1);
    expect(session.getState().tree!.species).toBe(session.getState().tree!.base);
    expect(Object.keys(document.getState().edits)).toHaveLength(2);
    actions.setPeek(false);
    await soon();
    expect(drawn.map(([s, c]) => [s, c === '#abcdef'])).toEqual([
      [20, true],
      [15, false],
      [20, true],
    ]);
    expect(asked).toHaveLength(1);
  });

  it('shows a change that is made while it is compared, and compares no more', async () => {
    scale(20);
    await soon();
    await latest().stand();
    actions.setPeek(true);
    await soon();
    scale(25);
    await soon();
    await latest().stand();
    expect(session.getState().peek).toBe(false);
    expect(drawn.at(-1)![0]).toBe(25);
    actions.setPeek(true);
    actions.undo();
    expect(session.getState().peek).toBe(false);
  });

  it('says why a tree cannot be grown, and goes back to the last whole one, its history too', async () => {
    scale(16);
    await soon();
    await latest().stand();
    scale(17);
    await soon();
    await latest().fail('too many stems');
    expect(session.getState().notices.map((n) => [n.title, n.lines])).toEqual([
      ['This tree could not be grown', ['too many stems']],
    ]);
    expect(document.getState().edits).toEqual({ 'tree.scale': 16 });
    expect(session.getState().tree!.species.tree.scale).toBe(16);
    expect([grower.current, session.getState().growing]).toEqual([true, null]);
    actions.undo();
    expect(document.getState().edits).toEqual({});
    actions.redo();
    expect(document.getState().edits).toEqual({ 'tree.scale': 16 });
  });

  it('goes back from a draft of which the whole tree cannot be grown', async () => {
    actions.holdEdit();
    scale(60);
    await soon();
    await latest().stand(30);
    actions.releaseEdit();
    await soon();
    await latest().fail('too many leaves');
    expect(document.getState().edits).toEqual({});
    expect(grower.current).toBe(true);
    expect(drawn.map(([s, , draft]) => [s, draft])).toEqual([
      [60, true],
      [15, false],
    ]);
  });

  it('keeps the last tree where growing is stopped', async () => {
    scale(16);
    await soon();
    actions.cancelGrowing();
    await soon();
    expect(asked[0]!.options.signal.aborted).toBe(true);
    expect(document.getState().edits).toEqual({});
    expect([grower.current, session.getState().notices]).toEqual([true, []]);
  });

  it('leaves out the edits of a link that cannot be grown: there is a tree, and a message', async () => {
    document = createDocument({
      ...firstDocument('auto', true, STILL),
      ownSpecies: willow,
      edits: { 'levels.1.branches': 100_000 },
    });
    session = createSession();
    actions = createActions(document, session, fakePreferences(), new Clock(), fakeServices());
    grower = new Grower(document, session, actions, () => {});
    void grower.grow();
    await soon();
    await latest().fail('too many stems');
    expect(document.getState().edits).toEqual({});
    await soon();
    await latest().stand();
    expect(grower.current).toBe(true);
    expect(session.getState().notices).toHaveLength(1);
  });

  it('shows the first species where the one that is asked for ships no more, with one message', async () => {
    vi.stubGlobal('document', { baseURI: 'http://localhost/' });
    vi.stubGlobal('fetch', async () => new Response(willow));
    document = createDocument({ ...firstDocument('auto', true, STILL), species: 'gone', edits: { 'tree.scale': 12 } });
    session = createSession({
      species: [{ id: 'weeping-willow', name: 'Weeping Willow', latin: '', file: 'weeping-willow.json' }],
    });
    actions = createActions(document, session, fakePreferences(), new Clock(), fakeServices());
    grower = new Grower(document, session, actions, () => {});
    await grower.grow();
    await vi.waitFor(() => expect(asked).toHaveLength(1));
    await latest().stand();
    expect(grower.current).toBe(true);
    expect(document.getState()).toMatchObject({ species: 'weeping-willow', edits: { 'tree.scale': 12 } });
    expect(session.getState().notices).toHaveLength(1);
    vi.unstubAllGlobals();
  });
});
