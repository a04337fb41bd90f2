import type { PropertyDeclarations, PropertyValues } from '@lit/reactive-element';
import type { ExportOptions } from '../core/io/export-options.ts';
import { STILL, type Wind } from '../core/wind/wind.ts';
import type { KitTree } from '../view/kit-tree.ts';
import { attributeProperty } from './attribute-property.ts';
import { attributeFault, readProperty } from './attributes.ts';
import { putBackBad } from './bad-values.ts';
import { changesOf } from './changes.ts';
import { isDark, watchScheme } from './colour-scheme.ts';
import type { Drawing } from './drawing.ts';
import type { ErrorType, WindTreeEventDetails } from './element-events.ts';
import { ElementShadow } from './element-shadow.ts';
import { applyState, cameraOf, type ElementState, stateOf } from './element-state.ts';
import { elementStyles } from './element-styles.ts';
import { distanceToMiddle, type Nearness, watchNearness } from './near.ts';
import { fetchedFrom, type ShippedSource } from './shipped-source.ts';
import { type Planted, TreeLoader } from './tree-loader.ts';
import { lookOf } from './tree-look.ts';
import { TreePlayer } from './tree-player.ts';
import type { DrawnQuality } from './tree-view.ts';
import { WindTreeProperties } from './wind-tree-properties.ts';
import { elementWords } from './words.ts';

export type { WindTreeEventDetails } from './element-events.ts';
export type { ElementState } from './element-state.ts';

/** Seconds in which one wind goes over into the next. */
const FADE = 1;

const AWAY: Nearness = { visible: false, near: false, far: false };

/** What the element is at. */
type Stage = WindTreeEventDetails['statechange']['state'];

/**
 * A tree in the wind.
 *
 * @tag wind-tree
 *
 * @slot - Notes over the picture.
 * @slot poster - What stands until the tree does.
 * @slot progress - What tells how far it is, in place of the bar.
 * @slot controls - Controls in place of the button that holds the wind still; such a one must be among them.
 * @slot fallback - What is shown where the browser has no WebGL2.
 *
 * @csspart canvas - The picture.
 * @csspart poster - What stands before it.
 * @csspart progress - The bar that tells how far the tree is.
 * @csspart controls - The place of the controls.
 * @csspart button - The button of the controls, and that of the poster.
 * @csspart message - What is said where something is wrong.
 * @csspart status - What only screen readers are told.
 *
 * @cssproperty [--wind-tree-background=transparent] - Behind the picture; seen where `environment` is `none`.
 * @cssproperty [--wind-tree-poster-color] - Behind the poster; by default a shade of the page's own.
 * @cssproperty [--wind-tree-focus-ring=Highlight] - Colour of the ring around what has the focus.
 * @cssproperty [--wind-tree-progress-color=#1a7f37] - Colour of the bar of progress.
 *
 * @cssstate loading - A tree is on its way.
 * @cssstate ready - The tree is seen.
 * @cssstate paused - Time stands still.
 * @cssstate error - There is no tree, and the event `error` said why.
 *
 * @fires {CustomEvent<{species: string, seed: number, triangles: number}>} load - A tree is drawn for the first time.
 * @fires {CustomEvent<{type: string, message: string}>} error - Something is wrong; `type` is fetch, species, wind, grow, capability, contextlost or attribute.
 * @fires {CustomEvent<{phase: string, progress: number}>} progress - It has come so far, 0 to 1.
 * @fires {CustomEvent<{time: number}>} timeupdate - Time has gone on, four times a second, or was set.
 * @fires {CustomEvent<{level: string, scale: number}>} quality-change - It is drawn more coarsely, since it was too slow, or finely again.
 * @fires {CustomEvent<{azimuth: number, elevation: number, distance: number, target: number[], source: string}>} camera-change - The camera moved; `source` is user or script.
 * @fires {CustomEvent<{visible: boolean}>} visibility - It came into the window, or left it.
 * @fires {CustomEvent<{state: string, paused: boolean}>} statechange - It is loading, ready or in error, or was paused or played.
 */
export class WindTreeElement extends WindTreeProperties {
  static override styles = elementStyles;

  static override properties: PropertyDeclarations = { time: attributeProperty('time') };

  /** Where species and winds that are named come from, for all elements of the page; by default `species/` and `winds/` beside the document. */
  static shipped: ShippedSource = fetchedFrom('.');

  readonly #internals = this.attachInternals();
  readonly #size = new ResizeObserver(() => this.#player.resize(this.clientWidth, this.clientHeight));
  readonly #player: TreePlayer = this.#newPlayer();
  readonly #loader: TreeLoader = this.#newLoader();
  #shadow: ElementShadow | null = null;
  #drawing: Drawing | null = null;
  #nearness = AWAY;
  #unwatch: (() => void)[] = [];
  /** The wind as the attributes have it, and how often it was asked for. */
  #blows: Wind = STILL;
  #windWish = 0;
  #wantsTree = true;
  #drawn = false;
  #poster = true;
  #listens = false;
  #dismissed = false;
  #stage: Stage = 'idle';
  #message = '';
  #unable = false;
  #said = '';
  #progress = 0;
  /** The page has said whether time is to run. */
  #asked = false;

  /** Time of the wind in seconds; setting it goes there. The attribute, `3s`, makes a still of it unless `autoplay` is there too. */
  get time(): number {
    return this.#player.clock.time;
  }

  set time(time: number) {
    const read = readProperty('time', time);
    if (read === undefined) this.#fault('attribute', attributeFault('time', time));
    else if (read !== null) this.seek(read as number);
  }

  /** A tree is drawn. */
  get loaded(): boolean {
    return this.#drawn;
  }

  /** Some of it is in the window. */
  get visible(): boolean {
    return this.#nearness.visible;
  }

  /** What the last picture was made of, and what is on the GPU for all elements of the page. */
  get stats(): {
    triangles: number;
    drawCalls: number;
    quality: DrawnQuality | null;
    shared: Drawing['renderer']['info'];
  } {
    const { figures, view } = this.#player;
    return { ...figures, quality: view?.quality ?? null, shared: this.#drawing?.renderer.info ?? null };
  }

  /** What the GPU of the page's elements can do; where it lacks something `reason` says what is done instead. null before the first tree. */
  get capabilities(): Drawing['renderer']['capabilities'] {
    return this.#drawing?.renderer.capabilities ?? null;
  }

  /** The view object that is drawn, a WindTree by what it can do; null before there is one and while it is far from the window. */
  get tree(): KitTree | null {
    return this.#player.view?.tree ?? null;
  }

  /** Lets time run. */
  play(): void {
    this.#asked = true;
    this.paused = false;
  }

  /** Holds time still. */
  pause(): void {
    this.#asked = true;
    this.paused = true;
  }

  /** Goes to a time in seconds. */
  seek(seconds: number): void {
    this.#player.seek(seconds);
  }

  /** Goes some sixtieths of a second on, or back, and holds time still. */
  step(steps = 1): void {
    this.pause();
    this.#player.step(steps);
  }

  /** Takes the poster away; a tree that is not there yet is waited for. */
  dismissPoster(): void {
    this.#dismissed = true;
    if (this.#drawn) this.#poster = false;
    this.#run();
  }

  /** Shows the poster again; time stands still behind it. */
  showPoster(): void {
    this.#dismissed = false;
    this.#poster = true;
    this.#run();
  }

  /**
   * A picture of the tree as it is seen now, at any size in pixels and any time in seconds; by default those of the element. Rejects before
   * there is a tree, and where the browser cannot.
   */
  async toBlob(
    options: { width?: number; height?: number; type?: string; quality?: number; time?: number } = {},
  ): Promise<Blob> {
    const shown = this.#shown();
    const { takePicture } = await import('./element-files.ts');
    const { clientWidth: width, clientHeight: height, time } = this;
    const look = lookOf(this, isDark(this));
    return takePicture(shown, options, { width, height, time, camera: this.#player.orbit.pose, look });
  }

  /** The tree as a GLB file, with the options of the export (`clip: true` writes the wind too). Rejects before there is a tree. */
  async exportGLB(options: Partial<ExportOptions> = {}, signal?: AbortSignal): Promise<Blob> {
    const shown = this.#shown();
    const { writeGlb } = await import('./element-files.ts');
    return writeGlb(shown, options, signal);
  }

  /** All that is seen as plain JSON: the properties of the attributes, time, and the camera where the reader moved it. */
  getState(): ElementState {
    return stateOf(this, this.#player.orbit.own);
  }

  /** Takes what `getState` gave, whole or in part; a value that may not be gives an `error` event, the others apply. */
  setState(state: ElementState): void {
    applyState(this, state);
    const camera = cameraOf(state.camera);
    // After the attribute of the same state, which would put the camera back.
    if (camera) void this.updateComplete.then(() => this.#player.place(camera));
  }

  override connectedCallback(): void {
    super.connectedCallback();
    this.#size.observe(this);
    const motion = matchMedia('(prefers-reduced-motion: reduce)');
    const less = (): void => {
      if (motion.matches) this.pause();
    };
    motion.addEventListener('change', less);
    this.#unwatch = [
      watchNearness(this, (how) => this.#come(how)),
      watchScheme(() => this.#relook()),
      () => motion.removeEventListener('change', less),
    ];
    this.#wantsTree = true;
    this.#loadIfNear();
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    this.#size.disconnect();
    for (const stop of this.#unwatch.splice(0)) stop();
    this.#loader.stop();
    this.#player.close();
    this.#drawn = false;
    this.#nearness = AWAY;
    this.#enter('idle');
  }

  protected override willUpdate(changed: PropertyValues): void {
    putBackBad(this, changed, (type, message) => this.#fault(type, message));
    if (changed.has('playbackRate')) this.#player.clock.rate = this.playbackRate;
    // A picture that can be turned is a group with the picture and its controls; another is the picture alone.
    this.#internals.role = this.cameraControls ? 'group' : null;
    this.#internals.ariaLabel = this.cameraControls ? this.#label || elementWords.alt(null, null) : null;
  }

  protected override updated(changed: PropertyValues): void {
    if (changed.has('touchAction') || changed.has('cameraControls'))
      this.#canvas.style.touchAction = this.cameraControls ? this.touchAction : 'auto';
    if (this.cameraControls) void this.#listen();
    const { tree, wind, air, look } = changesOf(changed);
    if (tree) this.#wantsTree = true;
    // What follows asks for another rendering: after this one.
    queueMicrotask(() => {
      if (tree || changed.has('loading')) this.#loadIfNear();
      if (wind) this.#loader.reloadWind();
      else if (air) void this.#blow();
      if (look) this.#relook();
      if (changed.has('cameraOrbit')) this.#player.wishCamera(this.#drawn);
      if (changed.has('paused')) this.#run();
    });
  }

  protected override createRenderRoot(): HTMLElement | DocumentFragment {
    const root = super.createRenderRoot();
    this.#shadow = new ElementShadow(
      root,
      () => this.#toggle(),
      () => {
        if (this.#asks) this.dismissPoster();
      },
    );
    return root;
  }

  protected override update(changed: PropertyValues): void {
    super.update(changed);
    this.#shadow?.set({
      label: this.#label,
      turns: this.cameraControls,
      poster: this.#poster ? this.poster : null,
      asks: this.#asks,
      progress: this.#stage === 'loading' ? this.#progress : null,
      unable: this.#unable,
      message: this.#message,
      status: this.#said,
      controls: this.#drawn && !this.#poster,
      paused: this.paused,
    });
  }

  get #canvas(): HTMLCanvasElement {
    return (this.#shadow as ElementShadow).canvas;
  }

  /** The poster waits to be pressed. */
  get #asks(): boolean {
    return this.reveal === 'interaction' && this.#poster && this.#drawn;
  }

  get #label(): string {
    return this.alt ?? elementWords.alt(this.#loader.planted?.species.name ?? null, this.#blows.name);
  }

  #newPlayer(): TreePlayer {
    const element = this;
    return new TreePlayer({
      get cameraOrbit() {
        return element.cameraOrbit;
      },
      tell: (name, detail) => this.#tell(name, detail),
      seen: () => this.#seen(),
      lost: (lost) => this.#lose(lost),
      failed: (error) => this.#fault('fetch', String(error)),
      toggle: () => this.#toggle(),
    });
  }

  #newLoader(): TreeLoader {
    return new TreeLoader({
      wishes: this,
      get shipped() {
        return WindTreeElement.shipped;
      },
      open: (signal) => this.#open(signal),
      priority: () => (this.visible ? 0 : 1e6) + distanceToMiddle(this),
      report: (phase, progress) => this.#report(phase, progress),
      plant: (planted) => this.#plant(planted),
      blow: () => this.#blow(),
      failed: (type, message) => this.#fail(type, message),
      windFailed: (type, message) => this.#fault(type, message),
    });
  }

  #tell<Name extends keyof WindTreeEventDetails>(name: Name, detail: WindTreeEventDetails[Name]): void {
    this.dispatchEvent(new CustomEvent(name, { detail }));
  }

  #fault(type: ErrorType, message: string): void {
    const event = new CustomEvent('error', { detail: { type, message }, cancelable: true });
    // A slip in the markup must not go unheard where nobody listens; who does can prevent it.
    if (this.dispatchEvent(event)) console.warn(`<wind-tree${this.id && ` id="${this.id}"`}>: ${message}`);
  }

  /** What is wrong with the tree itself is also seen. */
  #fail(type: ErrorType, message: string): void {
    const { failed } = elementWords;
    this.#message = type in failed ? failed[type as keyof typeof failed] : failed.fetch;
    this.#said = this.#message;
    this.#unable = type === 'capability';
    this.#fault(type, message);
    this.#enter(this.#drawn ? 'ready' : 'error');
  }

  #enter(stage: Stage): void {
    this.#stage = stage;
    const { states } = this.#internals;
    for (const name of ['loading', 'ready', 'error'] as const) {
      if (name === stage) states.add(name);
      else states.delete(name);
    }
    this.#tell('statechange', { state: stage, paused: this.paused });
    this.requestUpdate();
  }

  #come(how: Nearness): void {
    const { visible } = this.#nearness;
    this.#nearness = how;
    if (how.visible !== visible) {
      this.#tell('visibility', { visible: how.visible });
      this.#player.show(how.visible);
    }
    if (how.far) this.#player.view?.rest();
    this.#loadIfNear();
  }

  #loadIfNear(): void {
    if (!this.#wantsTree || !this.isConnected || !this.hasUpdated) return;
    if (!this.#nearness.near && this.loading !== 'eager') return;
    this.#wantsTree = false;
    this.#message = '';
    if (!this.species && !this.src && !this.speciesData) {
      // What was on its way is no longer wanted; a tree that stands stays.
      this.#loader.cancel();
      if (this.#stage === 'loading') this.#enter(this.#drawn ? 'ready' : 'idle');
      return;
    }
    this.#said = elementWords.status.loading;
    this.#enter('loading');
    void this.#loader.load();
  }

  /** Hears what hands and keys ask of the camera: loaded with the first element that lets them. */
  async #listen(): Promise<void> {
    if (this.#listens) return;
    this.#listens = true;
    try {
      const { listenToOrbit } = await import('./orbit-input.ts');
      const enabled = (): boolean => this.cameraControls && this.#drawn && !this.#poster;
      listenToOrbit(this.#canvas, enabled, this.#player);
    } catch (error) {
      this.#listens = false;
      this.#fault('fetch', String(error));
    }
  }

  /** Loads what draws, and opens a view on it; null where it cannot, or is no longer wanted. */
  async #open(signal: AbortSignal): Promise<Drawing | null> {
    const { default: drawing } = await import('./drawing.ts');
    if (signal.aborted) return null;
    this.#drawing = drawing;
    try {
      this.#player.open(drawing, this.#canvas);
    } catch {
      this.#loader.stop();
      this.#fail('capability', elementWords.noWebGl);
      return null;
    }
    this.#relook();
    await this.#blow();
    if (signal.aborted) return null;
    this.#player.show(this.visible);
    return drawing;
  }

  #plant(planted: Planted): void {
    this.#report('draw', 0.97);
    this.#player.plant(planted);
  }

  /** Lets the wind blow as the attributes have it; what changes a wind is loaded when one of them asks for it. The latest wish wins. */
  async #blow(): Promise<void> {
    const { view } = this.#player;
    if (!view) return;
    const { windSpeed, windDirection, gust, model } = this;
    const wishes = [windSpeed, windDirection, gust, model];
    const wish = ++this.#windWish;
    const shape = wishes.every((each) => each === null) ? null : (await import('./element-wind.ts')).elementWind;
    if (wish !== this.#windWish || view !== this.#player.view) return;
    const { wind } = this.#loader;
    this.#blows = shape ? shape(wind, { windSpeed, windDirection, gust, model }) : wind;
    view.setWind(this.#blows, this.#runs ? FADE : 0);
    this.requestUpdate();
    this.#player.request();
  }

  #relook(): void {
    this.#player.setLook(lookOf(this, isDark(this)));
    void this.#drawing?.prepareDebug(this.debug).then(() => this.#player.request());
  }

  #report(phase: WindTreeEventDetails['progress']['phase'], progress: number): void {
    this.#progress = progress;
    this.#tell('progress', { phase, progress });
    this.requestUpdate();
  }

  /** The first picture of a tree is there. */
  #seen(): void {
    const first = !this.#drawn;
    this.#drawn = true;
    const { species, seed } = this.#loader.planted as Planted;
    const { triangles } = this.#player.figures;
    if (first && !this.#asked) {
      const still = this.hasAttribute('time') && !this.hasAttribute('autoplay');
      const less = matchMedia('(prefers-reduced-motion: reduce)').matches;
      if (!this.autoplay || still || less) this.paused = true;
    }
    if (this.#dismissed || (first && this.reveal === 'auto')) this.#poster = false;
    this.#said = elementWords.status.ready(triangles, this.capabilities?.reason ?? '');
    this.#report('draw', 1);
    this.#enter('ready');
    this.#run();
    this.#tell('load', { species: species.name, seed, triangles });
    void this.#drawing?.loadPick();
  }

  /** The reader sees the tree, and nobody holds it. */
  get #runs(): boolean {
    return !this.paused && this.#drawn && !this.#poster && !this.#player.lost;
  }

  /** Time runs or stands, as what has changed wants it. */
  #run(): void {
    const { states } = this.#internals;
    if (this.paused) states.add('paused');
    else states.delete('paused');
    if (this.#player.run(this.#runs)) this.#tell('statechange', { state: this.#stage, paused: this.paused });
    this.requestUpdate();
  }

  #toggle(): void {
    if (this.paused) this.play();
    else this.pause();
    this.#said = this.paused ? elementWords.status.paused : elementWords.status.playing;
  }

  #lose(lost: boolean): void {
    this.#said = lost ? elementWords.status.lost : elementWords.status.back;
    if (lost) this.#fault('contextlost', elementWords.status.lost);
    this.#run();
  }

  #shown() {
    const { planted } = this.#loader;
    if (!planted || !this.#drawn) throw new Error(elementWords.nothing);
    return { ...planted, wind: this.#blows, season: this.season };
  }
}
