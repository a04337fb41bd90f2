import { html, nothing, type TemplateResult } from 'lit';
import type { Season } from '../../core/species/season.ts';
import type { SpeciesEntry } from '../session.ts';
import { pictureOf } from '../species-picture.ts';
import { galleryWords } from '../words/gallery.ts';

/** A species among the others. */
export interface SpeciesCard {
  readonly entry: SpeciesEntry;
  readonly season: Season;
  /** Tab comes to this one; the arrows go on from it. */
  readonly tabbed: boolean;
  /** It grows in the editor now. */
  readonly now: boolean;
  /** It is to be seen alive: a canvas lies over its portrait. */
  readonly live: boolean;
  readonly onOpen: () => void;
  /** A mouse points at it, or does no longer. */
  readonly onPoint: (on: boolean) => void;
}

/** A press that asks the browser for a tab or a window of its own. */
const isOwn = ({ ctrlKey, metaKey, shiftKey, altKey, button }: MouseEvent): boolean =>
  ctrlKey || metaKey || shiftKey || altKey || button !== 0;

export function speciesCard(card: SpeciesCard): TemplateResult {
  const { entry, season, tabbed, now, live, onOpen, onPoint } = card;
  const open = (event: MouseEvent): void => {
    if (isOwn(event)) return;
    event.preventDefault();
    onOpen();
  };
  const point = (on: boolean) => (event: PointerEvent) => {
    if (event.pointerType === 'mouse') onPoint(on);
  };
  return html`<li><a class="species-card" href="#gallery=${entry.id}" data-id=${entry.id} tabindex=${tabbed ? 0 : -1} ?autofocus=${tabbed}
    @click=${open} @pointerenter=${point(true)} @pointerleave=${point(false)}>
    <span class="species-plate">${portrait(entry, season, 'lazy')}${live ? html`<canvas class="glimpse" aria-hidden="true"></canvas>` : nothing}</span>
    <span class="species-name">${entry.name}${now ? html` <span class="species-now">${galleryWords.now}</span>` : nothing}</span>
    <span class="species-line"><i lang="la">${entry.latin}</i>${
      entry.height ? html`<span>${galleryWords.heightShort(entry.height)}</span>` : nothing
    }</span></a></li>`;
}

/** How wide a picture of the grid is. */
const IN_GRID = '(max-width: 340px) 92vw, (max-width: 700px) 46vw, 240px';

/** The still picture of a species, or an empty plate; it says nothing that the name beside it does not. */
export function portrait(
  entry: SpeciesEntry,
  season: Season,
  loading: 'lazy' | 'eager',
  sizes = IN_GRID,
): TemplateResult | typeof nothing {
  const picture = pictureOf(entry, season);
  if (!picture) return nothing;
  return html`<img alt="" src=${picture.src} srcset=${picture.srcset ?? nothing} sizes=${sizes}
    width="480" height="600" loading=${loading} decoding="async">`;
}
