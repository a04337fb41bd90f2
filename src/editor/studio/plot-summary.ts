import { html, nothing, type PropertyValues, type TemplateResult } from 'lit';
import { PROBE_RATE, type ProbeHistory } from '../../core/wind/probe-history.ts';
import { summarize } from '../../core/wind/probe-summary.ts';
import { summaryText, trustText } from '../words/probe.ts';
import { studioWords } from '../words/studio.ts';
import { plotWords } from '../words/studio-panels.ts';
import { csvOf, download, type NumberTable } from './csv.ts';
import { spectrumTable, thinned, timeTable } from './plot-tables.ts';
import type { PlotsPanel } from './plots-panel.ts';
import { StudioPart } from './studio-part.ts';
import type { StudioState } from './studio-state.ts';
import { threeDigits } from './units.ts';

/** Milliseconds between two summaries while time runs: a screen reader that is told of each is not talked over. */
const RARELY = 20_000;

/** What the plots show in words, as a table, and as files. */
class PlotSummary extends StudioPart {
  static override properties = { ...StudioPart.properties, panel: { attribute: false }, table: { state: true } };
  declare panel: PlotsPanel;
  /** The table on demand, as it was when it was asked for. */
  declare table: NumberTable | null;
  private text = '';
  private last = Number.NEGATIVE_INFINITY;
  private stop = (): void => {};
  private summed: { history?: ProbeHistory | undefined; key?: string } = {};

  override connectedCallback(): void {
    super.connectedCallback();
    this.stop = this.studio.onReadings(() => this.sumUp(this.doc.paused));
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    this.stop();
  }

  protected override answers(now: StudioState, before: StudioState): boolean {
    if (now.place !== before.place || now.frozen !== before.frozen) this.last = Number.NEGATIVE_INFINITY;
    return now.trust !== before.trust || now.place !== before.place;
  }

  protected override willUpdate(changes: PropertyValues): void {
    super.willUpdate(changes);
    if (this.doc.paused) this.sumUp(true);
  }

  protected override render(): TemplateResult {
    const { table } = this;
    return html`<section class="plot-words" aria-label=${plotWords.summary}>
      <div class="buttons">
        <button type="button" class="quiet" @click=${this.saveTime}>${studioWords.csv}</button>
        <button type="button" class="quiet" @click=${this.saveSpectrum}>${plotWords.spectrumCsv}</button>
        <button type="button" class="quiet" aria-expanded=${Boolean(table)} @click=${this.turnTable}>
          ${table ? plotWords.closeTable : plotWords.table}</button>
      </div>
      <p class="summary-text" aria-live="polite">${this.text || plotWords.listening}</p>
      <p class="trust">${trustText(this.state.trust)}</p>
      ${table ? this.drawTable(table) : nothing}
    </section>`;
  }

  private drawTable({ columns }: NumberTable): TemplateResult {
    const rows = columns[0]?.values.length ?? 0;
    return html`<div class="data-table" tabindex="0" role="region" aria-label=${plotWords.data}>
      <table><caption>${plotWords.caption} <button type="button" class="text"
        @click=${() => this.fillTable()}>${plotWords.anew}</button></caption>
        <thead><tr>${columns.map((c) => html`<th scope="col">${c.name}</th>`)}</tr></thead>
        <tbody>${Array.from(
          { length: rows },
          (_, row) =>
            html`<tr>${columns.map((c, i) =>
              i === 0
                ? html`<th scope="row">${c.values[row]!.toFixed(2)}</th>`
                : html`<td>${threeDigits(c.values[row]!)}</td>`,
            )}</tr>`,
        )}</tbody></table></div>`;
  }

  private sumUp(now: boolean): void {
    const time = performance.now();
    if (!now && time - this.last < RARELY) return;
    const history = this.studio.recorder('a')?.history;
    const key = `${history?.revision}, ${this.state.span}`;
    if (history === this.summed.history && key === this.summed.key) return;
    const summary = history && summarize(history, this.studio.axis(), this.state.span * PROBE_RATE);
    if (!summary || this.state.catchingUp !== null) return;
    this.last = time;
    this.summed = { history, key };
    const text = summaryText(summary, this.state.natural);
    if (text === this.text) return;
    this.text = text;
    this.requestUpdate();
  }

  protected override updated(changes: PropertyValues): void {
    if (changes.has('table') && this.table) this.querySelector('.data-table')?.scrollIntoView({ block: 'nearest' });
  }

  private turnTable(): void {
    if (this.table) this.table = null;
    else this.fillTable();
  }

  private fillTable(): void {
    const { data } = this.panel;
    this.table = data ? thinned(timeTable(data), PROBE_RATE) : null;
  }

  private saveTime(): void {
    const { data } = this.panel;
    if (data) download('windgrove-probe.csv', csvOf(timeTable(data)));
  }

  private saveSpectrum(): void {
    const { spectra } = this.panel;
    if (spectra) download('windgrove-spectrum.csv', csvOf(spectrumTable(spectra)));
  }
}

customElements.define('wg-plot-summary', PlotSummary);
