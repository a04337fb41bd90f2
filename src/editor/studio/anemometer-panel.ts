import { html, nothing, type TemplateResult } from 'lit';
import { type Fault, faultText } from '../../core/file/fault.ts';
import { comesFrom, parseAnemometer } from '../../core/wind/anemometer.ts';
import type { WindRecord } from '../../core/wind/wind.ts';
import { icon } from '../ui/icons.ts';
import { anemometerWords } from '../words/studio-panels.ts';
import { onTheme, plotColours } from './plot-colours.ts';
import { plotFigure } from './plot-figure.ts';
import { StudioPart } from './studio-part.ts';
import type { StudioState } from './studio-state.ts';
import { type Line, TimePlot } from './time-plot.ts';
import { niceRange, threeDigits } from './units.ts';

const SPEED: readonly Line[] = [{ label: anemometerWords.measured, colour: 'force', dash: [], area: true }];
const DIRECTION: readonly Line[] = [{ label: anemometerWords.from, colour: 'reference', dash: [3, 2] }];

/** Longest file that is opened, bytes. */
const LONGEST = 16_000_000;

/** Faults of a file that are listed. */
const LISTED = 6;

/** What a bad file says. */
interface Bad {
  readonly name: string;
  readonly faults: readonly Fault[];
}

const EXAMPLE = `time (s),speed (m/s),direction (deg)
0.0,4.2,262
0.5,4.9,266
1.0,5.8,271
1.5,5.1,268`;

/** A measured wind: opened, looked at, and played beside the waves or alone. */
class AnemometerPanel extends StudioPart {
  static override properties = {
    ...StudioPart.properties,
    record: { state: true },
    notes: { state: true },
    bad: { state: true },
  };
  declare record: WindRecord | null;
  declare notes: readonly string[];
  declare bad: Bad | null;
  private plots: { speed: TimePlot; direction: TimePlot } | null = null;
  private drawn: WindRecord | null = null;
  private ends: (() => void)[] = [];
  private readonly sizes = new ResizeObserver(() => this.fit());
  private pointed: number | null = null;

  constructor() {
    super();
    this.record = null;
    this.notes = [];
    this.bad = null;
  }

  override connectedCallback(): void {
    super.connectedCallback();
    this.record ??= this.doc.wind.record;
    this.ends = [
      onTheme(() => {
        this.drop();
        this.requestUpdate();
      }),
      this.editor.onFrame(() => this.mark()),
    ];
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    for (const end of this.ends) end();
    this.drop();
  }

  protected override answers(now: StudioState, before: StudioState): boolean {
    return now.place !== before.place;
  }

  protected override render(): TemplateResult {
    const { record, bad } = this;
    const sample = this.session.winds.find((w) => w.wind.record)?.wind.record;
    return html`<div class="anemometer-side">
        ${bad ? this.complaint(bad) : nothing}
        ${record ? this.about(record) : html`<p>${anemometerWords.about}</p>`}
        <div class="buttons">
          <label class="button open-file">${icon('open')}<span>${anemometerWords.open}</span>
            <input type="file" accept=".csv,.tsv,.txt,text/csv" class="spoken" @change=${this.open}></label>
          ${sample ? html`<button type="button" class="quiet" @click=${() => this.take(sample, [])}>${anemometerWords.sample}</button>` : nothing}
        </div>
      </div>
      ${
        record
          ? html`<div class="anemometer-plots">
              ${plotFigure('speed', anemometerWords.speed, 'm/s', SPEED)}
              ${plotFigure('direction', anemometerWords.direction, anemometerWords.directionUnit, DIRECTION, true)}
            </div>`
          : this.example()
      }`;
  }

  /** What such a file looks like, for whom has none at hand. */
  private example(): TemplateResult {
    return html`<figure class="csv-example"><figcaption>${anemometerWords.example}</figcaption>
      <pre>${EXAMPLE}</pre>
      <p class="soft">${anemometerWords.exampleSays}</p></figure>`;
  }

  private about(record: WindRecord): TemplateResult {
    const { actions } = this.editor;
    const { wind } = actions.edited();
    const seconds = record.speed.length * record.step;
    const mean = record.speed.reduce((sum, v) => sum + v, 0) / record.speed.length;
    const most = record.speed.reduce((a, b) => Math.max(a, b), 0);
    const playing =
      wind.record !== null && wind.record.name === record.name && wind.record.speed.length === record.speed.length;
    const waves = wind.waves.some((wave) => wave.on);
    return html`<p><strong>${record.name}</strong>${anemometerWords.figures(record.speed.length, threeDigits(1 / record.step), threeDigits(seconds), threeDigits(mean), threeDigits(most))}</p>
      ${this.notes.length ? html`<ul class="notes">${this.notes.map((note) => html`<li>${note}</li>`)}</ul>` : nothing}
      <div class="buttons">
        ${
          playing
            ? html`<button type="button" class="quiet" @click=${() => actions.setRecord(null)}>${icon('pause')}<span>${anemometerWords.stop}</span></button>`
            : html`<button type="button" class="quiet" @click=${() => this.play(record, false)}>${icon('play')}<span>${waves ? anemometerWords.playBeside : anemometerWords.play}</span></button>
              ${waves ? html`<button type="button" class="quiet" @click=${() => this.play(record, true)}>${anemometerWords.playAlone}</button>` : nothing}`
        }
      </div>`;
  }

  private complaint({ name, faults }: Bad): TemplateResult {
    const more = faults.length - LISTED;
    return html`<div class="strip" data-kind="error" role="alert"><div><strong><span class="kind">${anemometerWords.error}</span> ${anemometerWords.notOpened(name)}</strong>
      <ul>${faults.slice(0, LISTED).map((fault) => html`<li>${faultText(fault)}</li>`)}${more > 0 ? html`<li>${anemometerWords.more(more)}</li>` : nothing}</ul></div>
      <button type="button" class="round" aria-label=${anemometerWords.close} @click=${() => (this.bad = null)}>${icon('close')}</button></div>`;
  }

  protected override updated(): void {
    const host = (id: string): HTMLElement | null => this.querySelector<HTMLElement>(`#${id}-plot`);
    const [speed, direction] = [host('speed'), host('direction')];
    if (!speed || !direction || !this.record) {
      this.drop();
      return;
    }
    if (!this.plots) {
      const colours = plotColours();
      const onPoint = (time: number | null): void => {
        this.pointed = time;
        this.mark();
      };
      this.plots = {
        speed: new TimePlot(speed, { lines: SPEED, colours, axis: false, onPoint }),
        direction: new TimePlot(direction, { lines: DIRECTION, colours, axis: true, onPoint }),
      };
      this.sizes.observe(speed);
      this.sizes.observe(direction);
      this.drawn = null;
    }
    if (this.drawn !== this.record) this.draw(this.record);
    this.mark();
  }

  private drop(): void {
    this.sizes.disconnect();
    this.plots?.speed.destroy();
    this.plots?.direction.destroy();
    this.plots = null;
    this.drawn = null;
  }

  private fit(): void {
    for (const [id, plot] of Object.entries(this.plots ?? {}) as ['speed' | 'direction', TimePlot][]) {
      const { clientWidth, clientHeight } = this.querySelector<HTMLElement>(`#${id}-plot`)!;
      if (clientWidth > 40 && clientHeight > 30) plot.resize(clientWidth, clientHeight);
    }
  }

  private draw(record: WindRecord): void {
    const { plots } = this;
    if (!plots) return;
    this.drawn = record;
    const time = Float64Array.from(record.speed, (_, i) => i * record.step);
    const speed = Float64Array.from(record.speed);
    const from = Float64Array.from(record.direction, comesFrom);
    const end = time[time.length - 1]!;
    plots.speed.draw(
      [time, speed],
      0,
      end,
      niceRange(
        0,
        speed.reduce((a, b) => Math.max(a, b), 0),
        1,
      ),
    );
    plots.direction.draw([time, from], 0, end, [0, 360]);
  }

  /** Where the record is now, or what is pointed at. */
  private mark(): void {
    const { record, plots } = this;
    if (!record || !plots) return;
    const length = record.speed.length * record.step;
    const now = this.editor.actions.time();
    const time = this.pointed ?? now - length * Math.floor(now / length);
    plots.speed.mark(time);
    plots.direction.mark(time);
    const i = Math.min(record.speed.length - 1, Math.max(0, Math.round(time / record.step)));
    const tell = (id: string, text: string): void => {
      const place = this.querySelector(`#${id}-reading`);
      if (place && place.textContent !== text) place.textContent = text;
    };
    tell('speed', `${time.toFixed(1)}\u2009s: ${threeDigits(record.speed[i]!)}\u2009m/s`);
    tell('direction', `${comesFrom(record.direction[i]!).toFixed(0)}\u2009°`);
  }

  private take(record: WindRecord, notes: readonly string[]): void {
    this.record = record;
    this.notes = notes;
    this.bad = null;
    this.editor.actions.say(anemometerWords.isOpen(record.name, record.speed.length));
  }

  private play(record: WindRecord, alone: boolean): void {
    const { actions } = this.editor;
    const { wind } = actions.edited();
    if (alone)
      actions.setOwnWind({
        ...wind,
        name: record.name,
        description: anemometerWords.asMeasured,
        record,
        waves: wind.waves.map((w) => ({ ...w, on: false })),
      });
    else actions.setRecord(record);
    actions.setBlowing(true);
    this.requestUpdate();
  }

  private async open(event: Event): Promise<void> {
    const input = event.target as HTMLInputElement;
    const file = input.files?.[0];
    input.value = ''; // the same file can be chosen again after it was mended
    if (!file) return;
    if (file.size > LONGEST) {
      this.bad = {
        name: file.name,
        faults: [{ path: '', found: anemometerWords.bytes(file.size), allowed: anemometerWords.most(LONGEST) }],
      };
      return;
    }
    const parsed = parseAnemometer(await file.text(), { name: file.name.replace(/\.[a-z]+$/i, '').slice(0, 80) });
    if (parsed.record) this.take(parsed.record, parsed.notes);
    else this.bad = { name: file.name, faults: parsed.faults };
  }
}

customElements.define('wg-studio-anemometer', AnemometerPanel);
