import { describeWindParameters } from '../core/wind/describe-wind.ts';
import { WIND_PARTS } from '../core/wind/wind-parameters.ts';
import { chapters, finder } from './parameters-page.ts';
import { plainMarkdown } from './plain-markdown.ts';

/** The page of a wind's file: what its numbers mean, every parameter of the table, and measured winds. */
export function windPage(): string {
  const text = describeWindParameters();
  const first = text.indexOf('\n## ');
  const record = text.indexOf('\n## Record');
  // What is said to those who edit the repository is not for the reader of the page.
  const intro = text
    .slice(text.indexOf('\n\n'), first)
    .replace(/Made from the parameter table[^;]*; do not edit by hand\. /, '');
  const parts = Object.values(WIND_PARTS);
  return `${plainMarkdown(intro)}\n${finder(parts)}\n${chapters(parts, new Map())}\n${plainMarkdown(text.slice(record))}`;
}
