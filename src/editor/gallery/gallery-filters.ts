import { html, type TemplateResult } from 'lit';
import { live } from 'lit/directives/live.js';
import { SEASONS, type Season } from '../../core/species/season.ts';
import type { SpeciesKind } from '../../core/species/species.ts';
import { choice } from '../ui/choice.ts';
import { icon } from '../ui/icons.ts';
import { galleryWords as words } from '../words/gallery.ts';

/** What of all species is shown, and in which season. */
export interface GalleryFilters {
  readonly query: string;
  readonly kind: SpeciesKind | null;
  readonly kinds: readonly SpeciesKind[];
  readonly season: Season;
  /** Too narrow for radio buttons side by side. */
  readonly narrow: boolean;
  readonly onQuery: (query: string) => void;
  readonly onKind: (kind: SpeciesKind | null) => void;
  readonly onSeason: (season: Season) => void;
  /** The reader goes on into the grid. */
  readonly onDown: () => void;
}

export function galleryFilters(f: GalleryFilters): TemplateResult {
  const kinds = [
    { value: '', label: words.everyKind },
    ...f.kinds.map((kind) => ({ value: kind as string, label: words.kinds[kind] })),
  ];
  const seasons = SEASONS.map((season) => ({ value: season, label: words.seasons[season] }));
  const chooseKind = (value: string): void => f.onKind(f.kinds.find((kind) => kind === value) ?? null);
  return html`<div class="gallery-filters">
    <label class="gallery-search">${icon('find')}<input type="search" placeholder=${words.search} aria-label=${words.searchLabel}
      autocomplete="off" spellcheck="false" .value=${live(f.query)} @input=${(e: Event) => f.onQuery((e.target as HTMLInputElement).value)}
      @keydown=${(e: KeyboardEvent) => {
        if (e.key !== 'ArrowDown' && (e.key !== 'Enter' || e.isComposing)) return;
        e.preventDefault();
        f.onDown();
      }}></label>
    ${
      f.narrow
        ? html`${select(words.kind, f.kind ?? '', kinds, chooseKind)}${select(words.season, f.season, seasons, f.onSeason)}`
        : html`${choice({ name: 'gallery-kind', legend: words.kind, quiet: true, value: f.kind ?? '', options: kinds, onChoose: chooseKind })}
          ${choice({ name: 'gallery-season', legend: words.season, quiet: true, value: f.season, options: seasons, onChoose: f.onSeason })}`
    }</div>`;
}

const select = <T extends string>(
  label: string,
  value: string,
  options: readonly { readonly value: T; readonly label: string }[],
  onChoose: (value: T) => void,
): TemplateResult =>
  html`<select aria-label=${label} .value=${live(value)} @change=${(e: Event) => onChoose((e.target as HTMLSelectElement).value as T)}>${options.map(
    (o) => html`<option value=${o.value} ?selected=${o.value === value}>${o.label}</option>`,
  )}</select>`;
