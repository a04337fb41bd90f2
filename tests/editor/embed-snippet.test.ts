import { expect, it } from 'vitest';
import { embedSnippet } from '../../src/editor/embed-snippet.ts';

it('is a frame whose address and title are text, whatever stands in them', () => {
  const snippet = embedSnippet('https://example.org/#s=oak&called="x"&embed=1', `"><script>alert('1')</script>`);
  expect(snippet).toBe(
    '<iframe src="https://example.org/#s=oak&amp;called=&quot;x&quot;&amp;embed=1" title="&quot;&gt;&lt;script&gt;alert(&#39;1&#39;)&lt;/script&gt;"' +
      ' width="640" height="480" loading="lazy" allowfullscreen style="border: 0; max-width: 100%"></iframe>',
  );
});
