import { html, type TemplateResult } from 'lit';
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
      ['Height', tree ? tree.figures.height.toFixed(1) : '–', 'm'],
      ['Stems', tree ? count(tree.figures.stems) : '–'],
      ['Pieces', tree ? count(tree.figures.pieces) : '–'],
      ['Leaves', tree ? count(tree.figures.leaves) : '–'],
      ['Triangles', frames ? count(frames.triangles) : '–'],
      ['Draw calls', frames ? count(frames.drawCalls) : '–'],
      ['Grow', milliseconds(tree?.figures.grow), 'ms'],
      ['Wind pass', milliseconds(frames?.wind), 'ms'],
      ['Frame', milliseconds(frames?.interval || frames?.draw), 'ms'],
    ];
    const table = html`<dl class="figures">${rows.map(
      ([name, value, unit]) =>
        html`<div><dt>${name}</dt><dd>${value}${unit ? html`<span class="unit">${unit}</span>` : ''}</dd></div>`,
    )}</dl>`;
    return fold(this.editor, 'statistics', 'Statistics', table);
  }
}

customElements.define('wg-statistics', Statistics);
