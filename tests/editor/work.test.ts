import fc from 'fast-check';
import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest';
import { encodeLink, type LinkDocument, roundWind } from '../../src/core/link/link.ts';
import type { Keep } from '../../src/editor/autosave.ts';
import { createDocument } from '../../src/editor/document-store.ts';
import { firstDocument } from '../../src/editor/first-document.ts';
import { keptFile } from '../../src/editor/kept-file.ts';
import { createSession } from '../../src/editor/session.ts';
import { startWork } from '../../src/editor/start-work.ts';
import { Work } from '../../src/editor/work.ts';
import { readWorkspace } from '../../src/editor/workspace.ts';
import { shippedWind } from '../core/wind/shipped-winds.ts';

const breeze = roundWind(shippedWind('breeze'));
const first = firstDocument('auto', true, breeze);
const snapshot = { id: 'a', name: 'One', when: 5, link: 's=quaking-aspen', document: null, thumbnail: null };

/** A browser: what it keeps, which tabs live, and the clock. */
class Browser {
  readonly kept = new Map<string, unknown>();
  readonly living = new Set<string>();
  time = 1000;
  broken: Error | null = null;
  private slots = 0;

  readonly keep: Keep = {
    entries: async () => structuredClone([...this.kept]),
    set: async (key, value) => {
      if (this.broken) throw this.broken;
      this.kept.set(key, structuredClone(value));
    },
    del: async (key) => void this.kept.delete(key),
  };

  /** Opens a tab; `remembered` is the slot that it had before it was loaded again. */
  async open(link: LinkDocument | null = null, remembered: string | null = null) {
    const slots = {
      slot: '',
      remembered: () => remembered,
      living: async () => new Set(this.living),
      claim: async (slot: string): Promise<boolean> => {
        if (this.living.has(slot)) return false;
        this.living.add(slot);
        slots.slot = slot;
        return true;
      },
    };
    const work = new Work(this.keep, slots, () => `new-${++this.slots}`);
    const asked = link ?? first;
    const begin = await work.begin(link, first);
    const document = createDocument(asked);
    const session = createSession();
    const told: string[] = [];
    const actions = {
      notify: (_kind: string, title: string) => void told.push(title),
      newTree: () => {},
      retract: () => {},
    };
    vi.stubGlobal('window', { addEventListener: () => {}, document: { addEventListener: () => {} } });
    startWork(work, begin, { document, session, actions, now: () => document.getState(), link: asked });
    return {
      document,
      session,
      told,
      slot: slots.slot,
      /** Lets time pass until all is written, and a little more. */
      soon: () => vi.advanceTimersByTimeAsync(1000),
      /** However a tab ends. */
      close: () => void this.living.delete(slots.slot),
    };
  }
}

let browser: Browser;

beforeEach(() => {
  vi.useFakeTimers();
  browser = new Browser();
});

afterEach(() => {
  vi.useRealTimers();
  vi.unstubAllGlobals();
});

const wanting = (seed: number): LinkDocument => ({ ...first, seed });

describe('what a browser keeps', () => {
  it('is nothing of who only looks', async () => {
    const tab = await browser.open(wanting(4));
    tab.document.setState({ time: 9, camera: { azimuth: 1, elevation: 2, distance: 3, target: [0, 0, 0] } });
    await tab.soon();
    expect(browser.kept.size).toBe(0);
    expect(tab.told).toEqual([]);
  });

  it('is within a second what was made: document, steps, snapshots, locks, file', async () => {
    const tab = await browser.open();
    tab.document.setState({ seed: 2 });
    tab.document.setState({ seed: 3 });
    tab.document.history.undo();
    tab.session.setState({ snapshots: [snapshot], locks: new Set(['tree.scale']) });
    tab.session.setState({ file: keptFile({ name: 'a.windgrove.json', handle: null }, tab.document, tab.session) });
    await tab.soon();
    tab.close();
    const next = await browser.open();
    expect(next.document.getState()).toEqual(tab.document.getState());
    expect(next.document.history.states).toEqual(tab.document.history.states);
    expect(next.document.history.index).toBe(1);
    expect(next.session.getState()).toMatchObject({
      snapshots: [snapshot],
      locks: new Set(['tree.scale']),
      file: { name: 'a.windgrove.json' },
    });
    expect(next.told).toHaveLength(1);
    expect(next.told[0]).toMatch(/is back$/);
    expect(next.slot).toBe(tab.slot);
    next.document.history.redo();
    expect(next.document.getState().seed).toBe(3);
  });

  it('says whether it could be kept, and tries again', async () => {
    const tab = await browser.open();
    browser.broken = new Error('no room');
    tab.document.setState({ seed: 2 });
    await tab.soon();
    expect(tab.session.getState().saved).toBe('failed');
    browser.broken = null;
    tab.document.setState({ seed: 3 });
    await tab.soon();
    expect(tab.session.getState().saved).toBe('saved');
    expect(browser.kept.size).toBe(1);
  });

  it('works where nothing can be read', async () => {
    browser.keep.entries = () => Promise.reject(new Error('private'));
    const tab = await browser.open();
    expect(tab.document.getState()).toEqual(first);
    browser.keep.entries = () => new Promise(() => {});
    const waiting = browser.open(wanting(3));
    await vi.advanceTimersByTimeAsync(2000);
    expect((await waiting).document.getState().seed).toBe(3);
  });

  it('is not written over by a tab that began before it could be read', async () => {
    const tab = await browser.open(wanting(1));
    tab.document.setState({ seed: 2 });
    await tab.soon();
    tab.close();
    let answer = (): void => {};
    const { entries } = browser.keep;
    browser.keep.entries = () => new Promise((done) => (answer = () => done(entries())));
    const waiting = browser.open(wanting(5), tab.slot);
    await vi.advanceTimersByTimeAsync(2000);
    const late = await waiting;
    answer();
    late.document.setState({ seed: 6 });
    await late.soon();
    expect(late.slot).not.toBe(tab.slot);
    expect(browser.kept.get(tab.slot)).toMatchObject({ document: { seed: 2 } });
    expect(browser.kept.get(late.slot)).toMatchObject({ document: { seed: 6 } });
  });
});

/** A tab that was closed with a tree of this seed, made from the first. */
async function left(seed: number, when = browser.time++) {
  vi.setSystemTime(when);
  const tab = await browser.open(wanting(1000 + seed));
  tab.document.setState({ seed });
  await tab.soon();
  tab.close();
  return tab;
}

describe('a tab begins', () => {
  it('without a link: with the latest work that no living tab has', async () => {
    await left(2);
    await left(3);
    const one = await browser.open();
    const two = await browser.open();
    const three = await browser.open();
    expect([one, two, three].map((tab) => tab.document.getState().seed)).toEqual([3, 2, 1]);
    expect([one, two, three].map((tab) => tab.told.length)).toEqual([1, 1, 0]);
  });

  it('with the link of a work: with that work and its steps, seen as the link says', async () => {
    await left(2);
    await left(3);
    const tab = await browser.open({ ...wanting(2), time: 7, theme: 'dark' });
    expect(tab.document.getState()).toMatchObject({ seed: 2, time: 7, theme: 'dark' });
    expect(tab.document.history.canUndo).toBe(true);
    expect(tab.told).toEqual([]);
  });

  it('with another link: with the link, and the work is a snapshot', async () => {
    await left(2);
    const tab = await browser.open(wanting(9));
    expect(tab.document.getState().seed).toBe(9);
    expect(tab.document.history.canUndo).toBe(false);
    const [before] = tab.session.getState().snapshots;
    expect(before).toMatchObject({ name: 'Before the link', link: encodeLink(wanting(2)) });
    tab.document.setState({ seed: 10 });
    await tab.soon();
    tab.close();
    // The same is not kept twice, and the first work is still there by itself.
    const again = await browser.open({ ...wanting(10) });
    expect(again.session.getState().snapshots).toHaveLength(1);
    expect((await browser.open()).document.getState().seed).toBe(2);
  });

  it('with another link: a state that is a snapshot already is not kept twice', async () => {
    const tab = await browser.open(wanting(5));
    tab.session.setState({ snapshots: [{ ...snapshot, link: encodeLink(wanting(6)) }] });
    tab.document.setState({ seed: 6 });
    await tab.soon();
    tab.close();
    const next = await browser.open(wanting(9));
    expect(next.session.getState().snapshots.map((s) => s.name)).toEqual(['One']);
  });

  it('again, after a crash: with its own work, even where the address is a change ahead', async () => {
    const tab = await browser.open(wanting(5));
    tab.document.setState({ seed: 6 });
    await tab.soon();
    tab.close();
    const same = await browser.open(wanting(6), tab.slot);
    expect(same.document.history.states.map((s) => s.seed)).toEqual([5, 6]);
    same.close();
    const ahead = await browser.open(wanting(7), tab.slot);
    expect(ahead.document.history.states.map((s) => s.seed)).toEqual([5, 6, 7]);
    expect(ahead.document.getState().seed).toBe(7);
  });

  it('again, at once after a change: with the change, though the address is a step behind', async () => {
    const tab = await browser.open(wanting(6));
    for (const seed of [7, 8, 9]) tab.document.setState({ seed });
    tab.document.history.undo();
    await tab.soon();
    tab.close();
    for (const behind of [7, 9]) {
      const again = await browser.open(wanting(behind), tab.slot);
      expect(again.document.getState().seed).toBe(8);
      expect(again.document.history.states.map(({ seed }) => seed)).toEqual([6, 7, 8, 9]);
      again.close();
    }
  });

  it('as a copy of a living tab: with a slot of its own', async () => {
    const tab = await browser.open(wanting(5));
    tab.document.setState({ seed: 6 });
    await tab.soon();
    const copy = await browser.open(wanting(6), tab.slot);
    expect(copy.slot).not.toBe(tab.slot);
    copy.document.setState({ seed: 7 });
    await copy.soon();
    expect(browser.kept.size).toBe(2);
    expect(tab.document.getState().seed).toBe(6);
  });

  it('with five others kept, and no more', async () => {
    for (let seed = 2; seed < 12; seed++) await left(seed);
    const tab = await browser.open();
    await tab.soon();
    expect(tab.document.getState().seed).toBe(11);
    expect(browser.kept.size).toBe(6);
  });

  it('with broken work: as on a first visit, and told once', async () => {
    const tab = await left(2);
    browser.kept.set(tab.slot, { ...(browser.kept.get(tab.slot) as object), document: { seed: 'x' } });
    const next = await browser.open();
    expect(next.document.getState()).toEqual(first);
    expect(next.told).toEqual(['What this browser had kept of your last tree could not be read']);
    next.close();
    expect((await browser.open()).told).toEqual([]);
  });

  it('with broken steps: with the tree alone, and says so', async () => {
    const tab = await left(2);
    browser.kept.set(tab.slot, { ...(browser.kept.get(tab.slot) as object), past: [{ seed: 1 }] });
    const next = await browser.open();
    expect(next.document.getState().seed).toBe(2);
    expect(next.document.history.canUndo).toBe(false);
    expect(next.told).toHaveLength(2);
  });
});

describe('what was kept', () => {
  const whole = {
    version: 1,
    when: 1,
    document: first,
    past: [{ ...first, seed: 2 }],
    future: [],
    files: [],
    snapshots: [snapshot],
    locks: ['tree.scale'],
    file: null,
  };

  it('comes back whole', () => {
    expect(readWorkspace(structuredClone(whole), first)).toEqual({ workspace: whole, cut: false });
  });

  it.each([
    ['another version', { version: 2 }],
    ['no document', { document: null }],
    ['a document without a seed', { document: { ...first, seed: undefined } }],
    ['a wind that is none', { document: { ...first, wind: { ...breeze, waves: 'high' } } }],
    ['an edit that may not be', { document: { ...first, edits: { 'tree.scale': 'tall' } } }],
    ['nothing', undefined],
  ])('%s is not used', (_, change) => {
    expect(readWorkspace(change && { ...whole, ...change }, first)).toBeNull();
  });

  it.each([
    ['a step', { past: [{ ...first, levelsShown: 77 }] }],
    ['all steps', { future: 'none' }],
    ['a lock', { locks: [3] }],
    ['a snapshot', { snapshots: [{ ...snapshot, thumbnail: 'https://example.org/spy.png' }, snapshot] }],
    ['the file', { file: { name: 'x' } }],
  ])('%s that is broken is left out', (_, change) => {
    const read = readWorkspace({ ...whole, ...change }, first)!;
    expect(read.cut).toBe(true);
    expect(read.workspace.document).toEqual(first);
  });

  it('never throws, whatever stands there', () => {
    fc.assert(
      fc.property(fc.constantFrom(...Object.keys(whole)), fc.anything(), (key, value) => {
        readWorkspace({ ...whole, [key]: value }, first);
      }),
      { numRuns: 300 },
    );
    fc.assert(
      fc.property(fc.constantFrom(...Object.keys(first)), fc.anything(), (key, value) => {
        readWorkspace({ ...whole, document: { ...first, [key]: value } }, first);
      }),
      { numRuns: 500 },
    );
  });
});
