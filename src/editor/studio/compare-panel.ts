import { html, type TemplateResult } from 'lit';
import type { Comparison, Layout } from '../../core/link/link.ts';
import type { Wind } from '../../core/wind/wind.ts';
import { choice } from '../ui/choice.ts';
import { studioWords } from '../words/studio.ts';
import { comparedWords } from '../words/studio-panels.ts';
import { type Compared, compare, comparedTable, differenceOf } from './compare-data.ts';
import { csvOf, download } from './csv.ts';
import { onTheme, plotColours } from './plot-colours.ts';
import { nearest, windowOf } from './plot-data.ts';
import { plotFigure } from './plot-figure.ts';
import { StudioPart } from './studio-part.ts';
import type { StudioState } from './studio-state.ts';
import { type Line, TimePlot } from './time-plot.ts';
import { Turns } from './turns.ts';
import { lengthText, lengthUnit, niceRange } from './units.ts';

const LINES: readonly Line[] = [
  { label: 'A', colour: 'answer', dash: [] },
  { label: 'B', colour: 'answer', dash: [7, 3] },
];
const DIFFERENCE: readonly Line[] = [{ label: comparedWords.less, colour: 'wrong', dash: [2, 2] }];

/** Milliseconds between two words on the difference. */
const WORDS_EVERY = 1000;

/** What a wind is, in a few words. */
const inWords = (wind: Wind): string =>
  comparedWords.wind(wind.name, comparedWords.models[wind.model], wind.pose === 'lagged');

/** Two winds or two models on the same tree and clock, and how far apart they move the probe. */
class ComparePanel extends StudioPart {
  private plots: { both: TimePlot; difference: TimePlot } | null = null;
  private data: Compared | null = null;
  private ends: (() => void)[] = [];
  /** When the difference was put into words last. */
  private worded = 0;
  private readonly turns = new Turns(() => performance.now());
  private readonly sizes = new ResizeObserver(() => this.fit());

  override connectedCallback(): void {
    super.connectedCallback();
    this.ends = [
      onTheme(() => {
        this.drop();
        this.requestUpdate();
      }),
      this.studio.onReadings(() => {
        this.turns.askAll();
        this.turns.run();
      }),
      this.studio.store.subscribe((now, before) => {
        if (now.hover !== before.hover) this.mark();
        const there = before.catchingUp !== null && now.catchingUp === null;
        if (there || now.span !== before.span || now.place !== before.place) this.renew();
      }),
    ];
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    for (const end of this.ends) end();
    this.drop();
    this.studio.store.setState({ hover: null });
  }

  protected override answers(now: StudioState, before: StudioState): boolean {
    return now.place !== before.place || now.span !== before.span;
  }

  protected override render(): TemplateResult {
    const { compare: two } = this.doc;
    return two ? this.compared(two) : this.empty();
  }

  private empty(): TemplateResult {
    const { wind } = this.doc;
    const other = (change: Partial<Wind>) => () => this.start({ ...wind, ...change });
    return html`<div class="studio-empty compare-empty">
      <p>${comparedWords.about}</p>
      <div class="buttons">
        ${
          wind.model === 'spring'
            ? html`<button type="button" class="quiet" @click=${other({ model: 'direct' })}>${comparedWords.springsDirect}</button>`
            : html`<button type="button" class="quiet" @click=${other({ model: 'spring' })}>${wind.model === 'direct' ? comparedWords.directSprings : comparedWords.swaySprings}</button>`
        }
        <button type="button" class="quiet" @click=${other({ pose: wind.pose === 'lagged' ? 'exact' : 'lagged' })}>
          ${wind.pose === 'lagged' ? comparedWords.laggedExact : comparedWords.exactLagged}</button>
        <button type="button" class="quiet" @click=${() => this.editor.actions.startCompare()}>${comparedWords.itself}</button>
      </div></div>`;
  }

  private compared(two: Comparison): TemplateResult {
    const { actions } = this.editor;
    const { winds, side } = this.session;
    return html`<div class="compare-side">
        ${choice({
          name: 'compare-layout',
          legend: comparedWords.layout,
          value: two.layout,
          options: [
            {
              value: 'split' as Layout,
              label: comparedWords.split,
              title: comparedWords.splitTitle,
            },
            { value: 'side' as Layout, label: comparedWords.beside },
          ],
          onChoose: (layout) => actions.setCompare({ ...two, layout }),
        })}
        ${choice({
          name: 'compare-edit',
          legend: comparedWords.edit,
          value: side,
          options: [
            { value: 'A' as const, label: html`<b>A</b>\u2002${inWords(this.doc.wind)}` },
            { value: 'B' as const, label: html`<b>B</b>\u2002${inWords(two.wind)}` },
          ],
          onChoose: (which) => actions.setSide(which),
        })}
        <label class="compare-wind">${comparedWords.isB} <select aria-label=${comparedWords.windB} @change=${(e: Event) => this.choose(two, (e.target as HTMLSelectElement).value)}>
          <option value="" ?selected=${!winds.some((w) => w.id === two.preset && w.wind.name === two.wind.name)}>${comparedWords.own(two.wind.name)}</option>
          ${winds.map((w) => html`<option value=${w.id} ?selected=${w.id === two.preset && w.wind.name === two.wind.name}>${w.name}</option>`)}</select></label>
        <div class="buttons">
          <button type="button" class="quiet" title=${comparedWords.swapTitle} @click=${() => actions.swapCompare()}>${comparedWords.swap}</button>
          <button type="button" class="quiet" title=${comparedWords.copyTitle} @click=${() => actions.setCompare({ ...two, wind: this.doc.wind, preset: this.doc.preset })}>${comparedWords.copy}</button>
          <button type="button" class="quiet" @click=${() => actions.setCompare(null)}>${comparedWords.alone}</button>
        </div>
      </div>
      <div class="compare-plots">
        ${plotFigure('both', comparedWords.both, 'm', LINES)}
        ${plotFigure('difference', comparedWords.difference, 'm', DIFFERENCE, true)}
        <p class="compare-words" aria-live="off"></p>
        <button type="button" class="quiet" @click=${this.save}>${studioWords.csv}</button>
      </div>`;
  }

  protected override updated(): void {
    const host = (id: string): HTMLElement | null => this.querySelector<HTMLElement>(`#${id}-plot`);
    const [both, difference] = [host('both'), host('difference')];
    if (!both || !difference) {
      this.drop();
      return;
    }
    if (this.plots) return;
    const colours = plotColours();
    const onPoint = (time: number | null): void => {
      if (time !== this.state.hover) this.studio.store.setState({ hover: time });
    };
    this.plots = {
      both: new TimePlot(both, { lines: LINES, colours, axis: false, onPoint }),
      difference: new TimePlot(difference, { lines: DIFFERENCE, colours, axis: true, onPoint }),
    };
    const turn = this.turns.add(() => this.draw());
    this.ends.push(turn.remove);
    for (const plot of [both, difference]) this.sizes.observe(plot);
    this.renew();
  }

  private drop(): void {
    this.sizes.disconnect();
    this.plots?.both.destroy();
    this.plots?.difference.destroy();
    this.plots = null;
  }

  private fit(): void {
    for (const [id, plot] of Object.entries(this.plots ?? {}) as ['both' | 'difference', TimePlot][]) {
      const { clientWidth, clientHeight } = this.querySelector<HTMLElement>(`#${id}-plot`)!;
      if (clientWidth > 40 && clientHeight > 30) plot.resize(clientWidth, clientHeight);
    }
  }

  private renew(): void {
    this.worded = 0;
    this.turns.askAll();
    this.turns.run(true);
    this.mark();
  }

  private draw(): void {
    const { plots } = this;
    const [a, b] = [this.studio.recorder('a'), this.studio.recorder('b')];
    if (!plots || !a || !b) return;
    const { span } = this.state;
    const data = compare(a.history, b.history, this.studio.axis(), span);
    this.data = data;
    const [from, to] = windowOf(data.time[data.time.length - 1] ?? this.editor.actions.time(), span);
    const ends = (values: Float64Array): [number, number] => [
      values.reduce((low, v) => Math.min(low, v), 0),
      values.reduce((high, v) => Math.max(high, v), 0),
    ];
    const [x, y] = [ends(data.a), ends(data.b)];
    const range: [number, number] = [Math.min(x[0], y[0]), Math.max(x[1], y[1])];
    const { factor, unit } = lengthUnit(Math.max(-range[0], range[1]));
    const scaled = (values: Float64Array): Float64Array => values.map((v) => v * factor);
    plots.both.draw(
      [data.time, scaled(data.a), scaled(data.b)],
      from,
      to,
      niceRange(range[0] * factor, range[1] * factor, 0.1),
    );
    const apart = ends(data.difference);
    const small = lengthUnit(Math.max(-apart[0], apart[1]));
    plots.difference.draw(
      [data.time, data.difference.map((v) => v * small.factor)],
      from,
      to,
      niceRange(apart[0] * small.factor, apart[1] * small.factor, 0.1),
    );
    this.unit('both', unit);
    this.unit('difference', small.unit);
    this.say(data);
  }

  private unit(id: string, unit: string): void {
    const place = this.querySelector(`#${id}-unit`);
    if (place && place.textContent !== unit) place.textContent = unit;
  }

  private say(data: Compared): void {
    const now = performance.now();
    const place = this.querySelector('.compare-words');
    if (!place || now - this.worded < WORDS_EVERY) return;
    this.worded = now;
    const found = differenceOf(data);
    place.textContent = found
      ? comparedWords.apart(lengthText(found.rms), lengthText(found.greatest), lengthText(found.of))
      : comparedWords.nothing;
  }

  private mark(): void {
    const { hover } = this.state;
    const { data } = this;
    this.plots?.both.mark(hover);
    this.plots?.difference.mark(hover);
    const at = hover === null || !data ? -1 : nearest(data.time, hover);
    const tell = (id: string, text: string): void => {
      const place = this.querySelector(`#${id}-reading`);
      if (place) place.textContent = text;
    };
    tell(
      'both',
      at < 0 ? '' : `${hover!.toFixed(2)}\u2009s: A ${lengthText(data!.a[at]!)}, B ${lengthText(data!.b[at]!)}`,
    );
    tell('difference', at < 0 ? '' : lengthText(data!.difference[at]!));
  }

  private start(wind: Wind): void {
    this.editor.actions.setCompare({ wind, preset: this.doc.preset, layout: 'split', at: 0.5 });
  }

  private choose(two: Comparison, id: string): void {
    const found = this.session.winds.find((w) => w.id === id);
    if (found) this.editor.actions.setCompare({ ...two, wind: found.wind, preset: id });
  }

  private save(): void {
    if (this.data) download('windgrove-compared.csv', csvOf(comparedTable(this.data)));
  }
}

customElements.define('wg-studio-compare', ComparePanel);
