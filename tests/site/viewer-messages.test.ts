import { expect, it, vi } from 'vitest';
import { answer, type Tree } from '../../src/viewer/answer.ts';
import { CALLS, mayCall, readCall, toldOrigins } from '../../src/viewer/protocol.ts';

const settable = new Set(['season', 'seed', 'paused', 'wind']);

function madeTree(): Tree & { readonly attributes: Map<string, string> } {
  const attributes = new Map<string, string>();
  return {
    attributes,
    play: vi.fn(),
    pause: vi.fn(),
    seek: vi.fn(),
    step: vi.fn(),
    getState: () => ({ seed: 3 }),
    setState: vi.fn(),
    toBlob: async () => new Blob(['x']),
    exportGLB: () => Promise.reject(new Error('There is no tree yet.')),
    setAttribute: (name, value) => void attributes.set(name, value),
    removeAttribute: (name) => void attributes.delete(name),
  };
}
const call = (name: string, ...args: unknown[]) => {
  const read = readCall({ windgrove: 1, id: 7, call: name, args });
  if (!read || 'error' in read) throw new Error('not read');
  return read;
};

it.each([
  [null],
  ['play'],
  [{}],
  [{ windgrove: 2, id: 1, call: 'play' }],
  [{ windgrove: 1, call: 'play' }],
  [{ windgrove: 1, id: {}, call: 'play' }],
  [{ windgrove: 1, id: 1, result: 3 }],
])('does not hear %j', (data) => expect(readCall(data)).toBeNull());

it('answers what is ours and wrong with what there is', () => {
  expect(readCall({ windgrove: 1, id: 'a', call: 'remove' })).toEqual({
    windgrove: 1,
    id: 'a',
    error: `The viewer has no call "remove"; it has ${CALLS.join(', ')}.`,
  });
  expect(readCall({ windgrove: 1, id: 1, call: 'constructor' })).toHaveProperty('error');
  expect(readCall({ windgrove: 1, id: 1, call: 'play', args: 3 })).toHaveProperty('error');
});

it('hears the page around it alone, of the origins that the address names', () => {
  const source = {};
  const message = { source, origin: 'https://a.example' };
  expect(mayCall({ source, origins: [] }, message)).toBe(true);
  expect(mayCall({ source: {}, origins: [] }, message)).toBe(false);
  expect(mayCall({ source: null, origins: [] }, { source: null, origin: 'https://a.example' })).toBe(false);
  expect(mayCall({ source, origins: ['https://b.example'] }, message)).toBe(false);
  expect(toldOrigins({ source, origins: ['https://b.example'] })).toEqual(['https://b.example']);
});

it('does what it is asked and gives the answer with the id of the call', async () => {
  const tree = madeTree();
  expect(await answer(tree, call('seek', 4), settable)).toEqual({ windgrove: 1, id: 7, result: null });
  expect(tree.seek).toHaveBeenCalledWith(4);
  expect(await answer(tree, call('getState'), settable)).toEqual({ windgrove: 1, id: 7, result: { seed: 3 } });
  expect(await answer(tree, call('toBlob'), settable)).toHaveProperty('result', expect.any(Blob));
  await answer(tree, call('set', { season: 'autumn', seed: 4, paused: true, wind: 'gale' }), settable);
  await answer(tree, call('set', { paused: false, wind: null }), settable);
  expect(Object.fromEntries(tree.attributes)).toEqual({ season: 'autumn', seed: '4' });
});

it('answers with what was wrong, and then nothing has been set', async () => {
  const tree = madeTree();
  const errorOf = async (name: string, ...args: unknown[]) =>
    ((await answer(tree, call(name, ...args), settable)) as { error: string }).error;
  expect(await errorOf('seek', 'soon')).toBe('The time has to be a number.');
  expect(await errorOf('set', { season: 'winter', onclick: 'alert(1)' })).toMatch(
    /no attribute onclick; there are season/,
  );
  expect(await errorOf('set', 'season')).toBe('What is set has to be an object.');
  expect(await errorOf('exportGLB')).toBe('There is no tree yet.');
  expect(tree.attributes.size).toBe(0);
});
