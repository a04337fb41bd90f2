/** Pixels of a frame in a page: wide enough for a column of text. */
const WIDTH = 640;
const HEIGHT = 480;

const escapes: Record<string, string> = { '&': '&amp;', '<': '&lt;', '>': '&gt;', '"': '&quot;', "'": '&#39;' };
const escaped = (text: string): string => text.replace(/[&<>"']/g, (letter) => escapes[letter]!);

/** The address of the page that shows nothing but the tree, for a link of the editor: what stands behind `#` says the same to both. */
export function viewerAddress(address: string): string {
  const url = new URL('viewer.html', address);
  url.hash = new URL(address).hash;
  return url.href;
}

/** The HTML that shows an address of the editor in another page; `title` is what screen readers say. */
export const embedSnippet = (address: string, title: string): string =>
  `<iframe src="${escaped(viewerAddress(address))}" title="${escaped(title)}" width="${WIDTH}" height="${HEIGHT}" loading="lazy" allowfullscreen style="border: 0; max-width: 100%"></iframe>`;
