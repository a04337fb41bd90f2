import { expect, it } from 'vitest';
import { embedSnippet, viewerAddress } from '../../src/editor/embed-snippet.ts';

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
