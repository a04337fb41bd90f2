import { html, nothing, type TemplateResult } from 'lit';
import type { Species } from '../../core/species/species.ts';
import { speciesPageWords as words } from '../words/species-page.ts';

/** What is measured on grown trees of a species, and who says so. */
export function speciesFacts({ facts, source }: Species): TemplateResult {
  const rows: readonly (readonly [string, string])[] = [
    ...(facts
      ? ([
          [words.kind, words.oneOf[facts.kind]],
          [words.heightOf, words.height(facts.height)],
          [words.spread, words.spreadOf(facts.spread)],
          [words.clear, words.clearOf(facts.clear)],
          [words.range, facts.range],
          [words.measured, facts.source],
        ] as const)
      : []),
    [words.made, source],
  ];
  return html`<dl class="species-facts" aria-label=${words.facts}>${rows.map(([term, says]) =>
    says ? html`<div><dt>${term}</dt><dd>${says}</dd></div>` : nothing,
  )}</dl>`;
}
