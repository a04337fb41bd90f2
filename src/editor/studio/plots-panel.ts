import { html, nothing, type PropertyValues, type TemplateResult } from 'lit';
import type { ProbeHistory } from '../../core/wind/probe-history.ts';
import './field-panel.ts';
import { PhasePlot } from './phase-plot.ts';
import { onTheme, plotColours } from './plot-colours.ts';
import { nearest, type SpectrumData, spectrumData, type TimeData, timeData, windowOf } from './plot-data.ts';
import { plotFigure } from './plot-figure.ts';
import './plot-summary.ts';
import { plotWords } from '../words/studio-panels.ts';
import { SpectrumPlot } from './spectrum-plot.ts';
import { StudioPart } from './studio-part.ts';
import type { StudioState } from './studio-state.ts';
import { type Line, TimePlot } from './time-plot.ts';
import { Turns } from './turns.ts';
import { lengthUnit, niceRange, threeDigits } from './units.ts';

const FORCE: readonly Line[] = [
  { label: plotWords.lines.strength, colour: 'force', dash: [], area: true },
  { label: plotWords.lines.acrossWind, colour: 'force', dash: [4, 3] },
];
const DISPLACEMENT: readonly Line[] = [
  { label: plotWords.lines.alongWind, colour: 'answer', dash: [] },
  { label: plotWords.lines.across, colour: 'answer', dash: [4, 3] },
];
const VELOCITY: readonly Line[] = [
  { label: plotWords.lines.alongWind, colour: 'velocity', dash: [] },
  { label: plotWords.lines.across, colour: 'velocity', dash: [4, 3] },
];
const SPECTRA: readonly Line[] = [
  { label: plotWords.lines.force, colour: 'force', dash: [] },
  { label: plotWords.lines.displacement, colour: 'answer', dash: [6, 3] },
];

/** Spectra change slowly, and cost the most. */
const SPECTRUM_RATE = 5;

/** Pixels across from which on a map of the field stands beside the plots. */
const ROOMY = 1200;

const extremes = (...columns: readonly Float64Array[]): [number, number] => {
  let low = Number.POSITIVE_INFINITY;
  let high = Number.NEGATIVE_INFINITY;
  for (const column of columns) {
    for (const value of column) {
      if (value < low) low = value;
      if (value > high) high = value;
    }
  }
  return low <= high ? [low, high] : [0, 0];
};

/** Everything that is drawn while the panel stands. */
interface Drawn {
  readonly force: TimePlot;
  readonly displacement: TimePlot;
  readonly velocity: TimePlot;
  readonly spectrum: SpectrumPlot;
  readonly phase: PhasePlot;
}

/** Force, displacement, velocity, spectrum and phase portrait of the probe, live. */
export class PlotsPanel extends StudioPart {
  /** What is plotted now: what the file and the table hold. */
  data: TimeData | null = null;
  spectra: SpectrumData | null = null;
  /** Milliseconds that the plots took in the last frames, for measuring. */
  readonly costs: number[] = [];
  private drawn: Drawn | null = null;
  private roomy = false;
  private ends: (() => void)[] = [];
  private readonly turns = new Turns(() => performance.now());
  private frequency: number | null = null;
  private seen: { history?: ProbeHistory | undefined; revision?: number | undefined } = {};

  override connectedCallback(): void {
    super.connectedCallback();
    this.ends = [
      onTheme(() => this.rebuild()),
      this.studio.onReadings(() => this.onReadings()),
      this.studio.store.subscribe((now, before) => {
        if (now.hover !== before.hover) this.mark(now.hover);
        if (now.span !== before.span || now.place !== before.place) this.renew();
        // Where time stands no frame follows the last reading.
        if (before.catchingUp !== null && now.catchingUp === null) this.renew();
        if (before.frozen && !now.frozen) this.renew();
      }),
      this.editor.document.subscribe((now, before) => {
        if (now.paused || now.wind !== before.wind) this.renew();
      }),
    ];
    const sizes = new ResizeObserver(() => this.fit());
    const rooms = new ResizeObserver(() => this.room());
    rooms.observe(this);
    this.ends.push(() => sizes.disconnect());
    this.ends.push(() => rooms.disconnect());
    void this.updateComplete.then(() => {
      if (!this.isConnected) return;
      this.build();
      for (const plot of this.querySelectorAll('.plot')) sizes.observe(plot);
    });
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    for (const stop of this.ends) stop();
    this.destroy();
    this.studio.store.setState({ hover: null });
  }

  protected override answers(now: StudioState, before: StudioState): boolean {
    return now.place !== before.place || now.natural !== before.natural;
  }

  protected override shouldUpdate(changes: PropertyValues): boolean {
    return !this.hasUpdated || changes.size > 0;
  }

  protected override render(): TemplateResult {
    return html`
      <div class="plots-time" role="group" aria-label=${plotWords.group}>
        ${plotFigure('force', plotWords.force, 'm/s', FORCE)}
        ${plotFigure('displacement', plotWords.displacement, 'm', DISPLACEMENT)}
        ${plotFigure('velocity', plotWords.velocity, 'm/s', VELOCITY, true)}
        <input type="range" class="mark-time" min="0" max="1" step="any" aria-label=${plotWords.marked}
          @input=${this.onMark} @keydown=${this.onMarkKey} @blur=${() => this.point(null)}>
      </div>
      <div class="plots-rest">
        ${plotFigure('spectrum', plotWords.spectrum, plotWords.spectrumUnit, SPECTRA)}
        ${plotFigure('phase', plotWords.phase, '', [])}
      </div>
      ${this.roomy ? html`<wg-studio-field small .editor=${this.editor}></wg-studio-field>` : nothing}
      <wg-plot-summary .editor=${this.editor} .panel=${this}></wg-plot-summary>`;
  }

  /** Whether a map of the field has room beside the plots. */
  private room(): void {
    const roomy = this.clientWidth >= ROOMY;
    if (roomy === this.roomy) return;
    this.roomy = roomy;
    this.toggleAttribute('data-roomy', roomy);
    this.requestUpdate('roomy');
  }

  private build(): void {
    const host = (id: string): HTMLElement => this.querySelector<HTMLElement>(`#${id}-plot`)!;
    const colours = plotColours();
    const onPoint = (time: number | null): void => this.point(time);
    const time = (id: string, lines: readonly Line[], axis: boolean): TimePlot =>
      new TimePlot(host(id), { lines, colours, axis, onPoint });
    const drawn: Drawn = {
      force: time('force', FORCE, false),
      displacement: time('displacement', DISPLACEMENT, false),
      velocity: time('velocity', VELOCITY, true),
      spectrum: new SpectrumPlot(host('spectrum'), colours, (frequency) => {
        this.frequency = frequency;
        this.readSpectrum();
      }),
      phase: new PhasePlot(host('phase'), colours, onPoint),
    };
    this.drawn = drawn;
    const turns = [
      this.turns.add(() => this.drawForce(drawn)),
      this.turns.add(() => this.drawDisplacement(drawn)),
      this.turns.add(() => this.drawVelocity(drawn)),
      this.turns.add(() => this.drawPhase(drawn)),
      this.turns.add(() => this.drawSpectrum(drawn), SPECTRUM_RATE),
    ];
    this.ends.push(() => {
      for (const turn of turns) turn.remove();
    });
    this.renew();
  }

  private destroy(): void {
    for (const plot of Object.values(this.drawn ?? {}) as { destroy(): void }[]) plot.destroy();
    this.drawn = null;
  }

  private rebuild(): void {
    if (!this.drawn) return;
    this.destroy();
    this.build();
  }

  private fit(): void {
    const { drawn } = this;
    if (!drawn) return;
    for (const [id, plot] of Object.entries(drawn) as [keyof Drawn, Drawn[keyof Drawn]][]) {
      const { clientWidth, clientHeight } = this.querySelector<HTMLElement>(`#${id}-plot`)!;
      if (clientWidth > 40 && clientHeight > 30) plot.resize(clientWidth, clientHeight);
    }
    this.mark(this.state.hover);
  }

  /** New readings: the plots whose turn it is are drawn. */
  private onReadings(): void {
    if (!this.drawn || (this.state.frozen && this.data)) return;
    const history = this.studio.recorder('a')?.history;
    const fresh = history !== this.seen.history || history?.revision !== this.seen.revision;
    if (!fresh && !this.turns.waiting) return;
    const start = performance.now();
    if (fresh) {
      this.seen = { history, revision: history?.revision };
      this.takeData();
      this.turns.askAll();
    }
    this.turns.run();
    this.costs.push(performance.now() - start);
    if (this.costs.length > 300) this.costs.shift();
  }

  /** Draws all of them now: something changed that is no new reading. */
  private renew(): void {
    if (!this.drawn) return;
    if (!this.state.frozen || !this.data) this.takeData();
    this.turns.askAll();
    this.turns.run(true);
    this.mark(this.state.hover);
  }

  private takeData(): void {
    const history = this.studio.recorder('a')?.history;
    this.data = history && history.count > 0 ? timeData(history, this.studio.axis(), this.state.span) : null;
  }

  private get window(): [from: number, to: number] {
    const { data } = this;
    const to = data && data.time.length > 0 ? data.time[data.time.length - 1]! : this.editor.actions.time();
    return windowOf(to, this.state.span);
  }

  private drawForce({ force }: Drawn): void {
    const { data } = this;
    if (!data) return;
    const [low, high] = extremes(data.force, data.forceAcross);
    force.draw([data.time, data.force, data.forceAcross], ...this.window, niceRange(Math.min(0, low), high, 0.5));
  }

  private drawDisplacement({ displacement }: Drawn): void {
    const { data } = this;
    if (!data) return;
    const range = extremes(data.along, data.across);
    const { factor, unit } = lengthUnit(Math.max(-range[0], range[1]));
    const scale = (values: Float64Array): Float64Array => values.map((v) => v * factor);
    const nice = niceRange(Math.min(0, range[0] * factor), Math.max(0, range[1] * factor), 0.1);
    displacement.draw([data.time, scale(data.along), scale(data.across)], ...this.window, nice);
    this.unit('displacement', unit);
  }

  private drawVelocity({ velocity }: Drawn): void {
    const { data } = this;
    if (!data) return;
    const range = extremes(data.velocityAlong, data.velocityAcross);
    const { factor, unit } = lengthUnit(Math.max(-range[0], range[1]));
    const scale = (values: Float64Array): Float64Array => values.map((v) => v * factor);
    const nice = niceRange(range[0] * factor, range[1] * factor, 0.1);
    velocity.draw([data.time, scale(data.velocityAlong), scale(data.velocityAcross)], ...this.window, nice);
    this.unit('velocity', `${unit}/s`);
  }

  private drawPhase({ phase }: Drawn): void {
    const { data } = this;
    if (!data) return;
    const [x, v] = [extremes(data.along), extremes(data.velocityAlong)];
    const dx = lengthUnit(Math.max(-x[0], x[1]));
    const dv = lengthUnit(Math.max(-v[0], v[1]));
    phase.draw(
      data.time,
      data.along.map((each) => each * dx.factor),
      data.velocityAlong.map((each) => each * dv.factor),
      { x: niceRange(x[0] * dx.factor, x[1] * dx.factor, 0.1), y: niceRange(v[0] * dv.factor, v[1] * dv.factor, 0.1) },
    );
    this.unit('phase', plotWords.phaseUnit(dv.unit, dx.unit));
  }

  private drawSpectrum({ spectrum }: Drawn): void {
    const history = this.studio.recorder('a')?.history;
    if (!history || history.count < 64) return;
    if (!this.state.frozen || !this.spectra) this.spectra = spectrumData(history, this.studio.axis());
    spectrum.draw(this.spectra, this.state.natural);
  }

  private unit(id: string, unit: string): void {
    const place = this.querySelector(`#${id}-unit`);
    if (place && place.textContent !== unit) place.textContent = unit;
  }

  private point(time: number | null): void {
    if (time !== this.state.hover) this.studio.store.setState({ hover: time });
  }

  /** Marks a time in all plots, and says beside each what it was then. */
  private mark(time: number | null): void {
    const { drawn, data } = this;
    if (!drawn) return;
    for (const plot of [drawn.force, drawn.displacement, drawn.velocity]) plot.mark(time);
    const at = time === null || !data ? -1 : nearest(data.time, time);
    drawn.phase.mark(at);
    const say = (id: string, values: Float64Array | undefined, metres: boolean): void => {
      const place = this.querySelector(`#${id}-reading`);
      if (!place) return;
      const value = at < 0 ? undefined : values?.[at];
      const { factor, unit } = metres ? lengthUnit(Math.abs(value ?? 0)) : { factor: 1, unit: 'm/s' };
      const whole = id === 'velocity' ? `${unit}/s` : unit;
      place.textContent =
        value === undefined ? '' : `${time!.toFixed(2)}\u2009s: ${threeDigits(value * factor)}\u2009${whole}`;
    };
    say('force', data?.force, false);
    say('displacement', data?.along, true);
    say('velocity', data?.velocityAlong, true);
  }

  private readSpectrum(): void {
    const place = this.querySelector('#spectrum-reading');
    if (place) place.textContent = this.frequency === null ? '' : `${threeDigits(this.frequency)}\u2009Hz`;
  }

  private onMark(event: Event): void {
    const [from, to] = this.window;
    this.point(from + (event.target as HTMLInputElement).valueAsNumber * (to - from));
  }

  /** Arrows mark the next reading, with Shift the tenth. */
  private onMarkKey(event: KeyboardEvent): void {
    const towards = { ArrowUp: 1, ArrowRight: 1, ArrowDown: -1, ArrowLeft: -1 }[event.key];
    if (!towards) return;
    event.preventDefault();
    const [from, to] = this.window;
    const now = this.state.hover ?? to;
    const time = Math.min(to, Math.max(from, now + (towards * (event.shiftKey ? 10 : 1)) / 60));
    this.point(time);
    const input = event.target as HTMLInputElement;
    input.value = String((time - from) / (to - from));
    const at = this.data ? nearest(this.data.time, time) : -1;
    const force = at < 0 ? null : threeDigits(this.data!.force[at]!);
    input.setAttribute('aria-valuetext', plotWords.markedAt(time, force));
  }
}

customElements.define('wg-studio-plots', PlotsPanel);
