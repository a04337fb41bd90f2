const escapes: Readonly<Record<string, string>> = { '&': '&amp;', '<': '&lt;', '>': '&gt;', '"': '&quot;' };

/** A text as it stands in HTML, between tags or in an attribute. */
export const escaped = (text: string): string => text.replace(/[&<>"]/g, (letter) => escapes[letter]!);

/** A heading as part of an address: small letters, digits and hyphens. */
export const anchorOf = (heading: string): string =>
  heading
    .toLowerCase()
    .replace(/<[^>]*>|&[a-z]+;/g, '')
    .replace(/[^\p{L}\p{N}]+/gu, '-')
    .replace(/^-+|-+$/g, '');

/** A table of contents: the headings of a page and their anchors. */
export const contents = (label: string, entries: readonly (readonly [anchor: string, title: string])[]): string =>
  `<nav class="contents" aria-label="${escaped(label)}"><ul>${entries
    .map(([anchor, title]) => `<li><a href="#${anchor}">${escaped(title)}</a></li>`)
    .join('')}</ul></nav>`;
