import { SITE_PAGES } from '../../site/pages.ts';

/** The other pages of Windgrove: what they are called, what one finds there, and their addresses beside this one. */
export const pageWords = {
  heading: 'Other pages',
  open: (name: string): string => `Open ${name}`,
  kind: 'Page',
  pages: SITE_PAGES.filter(({ id }) => id !== 'editor'),
} as const;
