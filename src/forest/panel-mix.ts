import { html, nothing, type TemplateResult } from 'lit';
import { live } from 'lit/directives/live.js';
import { MOST_SPECIES } from '../core/forest/forest-numbers.ts';
import { slider } from './slider.ts';
import type { Sources } from './sources.ts';
import type { Store } from './store.ts';
import { words } from './words.ts';

/** Which species stand in the forest, and how many of each. */
export function mixFields(store: Store, sources: Sources): TemplateResult {
  const { mix } = store.state.document;
  const whole = mix.reduce((sum, { share }) => sum + share, 0);
  const setShare = (species: string, share: number): void => {
    const next = mix.map((entry) => (entry.species === species ? { ...entry, share } : entry));
    if (next.some((entry) => entry.share > 0)) store.edit({ mix: next });
    else store.set({});
  };
  const add = (event: Event): void => {
    const select = event.target as HTMLSelectElement;
    const { value } = select;
    select.value = '';
    if (value) store.edit({ mix: [...mix, { species: value, share: Math.min(1, Math.max(0.1, whole / mix.length)) }] });
  };
  const others = sources.species.filter(({ id }) => !mix.some(({ species }) => species === id));
  return html`
    <div class="mix" role="group" aria-label=${words.mix}>
      ${mix.map(({ species, share }) => {
        const name = sources.nameOf(species);
        return html`<div class="species">
          ${slider({
            label: name,
            min: 0,
            max: 1,
            step: 0.01,
            value: share,
            text: words.percent(share / whole),
            onInput: (value) => setShare(species, value),
          })}
          ${
            mix.length > 1
              ? html`<button class="quiet own" type="button" title=${words.remove(name)} aria-label=${words.remove(name)}
                  ?disabled=${share === whole}
                  @click=${() => store.edit({ mix: mix.filter((entry) => entry.species !== species) })}>×</button>`
              : nothing
          }
        </div>`;
      })}
      ${
        mix.length < MOST_SPECIES
          ? html`<select aria-label=${words.add} .value=${live('')} @change=${add}>
              <option value="">${words.addOption}</option>
              ${others.map(({ id, name }) => html`<option value=${id}>${name}</option>`)}
            </select>`
          : nothing
      }
    </div>`;
}
