import { html, nothing, type TemplateResult } from 'lit';
import { PLACES, valueAt } from '../../core/species/edits.ts';
import type { Species } from '../../core/species/species.ts';
import { pathsOfSection, SECTIONS } from '../ui/tree/sections.ts';
import { valueText } from '../ui/tree/value-text.ts';
import { speciesPageWords as words } from '../words/species-page.ts';
import { treeWords } from '../words/tree.ts';

/** All numbers of a species, section by section, to be read; what the species says nothing of is left out. */
export function parametersTable(species: Species): TemplateResult {
  return html`<p class="soft">${words.parametersHint}</p>${SECTIONS.map((section) => {
    const rows = pathsOfSection(section).flatMap((path) => {
      const value = valueAt(species, path);
      return value === null ? [] : [{ path, value }];
    });
    if (rows.length === 0) return nothing;
    return html`<table><caption>${treeWords.sections[section.id]}</caption>
      <thead class="spoken"><tr><th scope="col">${words.parameter}</th><th scope="col">${words.value}</th></tr></thead>
      <tbody>${rows.map(({ path, value }) => {
        const { label, symbol } = PLACES.get(path)!.parameter;
        return html`<tr><th scope="row">${label}${symbol ? html` <span class="soft">${symbol}</span>` : nothing}</th><td>${
          /^#[0-9a-f]{6}$/.test(String(value))
            ? html`<span class="swatch" style="background: ${value}"></span>`
            : nothing
        }${valueText(path, value)}</td></tr>`;
      })}</tbody></table>`;
  })}`;
}
