import { type ControlRow, controlRow } from './control-row.ts';
import { allowed, defaultsOf, type Kept, type Value, type Values } from './controls.ts';
import type { FigureHost, FigureSpec, FigureStage } from './figure.ts';
import { type Colours, pageColours } from './figure-colours.ts';
import { FigureFrame } from './figure-frame.ts';
import { HandleLayer } from './handle.ts';
import type { Live, LivePage } from './live-page.ts';
import { readFigure, writeFigure } from './permalink.ts';
import { words } from './words.ts';

/** Device pixels to a CSS pixel at most: what a figure gains beyond is not seen. */
const MOST_PIXELS = 2;

/** One figure in its page. */
export class MountedFigure implements Live, FigureHost {
  readonly id: string;
  readonly element: HTMLElement;
  near = false;
  visible = false;
  readonly size = { width: 0, height: 0 };
  readonly #spec: FigureSpec;
  /** The controls, and what is dragged alone. */
  readonly #kept: readonly Kept[];
  readonly #page: LivePage;
  readonly #frame: FigureFrame;
  readonly #handles: HandleLayer;
  readonly #rows = new Map<string, ControlRow>();
  #values: Record<string, Value>;
  #stage: FigureStage | null = null;
  #failed = false;
  #waits = true;
  #stale = true;
  #drawn = false;
  #playing: boolean;
  #time: number;
  #colours: Colours | null = null;

  constructor(element: HTMLElement, spec: FigureSpec, page: LivePage) {
    this.id = spec.id;
    this.element = element;
    this.#spec = spec;
    this.#page = page;
    this.#kept = [...spec.controls, ...(spec.dragged ?? [])];
    this.#values = defaultsOf(this.#kept);
    this.#time = spec.begin ?? 0;
    this.#playing = Boolean(spec.moves) && !matchMedia('(prefers-reduced-motion: reduce)').matches;
    this.#frame = new FigureFrame(element, spec, {
      play: () => this.#play(!this.#playing),
      step: () => this.#step(),
      reset: () => this.#reset(),
      link: () => `${location.href.replace(/#.*/, '')}#${writeFigure(this.id, this.#kept, this.#values)}`,
    });
    for (const control of spec.controls) {
      const row = controlRow(control, `${spec.id}-${control.id}`, (value, done) => this.#tell(control.id, value, done));
      this.#rows.set(control.id, row);
      this.#frame.controls.append(row.element);
    }
    this.#handles = new HandleLayer(this.#frame.stage, {
      moved: () => this.#done(),
      state: () => this.#values,
    });
    this.#frame.showPlaying(this.#playing);
    this.#showValues();
    new ResizeObserver(() => this.redraw()).observe(this.#frame.stage);
  }

  get canvas(): HTMLCanvasElement {
    return this.#frame.canvas;
  }

  get pixelRatio(): number {
    return Math.min(devicePixelRatio, MOST_PIXELS);
  }

  get dark(): boolean {
    const { theme } = document.documentElement.dataset;
    return theme ? theme === 'dark' : matchMedia('(prefers-color-scheme: dark)').matches;
  }

  get stale(): boolean {
    return this.#stale && !this.#failed;
  }

  get moving(): boolean {
    return this.#playing && !this.#failed;
  }

  get settled(): boolean {
    return this.#failed || (this.#drawn && !this.#waits && !this.#stale);
  }

  get held(): boolean {
    return this.#handles.held;
  }

  values(): Values {
    return this.#values;
  }

  set(id: string, value: Value): void {
    const control = this.#kept.find((each) => each.id === id);
    if (!control) throw new Error(`Figure '${this.id}' has no value '${id}'.`);
    const kept = allowed(control, value);
    if (kept !== undefined) this.#tell(id, kept, false);
  }

  redraw(): void {
    this.#stale = true;
    this.#page.wake();
  }

  colours(): Colours {
    this.#colours ??= pageColours();
    return this.#colours;
  }

  changed(): void {
    this.#colours = null;
    this.redraw();
  }

  restore(hash: string): void {
    this.#values = { ...defaultsOf(this.#kept), ...readFigure(hash, this.#kept) };
    this.#showValues();
    this.redraw();
  }

  draw(seconds: number): void {
    if (this.#failed) return;
    try {
      this.#stage ??= this.#begin();
      if (this.#playing) this.#time += seconds;
      this.#fit();
      this.#stale = false;
      const readouts = this.#stage.draw(this.#values, this.#time);
      this.#handles.show(this.#stage.handles?.(this.#values) ?? []);
      this.#frame.showReadouts(readouts);
      // A picture that moves is not told again sixty times a second.
      if (!this.#drawn || !this.#playing) this.#frame.tell(this.#text(), false);
      this.#drawn = true;
      if (!this.#waits) this.#frame.showDrawn();
    } catch (error) {
      this.#fail(error);
    }
  }

  #begin(): FigureStage {
    const stage = this.#spec.stage(this);
    if (!stage.ready) this.#waits = false;
    stage.ready
      ?.then(() => {
        this.#waits = false;
        this.redraw();
      })
      .catch((error: unknown) => this.#fail(error));
    return stage;
  }

  #fit(): void {
    const { stage, canvas } = this.#frame;
    const { size, pixelRatio } = this;
    size.width = stage.clientWidth;
    size.height = stage.clientHeight;
    const [width, height] = [Math.round(size.width * pixelRatio), Math.round(size.height * pixelRatio)];
    if (canvas.width !== width) canvas.width = width;
    if (canvas.height !== height) canvas.height = height;
  }

  #fail(error: unknown): void {
    this.#failed = true;
    this.#stage?.dispose?.();
    this.#frame.fail(words.failed(error instanceof Error ? error.message : String(error)));
    this.#page.wake();
  }

  #text(): string {
    return this.#stage?.text?.(this.#values) ?? '';
  }

  #tell(id: string, value: Value, done: boolean): void {
    if (this.#values[id] !== value) {
      this.#values = { ...this.#values, [id]: value };
      this.redraw();
    }
    this.#showValues();
    if (done) this.#done();
  }

  /** A change has ended: the address says it, and screen readers hear it. */
  #done(): void {
    history.replaceState(null, '', `#${writeFigure(this.id, this.#kept, this.#values)}`);
    this.redraw();
    this.#frame.tell(this.#text(), true);
  }

  #showValues(): void {
    for (const [id, row] of this.#rows) {
      const value = this.#values[id];
      if (value !== undefined) row.show(value);
    }
    this.#frame.showLinks(this.#values);
  }

  #play(playing: boolean): void {
    this.#playing = playing;
    this.#frame.showPlaying(playing);
    this.redraw();
  }

  #step(): void {
    this.#play(false);
    this.#stage?.step?.();
    this.#done();
  }

  #reset(): void {
    this.#values = defaultsOf(this.#kept);
    this.#time = this.#spec.begin ?? 0;
    this.#stage?.reset?.();
    this.#showValues();
    this.redraw();
    this.#done();
  }
}
