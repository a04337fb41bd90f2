import { html, type TemplateResult } from 'lit';
import { createWindState, type WindState } from '../../core/wind/fade.ts';
import { windForce } from '../../core/wind/force.ts';
import { BEAUFORT, beaufortOf, speedOfForce } from '../../core/wind/speed.ts';
import { choice } from '../ui/choice.ts';
import { fieldWords } from '../words/studio-panels.ts';
import { type Field, FieldMap, fieldColour, fillField } from './field-map.ts';
import { onTheme, type PlotColours, plotColours } from './plot-colours.ts';
import { StudioPart } from './studio-part.ts';
import type { StudioState } from './studio-state.ts';
import { Turns } from './turns.ts';
import { niceStep, threeDigits } from './units.ts';

/** Metres that the map may be wide. */
const WIDTHS = [30, 60, 120] as const;

/** Metres that the keyboard's cursor goes at a time, in parts of the map. */
const STRIDE = 1 / 24;

/** Fastest winds that the scale shows, metres a second: it grows with what blows. */
const SCALES = [4, 6, 8, 12, 16, 20, 30, 40] as const;

/** The force of the wind over the ground around the tree: a map that follows time, or the time that a plot points at. */
class FieldPanel extends StudioPart {
  static override properties = {
    ...StudioPart.properties,
    small: { type: Boolean },
    width: { state: true },
    most: { state: true },
  };
  /** The map alone, to stand beside the plots: it shows the time that they mark. */
  declare small: boolean;
  declare width: number;
  declare most: number;
  private map: FieldMap | null = null;
  private field: Field | undefined;
  private colours: PlotColours | null = null;
  private cursor: [number, number] | null = null;
  private ends: (() => void)[] = [];
  private readonly wind = createWindState();
  private readonly turns = new Turns(() => performance.now());

  constructor() {
    super();
    this.small = false;
    this.width = 60;
    this.most = SCALES[0];
  }

  override connectedCallback(): void {
    super.connectedCallback();
    const turn = this.turns.add(() => this.draw(), this.small ? 8 : 20);
    const again = (): void => {
      turn.ask();
      this.turns.run(true);
    };
    const sizes = new ResizeObserver(() => {
      this.fit();
      again();
    });
    this.ends = [
      turn.remove,
      () => sizes.disconnect(),
      onTheme(() => {
        this.colours = plotColours();
        this.requestUpdate();
        again();
      }),
      this.editor.onFrame(() => {
        turn.ask();
        this.turns.run();
      }),
      this.studio.store.subscribe((now, before) => {
        if (now.hover !== before.hover || now.place !== before.place) again();
      }),
      this.editor.document.subscribe((now) => {
        if (now.paused) again();
      }),
    ];
    this.colours = plotColours();
    void this.updateComplete.then(() => {
      const canvas = this.querySelector('canvas');
      if (!this.isConnected || !canvas) return;
      this.map = new FieldMap(canvas);
      sizes.observe(this.querySelector('.field-map')!);
      this.fit();
      again();
    });
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    for (const end of this.ends) end();
    this.map = null;
  }

  protected override answers(now: StudioState, before: StudioState): boolean {
    return now.place !== before.place;
  }

  protected override render(): TemplateResult {
    if (this.small)
      return html`<figure class="plot-figure"><figcaption><h3>${fieldWords.title}</h3> <span class="unit">${this.width}\u2009m</span>
        <span class="key" id="field-reading"></span></figcaption>
        <div class="field-map"><canvas role="img" aria-label=${fieldWords.small(this.width)}></canvas></div></figure>`;
    return html`<div class="field-map">
        <canvas tabindex="0" role="application" aria-label=${fieldWords.map(this.width)}
          @click=${this.onClick} @pointermove=${this.onMove} @pointerleave=${this.onLeave} @keydown=${this.onKey} @blur=${this.onLeave}></canvas>
      </div>
      <div class="field-side">
        <p class="field-reading" aria-live="off" id="field-reading"></p>
        ${choice({
          name: 'field-width',
          legend: fieldWords.width,
          value: String(this.width),
          options: WIDTHS.map((w) => ({ value: String(w), label: `${w}\u2009m` })),
          onChoose: (value) => {
            this.width = Number(value);
            this.again();
          },
        })}
        <p class="soft">${fieldWords.how}</p>
      </div>
      ${this.legend()}`;
  }

  /** The scale of colours, with metres a second below and the names of the winds above. */
  private legend(): TemplateResult {
    const colour = fieldColour(this.colours ?? plotColours());
    const stops = Array.from(
      { length: 11 },
      (_, i) =>
        `rgb(${colour(i / 10)
          .map(Math.round)
          .join(' ')}) ${10 * i}%`,
    );
    const step = niceStep(this.most, 4);
    const ticks = Array.from({ length: Math.floor(this.most / step + 1e-6) + 1 }, (_, i) => i * step);
    const forces = BEAUFORT.filter(({ from }) => from < this.most);
    return html`<figure class="field-legend" aria-label=${fieldWords.scale(threeDigits(this.most))}>
      <figcaption>${fieldWords.scaleSays}</figcaption>
      <div class="beaufort" aria-hidden="true">${forces.map(({ number, name, from, to }) => {
        const share = (100 * (Math.min(to, this.most) - from)) / this.most;
        return html`<span style="width: ${share.toFixed(2)}%" title=${fieldWords.beaufort(number, name)}>${share > 7 ? number : ''}</span>`;
      })}</div>
      <div class="ramp" style="background: linear-gradient(to right, ${stops.join(', ')})"></div>
      <div class="ticks" aria-hidden="true">${ticks.map(
        (t) => html`<span style="left: ${((100 * t) / this.most).toFixed(2)}%">${Number(t.toFixed(2))}</span>`,
      )}</div>
    </figure>`;
  }

  private again(): void {
    this.turns.askAll();
    this.turns.run(true);
  }

  private fit(): void {
    const host = this.querySelector<HTMLElement>('.field-map');
    if (host) this.map?.resize(Math.min(host.clientWidth, host.clientHeight));
  }

  private get time(): number {
    return this.state.hover ?? this.editor.actions.time();
  }

  /** The wind that is edited, now or at the time that a plot points at. */
  private windNow(): WindState {
    const felt = this.studio.felt(this.session.side === 'B' && this.doc.compare ? 'b' : 'a');
    return felt.at(this.time, this.wind);
  }

  /** Height at which the force is shown: that of the probe, where a profile makes a difference. */
  private get height(): number {
    return this.state.place?.height ?? 10;
  }

  private draw(): void {
    const { map, colours } = this;
    const tree = this.studio.tree;
    if (!map || !colours || !tree) return;
    const state = this.windNow();
    this.field = fillField(state, this.width, this.height, this.field);
    const fastest = this.field.speed.reduce((most, s) => Math.max(most, s), 0);
    // The scale grows at once and never while one looks back: colours keep their meaning from frame to frame.
    if (fastest > this.most) this.most = SCALES.find((most) => most >= fastest) ?? Math.ceil(fastest / 10) * 10;
    const place = this.state.place;
    const { azimuth } = this.studio.picture.camera;
    map.draw(
      this.field,
      {
        width: this.width,
        most: this.most,
        crown: (tree.crown[3]! + tree.crown[4]!) / 2,
        probe: place && [place.end[0], place.end[1]],
        cursor: this.cursor,
        // The camera looks from its azimuth to the middle; seen from +z (azimuth 0) it looks along y of the tree.
        view: Math.PI / 2 + (azimuth * Math.PI) / 180,
      },
      colours,
    );
    this.say();
  }

  /** The force at the cursor, or at the tree. */
  private say(): void {
    const place = this.querySelector('#field-reading');
    if (!place) return;
    const [x, y] = this.cursor ?? [0, 0];
    const state = this.windNow();
    const [fx, fy] = windForce(state, x, y, this.height);
    const speed = speedOfForce(Math.hypot(fx, fy));
    const force = beaufortOf(speed);
    if (this.small) {
      place.textContent = fieldWords.atTree(this.time, threeDigits(speed));
      return;
    }
    const where = this.cursor ? fieldWords.place(x, y) : fieldWords.tree;
    place.textContent = fieldWords.reading(this.time, where, threeDigits(speed), force.name, force.number);
  }

  private placeOf(event: MouseEvent): [number, number] {
    const box = (event.currentTarget as HTMLElement).getBoundingClientRect();
    const x = ((event.clientX - box.left) / box.width - 0.5) * this.width;
    const y = (0.5 - (event.clientY - box.top) / box.height) * this.width;
    return [x, y];
  }

  private onMove(event: PointerEvent): void {
    this.cursor = this.placeOf(event);
    this.again();
  }

  private onLeave(): void {
    this.cursor = null;
    this.again();
  }

  private onClick(event: MouseEvent): void {
    const [x, y] = this.placeOf(event);
    this.editor.actions.throwGust({ x, y });
  }

  private onKey(event: KeyboardEvent): void {
    const { key } = event;
    const [x, y] = this.cursor ?? [0, 0];
    if (key === 'Enter') {
      event.preventDefault();
      this.editor.actions.throwGust({ x, y });
      return;
    }
    const by = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] }[key];
    if (!by) return;
    event.preventDefault();
    const stride = this.width * STRIDE * (event.shiftKey ? 4 : 1);
    const inside = (value: number): number => Math.min(this.width / 2, Math.max(-this.width / 2, value));
    this.cursor = [inside(x + by[0]! * stride), inside(y + by[1]! * stride)];
    this.again();
    const reading = this.querySelector('#field-reading')?.textContent ?? '';
    this.editor.actions.say(reading);
  }
}

customElements.define('wg-studio-field', FieldPanel);
