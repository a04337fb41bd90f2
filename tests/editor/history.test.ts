import fc from 'fast-check';
import { beforeEach, describe, expect, it } from 'vitest';
import { roundWind } from '../../src/core/link/link.ts';
import { createDocument, type DocumentStore } from '../../src/editor/document-store.ts';
import { firstDocument } from '../../src/editor/first-document.ts';
import { KEY_PAUSE, MOST_STEPS } from '../../src/editor/history.ts';
import { madeOf } from '../../src/editor/made.ts';
import { shippedWind } from '../core/wind/shipped-winds.ts';

const breeze = roundWind(shippedWind('breeze'));
const first = () => firstDocument('auto', false, breeze);

let document: DocumentStore;
const seeds = () => document.history.states.map((state) => state.seed);
const seed = (to: number) => document.setState({ seed: to });

beforeEach(() => {
  document = createDocument(first());
});

describe('steps', () => {
  it('are the changes of what is made, not of what is looked at', () => {
    document.setState({ time: 3, paused: true, rate: 0.5, camera: null, theme: 'dark' });
    expect(document.history.canUndo).toBe(false);
    seed(2);
    document.setState({ time: 9 });
    document.history.undo();
    expect(document.getState()).toMatchObject({ seed: 1, time: 9, theme: 'dark' });
    expect(document.history.canRedo).toBe(true);
    document.history.redo();
    expect(document.getState().seed).toBe(2);
  });

  it('are none where nothing differs, whatever objects hold it', () => {
    document.setState({ wind: structuredClone(breeze), edits: {} });
    expect(document.history.canUndo).toBe(false);
  });

  it('drop what could be redone', () => {
    seed(2);
    document.history.undo();
    document.setState({ blowing: false });
    expect(document.history.canRedo).toBe(false);
    expect(document.history.states).toHaveLength(2);
  });

  it(`are the latest ${MOST_STEPS}`, () => {
    for (let i = 2; i < MOST_STEPS + 12; i++) seed(i);
    expect(document.history.states).toHaveLength(MOST_STEPS + 1);
    while (document.history.undo());
    expect(document.getState().seed).toBe(11);
  });

  it('are in order where a listener answers a change with another one', () => {
    document.subscribe((now) => {
      if (now.seed === 2 && now.probe === null) document.setState({ probe: 5 });
    });
    seed(2);
    expect(document.history.states.map((s) => [s.seed, s.probe])).toEqual([
      [1, null],
      [2, 5],
    ]);
    document.history.undo();
    expect(document.getState()).toMatchObject({ seed: 1, probe: null });
    document.history.redo();
    expect(document.getState()).toMatchObject({ seed: 2, probe: 5 });
    expect(document.history.states).toHaveLength(2);
  });
});

describe('what merges', () => {
  it('all between hold and release, and nothing after', () => {
    const { history } = document;
    history.hold();
    for (let i = 2; i < 9; i++) seed(i);
    history.release();
    seed(20);
    seed(21);
    expect(seeds()).toEqual([1, 8, 20, 21]);
  });

  it('a hold that ends where it began is no step, and what could be redone stays', () => {
    const { history } = document;
    seed(2);
    seed(3);
    history.undo();
    history.hold();
    seed(7);
    seed(2);
    history.release();
    expect(seeds()).toEqual([1, 2, 3]);
    expect(history.index).toBe(1);
  });

  it('actions within a hold, and those changes that one action makes', () => {
    const { history } = document;
    history.together(() => {
      seed(2);
      document.setState({ blowing: false });
    });
    expect(history.states).toHaveLength(2);
    history.hold();
    history.together(() => seed(3));
    history.together(() => seed(4));
    history.release();
    history.together(() => seed(5));
    history.together(() => seed(6));
    expect(seeds()).toEqual([1, 2, 4, 5, 6]);
  });

  it('presses of a key on the same values, while they follow soon', () => {
    const { history } = document;
    const press = (at: number, act: () => void) => {
      history.key(at);
      history.together(act);
    };
    press(1000, () => seed(2));
    press(1000 + KEY_PAUSE, () => seed(3));
    press(1000 + 2 * KEY_PAUSE, () => seed(4));
    expect(seeds()).toEqual([1, 4]);
    press(1001 + 3 * KEY_PAUSE, () => seed(5));
    expect(seeds()).toEqual([1, 4, 5]);
    press(1002 + 3 * KEY_PAUSE, () => document.setState({ blowing: false }));
    expect(history.states).toHaveLength(4);
    history.key(null);
    document.setState({ blowing: true });
    expect(history.states).toHaveLength(5);
  });

  it('a press that is held down, however slowly the keyboard repeats it', () => {
    const { history } = document;
    for (let i = 0; i < 5; i++) {
      history.key(i * 2 * KEY_PAUSE, i > 0);
      seed(i + 2);
    }
    expect(seeds()).toEqual([1, 6]);
  });

  it('presses there and back are no step', () => {
    const { history } = document;
    history.key(0);
    seed(2);
    history.key(100);
    seed(1);
    expect(seeds()).toEqual([1]);
  });

  it('nothing over an undo', () => {
    const { history } = document;
    seed(2);
    history.key(0);
    seed(3);
    history.undo();
    history.key(100);
    seed(4);
    expect(seeds()).toEqual([1, 2, 4]);
    history.hold();
    seed(5);
    history.undo();
    seed(6);
    history.release();
    expect(seeds()).toEqual([1, 2, 4, 6]);
  });
});

describe('a tree that does not stand', () => {
  const shown = () => {
    const { species, ownSpecies, edits, seed: of } = first();
    return { species, ownSpecies, edits, seed: of };
  };

  it('takes its step off the history, and what could be redone comes back', () => {
    const { history } = document;
    document.setState({ blowing: false });
    document.setState({ blowing: true });
    history.undo();
    seed(666);
    history.withdraw(shown(), true);
    expect(history.states.map((s) => [s.seed, s.blowing])).toEqual([
      [1, true],
      [1, false],
      [1, true],
    ]);
    expect(history.index).toBe(1);
  });

  it('leaves no step that leads to it, and keeps what was changed meanwhile', () => {
    const { history } = document;
    seed(666);
    document.setState({ blowing: false });
    document.setState({ levelsShown: 2 });
    history.undo();
    history.withdraw(shown(), true);
    expect(history.states.map((s) => [s.seed, s.blowing, s.levelsShown])).toEqual([
      [1, true, 9],
      [1, false, 9],
      [1, false, 2],
    ]);
    expect(history.index).toBe(1);
  });

  it('that was stopped on the way back stays to be tried again', () => {
    const { history } = document;
    document.setState({ seed: 5 });
    seed(6);
    history.undo();
    history.withdraw({ ...shown(), seed: 6 }, false);
    expect(seeds()).toEqual([1, 5, 6]);
    expect(document.getState().seed).toBe(6);
    history.undo();
    history.withdraw({ ...shown(), seed: 6 }, true);
    expect(seeds()).toEqual([1, 6]);
  });
});

describe('the file that a step opened', () => {
  const file = (name: string) => ({ name, handle: null, made: madeOf(first()), snapshots: '' });
  let now: string | undefined;
  const openFile = (before: string, after: string) => {
    seed(document.getState().seed + 1);
    now = after;
    document.history.openedFile(file(before), file(after));
  };

  beforeEach(() => {
    now = undefined;
    document.history.onFile = (opened) => {
      now = opened?.name;
    };
  });

  it('is open again wherever one goes', () => {
    const { history } = document;
    openFile('a', 'b');
    seed(20);
    openFile('b', 'c');
    history.undo();
    expect(now).toBe('b');
    history.goTo(0);
    expect(now).toBe('a');
    history.goTo(3);
    expect(now).toBe('c');
    history.goTo(1);
    expect(now).toBe('b');
    seed(30);
    history.undo();
    history.redo();
    expect(now).toBe('b');
    history.goTo(0);
    expect(now).toBe('a');
    history.replace(structuredClone(history.read()));
    history.redo();
    expect(now).toBe('b');
  });

  it('goes when its step is the oldest that is pushed out', () => {
    openFile('a', 'b');
    for (let i = 3; i < MOST_STEPS + 3; i++) seed(i);
    document.history.goTo(0);
    expect(document.getState().seed).toBe(2);
    expect(now).toBe('b');
  });
});

/** What a reader may do, in any order. */
const deed = fc.oneof(
  fc.record({ kind: fc.constant('set' as const), seed: fc.integer({ min: 1, max: 5 }) }),
  fc.record({ kind: fc.constant('blow' as const), on: fc.boolean() }),
  fc.record({ kind: fc.constant('strength' as const), at: fc.integer({ min: 0, max: 4 }) }),
  fc.record({ kind: fc.constant('edit' as const), angle: fc.integer({ min: 40, max: 43 }) }),
  fc.record({ kind: fc.constantFrom('hold' as const, 'release' as const, 'undo' as const, 'redo' as const) }),
  fc.record({ kind: fc.constant('key' as const), at: fc.option(fc.integer({ min: 0, max: 2000 })) }),
  fc.record({ kind: fc.constant('goTo' as const), index: fc.integer({ min: -1, max: 12 }) }),
);

describe('whatever is done', () => {
  it('undoing all gives the start, redoing all the end, and each state follows from the list', () => {
    fc.assert(
      fc.property(fc.array(deed, { maxLength: 40 }), (deeds) => {
        const doc = createDocument(first());
        const { history } = doc;
        const start = madeOf(doc.getState());
        for (const d of deeds) {
          if (d.kind === 'set') doc.setState({ seed: d.seed });
          else if (d.kind === 'blow') doc.setState({ blowing: d.on });
          else if (d.kind === 'strength') doc.setState({ wind: { ...doc.getState().wind, strength: d.at / 4 } });
          else if (d.kind === 'edit') doc.setState({ edits: { 'levels.1.downAngle': d.angle } });
          else if (d.kind === 'key') history.key(d.at);
          else if (d.kind === 'goTo') history.goTo(d.index);
          else history[d.kind]();
        }
        history.release();
        const end = madeOf(doc.getState());
        const { states } = history;
        // Compared with JSON: the order of keys is the same everywhere.
        const texts = states.map((s) => JSON.stringify(s));
        for (let i = 1; i < texts.length; i++) expect(texts[i]).not.toBe(texts[i - 1]);
        const { index } = history;
        while (history.undo());
        expect(madeOf(doc.getState())).toEqual(start);
        for (let i = 1; history.redo(); i++) expect(JSON.stringify(madeOf(doc.getState()))).toBe(texts[i]);
        history.goTo(index);
        expect(madeOf(doc.getState())).toEqual(end);
      }),
      { numRuns: 300 },
    );
  });

  it('an undo amid a drag that is back where it began only ends it', () => {
    const doc = createDocument(first());
    doc.setState({ seed: 5 });
    doc.history.hold();
    doc.setState({ blowing: false });
    doc.setState({ blowing: true });
    expect(doc.history.undo()).toBe(true);
    expect(doc.getState().seed).toBe(5);
    expect(doc.history.states).toHaveLength(2);
  });
});
