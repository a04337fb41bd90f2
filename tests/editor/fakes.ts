import { decodeLink, type LinkDocument } from '../../src/core/link/link.ts';
import { STILL } from '../../src/core/wind/wind.ts';
import type { Services } from '../../src/editor/doing.ts';
import { firstDocument } from '../../src/editor/first-document.ts';
import type { Preferences } from '../../src/editor/preferences.ts';

const first = (): LinkDocument => firstDocument('auto', false, STILL);

/** What a page would do, done nowhere; `show` takes a document that is to be shown whole. */
export const fakeServices = (show: (document: LinkDocument) => void = () => {}): Services => ({
  now: first,
  first,
  addressOf: () => 'https://example.org/',
  notInLink: () => [],
  read: (link) => decodeLink(link, { defaults: first(), species: ['quaking-aspen', 'black-tupelo'], winds: {} }),
  show,
  when: () => 0,
  thumbnail: async () => null,
  write: async (file) => file,
  pick: async () => null,
  share: async () => {},
  cancelGrowing: () => {},
  copy: async () => {},
  save: () => {},
});

/** As on a first visit. */
export const fakePreferences = (): Preferences => ({
  theme: 'auto',
  quality: 'auto',
  folds: {},
  studioHeight: null,
  growWidth: null,
  exports: {},
  shortcuts: true,
  visited: false,
});
