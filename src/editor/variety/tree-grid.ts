import { html, nothing, type TemplateResult } from 'lit';
import { live } from 'lit/directives/live.js';
import { varietyWords } from '../words/variety.ts';
import type { Portraits, Size } from './portraits.ts';
import { treePicture } from './tree-card.ts';

/** Pixels of a picture in the grid, at twice the density of the page. */
export const CARD: Size = { width: 320, height: 400 };

/** Trees to choose one of. */
export interface TreeGrid {
  readonly name: string;
  readonly legend: string;
  readonly portraits: Portraits;
  /** What each is called, and what it says to those who do not see the picture. */
  readonly captions: readonly { readonly shown: string; readonly spoken: string }[];
  readonly chosen: number | null;
  /** The one that is on the screen behind. */
  readonly now: number | null;
  readonly onChoose: (index: number) => void;
  /** Twice clicked: this one, and nothing more. */
  readonly onTake: () => void;
}

/** Radio buttons as pictures: the arrows go sideways by themselves, up and down by rows. */
export function treeGrid(grid: TreeGrid): TemplateResult {
  const { portraits, captions, chosen, now } = grid;
  return html`<fieldset class="tree-grid"><legend class="spoken">${grid.legend}</legend>
    <div class="cards" @keydown=${byRows}>${portraits.list.map((portrait, i) => {
      const caption = captions[i]!;
      return html`<label class="card" @dblclick=${grid.onTake}>
        <input type="radio" name=${grid.name} value=${i} aria-label=${caption.spoken} .checked=${live(i === chosen)}
          ?disabled=${portrait.failed !== null} @change=${() => grid.onChoose(i)}>
        ${treePicture(portrait, portraits.frame, CARD)}
        <span class="caption"><span>${caption.shown}${i === now ? html` <b>${varietyWords.now}</b>` : nothing}</span>
          <span class="soft">${portrait.height === null ? nothing : varietyWords.metres(portrait.height)}</span></span>
      </label>`;
    })}</div></fieldset>`;
}

/** Up and down by rows, however many columns there are; home and end to the ends. */
function byRows(event: KeyboardEvent): void {
  const cards = event.currentTarget as HTMLElement;
  const inputs = [...cards.querySelectorAll<HTMLInputElement>('input:not(:disabled)')];
  const at = inputs.indexOf(event.target as HTMLInputElement);
  if (at < 0 || event.ctrlKey || event.metaKey || event.altKey) return;
  const columns = getComputedStyle(cards).gridTemplateColumns.split(' ').length;
  const to = { ArrowUp: at - columns, ArrowDown: at + columns, Home: 0, End: inputs.length - 1 }[event.key];
  if (to === undefined) return;
  event.preventDefault();
  const next = inputs[to];
  if (!next) return;
  next.focus();
  next.checked = true;
  next.dispatchEvent(new Event('change', { bubbles: true }));
}
