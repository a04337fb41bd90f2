/** The picture that a link to a page unfolds into; docs/make-cards.ts draws them. */
export interface Card {
  /** Seen from the top of the site. */
  readonly file: string;
  /** What it shows. */
  readonly alt: string;
}

/** Pixels of every card: what the large programs that unfold links ask for. */
export const CARD_WIDTH = 1200;
export const CARD_HEIGHT = 630;

export const CARDS = {
  site: { file: 'cards/site.jpg', alt: 'Windgrove: an oak on a meadow in the evening' },
  forest: { file: 'cards/forest.jpg', alt: 'Autumn aspens on a hillside' },
  learn: { file: 'cards/learn.jpg', alt: 'A bare oak, every branch of it to be seen' },
} as const satisfies Record<string, Card>;

/** The card of a page, by its address seen from the top of the site. */
export function cardOf(page: string): Card {
  if (page.startsWith('learn/')) return CARDS.learn;
  return page === 'forest.html' ? CARDS.forest : CARDS.site;
}
