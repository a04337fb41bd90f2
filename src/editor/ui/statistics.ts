import { html, type TemplateResult } from 'lit';
import { statisticsWords as words } from '../words/time.ts';
import { fold } from './fold.ts';
import { Part } from './panel.ts';

const count = new Intl.NumberFormat('en').format;
const milliseconds = (value: number | undefined): string =>
  value && value >= 0.005 ? value.toFixed(value < 10 ? 2 : 0) : '–';

/** What is on the screen, in numbers. */
class Statistics extends Part {
  protected override render(): TemplateResult {
    const { tree, frames } = this.session;
    const rows: readonly (readonly [string, string, string?])[] = [
      [words.height, tree ? tree.figures.height.toFixed(1) : '–', 'm'],
      [words.stems, tree ? count(tree.figures.stems) : '–'],
      [words.pieces, tree ? count(tree.figures.pieces) : '–'],
      [words.leaves, tree ? count(tree.figures.leaves) : '–'],
      [words.triangles, frames ? count(frames.triangles) : '–'],
      [words.drawCalls, frames ? count(frames.drawCalls) : '–'],
      [words.grow, milliseconds(tree?.figures.grow), 'ms'],
      [words.wind, milliseconds(frames?.wind), 'ms'],
      [words.frame, milliseconds(frames?.interval || frames?.draw), 'ms'],
    ];
    const table = html`<dl class="figures">${rows.map(
      ([name, value, unit]) =>
        html`<div><dt>${name}</dt><dd>${value}${unit ? html`<span class="unit">${unit}</span>` : ''}</dd></div>`,
    )}</dl>`;
    return fold(this.editor, 'statistics', words.title, table);
  }
}

customElements.define('wg-statistics', Statistics);
