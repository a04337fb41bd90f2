import { expect, it } from 'vitest';
import type { LinkDocument } from '../../src/core/link/link.ts';
import { STILL } from '../../src/core/wind/wind.ts';
import { createActions } from '../../src/editor/actions.ts';
import { createDocument } from '../../src/editor/document-store.ts';
import { embedSnippet, viewerAddress } from '../../src/editor/embed-snippet.ts';
import { firstDocument } from '../../src/editor/first-document.ts';
import { createSession } from '../../src/editor/session.ts';
import { Clock } from '../../src/view/clock.ts';
import { fakePreferences, fakeServices } from './fakes.ts';

it('is a frame whose address and title are text, whatever stands in them', () => {
  const snippet = embedSnippet('https://example.org/a/index.html#s=oak&called="x"', `"><script>alert('1')</script>`);
  expect(snippet).toBe(
    '<iframe src="https://example.org/a/viewer.html#s=oak&amp;called=%22x%22" title="&quot;&gt;&lt;script&gt;alert(&#39;1&#39;)&lt;/script&gt;"' +
      ' width="640" height="480" loading="lazy" allowfullscreen style="border: 0; max-width: 100%"></iframe>',
  );
});

it.each([
  ['https://example.org/#s=oak&seed=3', 'https://example.org/viewer.html#s=oak&seed=3'],
  ['https://example.org/trees/?x=1#z=ab-_', 'https://example.org/trees/viewer.html#z=ab-_'],
  ['http://127.0.0.1:8080/index.html#own=e30', 'http://127.0.0.1:8080/viewer.html#own=e30'],
])('the frame of %s shows %s', (address, viewer) => expect(viewerAddress(address)).toBe(viewer));

/** The lines of the message that the snippet is copied with. */
async function linesWith(change: Partial<LinkDocument>): Promise<readonly string[]> {
  const now = { ...firstDocument('auto', false, STILL), ...change };
  const session = createSession({});
  const services = { ...fakeServices(), now: () => now };
  await createActions(createDocument(now), session, fakePreferences(), new Clock(), services).copyEmbed();
  return session.getState().notices.at(-1)!.lines;
}

it('says what the frame leaves out, and nothing where it shows all of it', async () => {
  const compare = { wind: STILL, preset: 'still', layout: 'side', split: 0.5 } as unknown as LinkDocument['compare'];
  const overlays = { ...firstDocument('auto', false, STILL).overlays, arrows: true };
  expect(await linesWith({})).toEqual([]);
  expect(await linesWith({ overlays })).toEqual([]);
  expect(await linesWith({ probe: 3 })).toEqual(['It leaves out the probe: it shows one tree in one wind.']);
  expect(await linesWith({ compare, overlays, view: 'control', probe: 0 })).toEqual([
    'It leaves out the second wind, the arrows and the probe: it shows one tree in one wind.',
  ]);
});
