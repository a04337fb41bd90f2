import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { decodeLink, encodeLink } from '../../src/core/link/link.ts';
import { projectText } from '../../src/core/project/project.ts';
import { mayBe, PLACES } from '../../src/core/species/edits.ts';
import { parseSpecies } from '../../src/core/species/parse.ts';
import { STILL } from '../../src/core/wind/wind.ts';
import { windText } from '../../src/core/wind/wind-file.ts';
import { createActions } from '../../src/editor/actions.ts';
import { createDocument } from '../../src/editor/document-store.ts';
import { firstDocument } from '../../src/editor/first-document.ts';
import { createSession, type ShownTree } from '../../src/editor/session.ts';
import { Clock } from '../../src/view/clock.ts';
import { mutatedTexts, unsound } from '../core/file/mutations.ts';
import { folder, names, shipped } from '../core/grow/species.ts';
import { ARBARO, EZ_TREE } from '../core/io/import-samples.ts';
import { fakePreferences, fakeServices } from './fakes.ts';

const first = firstDocument('auto', true, { ...STILL, name: 'Calm' });
const aspen = shipped('quaking-aspen');

/** An editor whose page does nothing; the aspen stands. */
function editor() {
  const document = createDocument(first);
  const tree = { species: aspen, base: aspen, seed: 1 } as unknown as ShownTree;
  const session = createSession({ tree });
  const services = fakeServices((shown) => document.setState(shown));
  return { document, session, actions: createActions(document, session, fakePreferences(), new Clock(), services) };
}

type Editor = ReturnType<typeof editor>;

/** Whatever was done, the state can be shown and sent on, and there is at most one message. */
function sound({ document, session }: Editor): void {
  const state = document.getState();
  expect(unsound(state)).toEqual([]);
  for (const [path, value] of Object.entries(state.edits)) expect(mayBe(path, value), path).toBe(true);
  if (state.ownSpecies !== null) expect(parseSpecies(state.ownSpecies).faults).toBeUndefined();
  // A link says nothing of time that runs: whoever opens it may like it to stand.
  const options = { defaults: { ...first, paused: false }, species: ['quaking-aspen'], winds: {} };
  const back = decodeLink(encodeLink(state), options).document;
  expect({ ...back, wind: 0, compare: 0, preset: 0, species: 0 }).toEqual({
    ...state,
    wind: 0,
    compare: 0,
    preset: 0,
    species: 0,
  });
  expect(session.getState().notices.length).toBeLessThanOrEqual(1);
}

const species = names.map((name) => readFileSync(join(folder, `${name}.json`), 'utf8'));
const project = projectText({
  species: aspen,
  preset: 'quaking-aspen',
  document: {
    ...first,
    edits: { 'tree.scale': 20, 'bark.colour': '#123456', 'wind.stiffness': [1, 2] },
    treeName: 'Mine',
  },
  snapshots: [{ name: 'Before', when: 1e12, link: encodeLink(first) }],
});
const wind = windText({ ...STILL, name: 'Calm' });

/** Files that an editor opens: a line adds a kind. */
const kinds: readonly (readonly [kind: string, file: string, texts: readonly string[], runs: number])[] = [
  ['species', 'tree.json', species, 500],
  ['projects', 'work.windgrove', [project], 500],
  ['winds', 'wind.json', [wind], 200],
  ['trees of Arbaro', 'tree.xml', [ARBARO], 200],
  ['trees of ez-tree', 'tree.json', [JSON.stringify(EZ_TREE)], 200],
];

describe.each(kinds)('mutated files: %s', (_, file, texts, runs) => {
  it(`${runs} are opened, or one message says why not and nothing changes`, async () => {
    await fc.assert(
      fc.asyncProperty(mutatedTexts(texts), async (text) => {
        const page = editor();
        await page.actions.openText(text, file);
        const errors = page.session.getState().notices.filter((n) => n.kind === 'error');
        sound(page);
        if (errors.length > 0) {
          expect(page.document.getState()).toEqual(first);
          expect(errors[0]!.lines.length).toBeGreaterThan(0);
          expect([errors[0]!.title, ...errors[0]!.lines].join()).not.toMatch(
            /[\p{Cc}\u202e]|\[object|undefined is|TypeError/u,
          );
        }
      }),
      { numRuns: runs },
    );
  });

  it('the good ones are opened', async () => {
    for (const text of texts) {
      const page = editor();
      await page.actions.openText(text, file);
      expect(page.session.getState().notices.filter((n) => n.kind === 'error')).toEqual([]);
      sound(page);
    }
  });
});

describe('what a control says', () => {
  const anyPath = fc.oneof(
    fc.constantFrom(...PLACES.keys()),
    fc.constantFrom('__proto__', 'tree', 'levels.9.curve', ''),
    fc.string(),
  );
  const anyValue = fc.oneof(
    fc.double(),
    fc.anything(),
    fc.constantFrom(Number.NaN, 1e300, -0, null, '#abcdef', [], {}),
  );
  const anyDeed = fc.oneof(
    fc.tuple(fc.constant('setParameter' as const), anyPath, anyValue),
    fc.tuple(
      fc.constantFrom('resetParameter' as const, 'toggleLock' as const, 'setName' as const),
      fc.oneof(anyPath, fc.string({ unit: 'binary' })),
    ),
    fc.tuple(fc.constantFrom('setSeed' as const), fc.double()),
    fc.tuple(
      fc.constantFrom(
        'undo' as const,
        'redo' as const,
        'resetAll' as const,
        'holdEdit' as const,
        'releaseEdit' as const,
        'hold' as const,
        'release' as const,
      ),
    ),
    fc.tuple(fc.constant('setSpecies' as const), fc.constantFrom('black-tupelo', 'quaking-aspen')),
  );

  it('400 rows of deeds leave a state that can be sent on, and all of it can be undone', () => {
    fc.assert(
      fc.property(fc.array(anyDeed, { maxLength: 12 }), (deeds) => {
        const page = editor();
        for (const [deed, ...given] of deeds) (page.actions[deed] as (...values: unknown[]) => unknown)(...given);
        sound(page);
        page.actions.release();
        page.actions.goTo(0);
        expect(page.document.getState()).toEqual(first);
      }),
      { numRuns: 400 },
    );
  });
});
