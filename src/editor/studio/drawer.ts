import { html, nothing, type TemplateResult } from 'lit';
import '../styles/studio.css';
import { choice } from '../ui/choice.ts';
import { icon } from '../ui/icons.ts';
import { placeText } from '../words/probe.ts';
import { studioWords } from '../words/studio.ts';
import { mendLocale } from './safe-locale.ts';
import { StudioPart } from './studio-part.ts';
import { SPANS, type Span, STUDIO_TABS, type StudioTab } from './studio-state.ts';

/** Heights that the drawer can be pulled to, and the step of an arrow key; pixels. The tree keeps at least so much above it. */
const LOWEST = 160;
const STEP = 16;
const TREE = 320;

const highest = (): number => Math.max(LOWEST, window.innerHeight - TREE);
const within = (height: number): number => Math.round(Math.min(highest(), Math.max(LOWEST, height)));

/** The studio's drawer: over the time bar on a wide window, a tab of the sheet on a narrow one. Nothing is drawn while it is closed. */
class Drawer extends StudioPart {
  static override properties = { ...StudioPart.properties, loaded: { state: true } };
  /** Whether the panels have been loaded; words where they could not be. */
  declare loaded: boolean | string;
  /** Height of the body and place of the pointer together while the brim is pulled. */
  private held = 0;

  constructor() {
    super();
    this.loaded = false;
  }

  override connectedCallback(): void {
    super.connectedCallback();
    // In the sheet there is no closed drawer: who sees it has opened it.
    this.follow();
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    this.studio.store.setState({ open: false });
  }

  protected override willUpdate(): void {
    this.follow();
  }

  protected override render(): TemplateResult {
    const { open, tab } = this.state;
    const { narrow } = this.session;
    const height = narrow ? null : this.editor.preferences.studioHeight;
    return html`<section class="studio" aria-label=${studioWords.name} ?data-open=${open} style=${height === null ? nothing : `--studio: ${within(height)}px`}>
      ${open && !narrow ? this.brim() : nothing}
      <div class="studio-bar">
        ${narrow || open ? nothing : html`<span class="studio-name" aria-hidden="true">${studioWords.name}</span>`}
        <div role="tablist" aria-label=${studioWords.name} @keydown=${this.onKey}>${STUDIO_TABS.map(
          (t) => html`<button type="button" role="tab" id="studio-tab-${t}" aria-selected=${t === tab}
            aria-controls="studio-panel" tabindex=${t === tab ? 0 : -1} @click=${() => this.choose(t)}>${studioWords.tabs[t]}</button>`,
        )}</div>
        ${open ? this.probe() : nothing}
        ${open && (tab === 'plots' || tab === 'compare') ? this.tools() : nothing}
        ${
          narrow
            ? nothing
            : html`<button type="button" class="round" aria-expanded=${open} aria-controls="studio-panel"
                aria-label=${studioWords.name} title=${open ? studioWords.close : studioWords.open} @click=${this.turn}>
                ${icon('down')}</button>`
        }
      </div>
      <div role="tabpanel" id="studio-panel" class="studio-body" aria-labelledby="studio-tab-${tab}" ?hidden=${!open}>
        ${open ? this.panel(tab) : nothing}
      </div>
    </section>`;
  }

  /** The drawer's upper edge, to pull. */
  private brim(): TemplateResult {
    return html`<div class="brim" role="separator" tabindex="0" aria-orientation="horizontal" aria-label=${studioWords.height}
      aria-controls="studio-panel" aria-valuemin=${LOWEST} aria-valuemax=${highest()} aria-valuenow=${Math.round(this.height())}
      title=${studioWords.heightTitle}
      @pointerdown=${this.hold} @pointermove=${this.pull} @keydown=${this.onBrimKey} @dblclick=${() => this.size(null)}></div>`;
  }

  private height(): number {
    return (
      this.querySelector<HTMLElement>('.studio-body')?.offsetHeight || (this.editor.preferences.studioHeight ?? LOWEST)
    );
  }

  private size(height: number | null): void {
    this.editor.actions.setStudioHeight(height === null ? null : within(height));
    this.requestUpdate();
  }

  private readonly hold = (event: PointerEvent): void => {
    if (event.button !== 0) return;
    (event.currentTarget as HTMLElement).setPointerCapture(event.pointerId);
    this.held = this.height() + event.clientY;
  };

  private readonly pull = (event: PointerEvent): void => {
    if ((event.currentTarget as HTMLElement).hasPointerCapture(event.pointerId)) this.size(this.held - event.clientY);
  };

  private onBrimKey(event: KeyboardEvent): void {
    const towards = { ArrowUp: 1, ArrowDown: -1 }[event.key];
    if (!towards) return;
    event.preventDefault();
    this.size(this.height() + towards * STEP);
  }

  private panel(tab: StudioTab): TemplateResult {
    const { editor } = this;
    if (typeof this.loaded === 'string') return html`<p class="studio-empty">${studioWords.failed(this.loaded)}</p>`;
    if (!this.loaded) return html`<p class="studio-empty">${studioWords.opening}</p>`;
    if (!this.state.place) return html`<p class="studio-empty">${studioWords.noTree}</p>`;
    if (tab === 'plots') return html`<wg-studio-plots .editor=${editor}></wg-studio-plots>`;
    if (tab === 'field') return html`<wg-studio-field .editor=${editor}></wg-studio-field>`;
    if (tab === 'textures') return html`<wg-studio-textures .editor=${editor}></wg-studio-textures>`;
    if (tab === 'compare') return html`<wg-studio-compare .editor=${editor}></wg-studio-compare>`;
    return html`<wg-studio-anemometer .editor=${editor}></wg-studio-anemometer>`;
  }

  private probe(): TemplateResult | typeof nothing {
    const { place, catchingUp } = this.state;
    if (!place) return nothing;
    const chosen = this.doc.probe !== null;
    return html`<p class="probe-place">${
      chosen
        ? html`${studioWords.probeAt(placeText(place))} <button type="button" class="text" @click=${() => this.editor.actions.setProbe(null)}>${studioWords.putBack}</button>`
        : html`${studioWords.probeAt(placeText(place))}. <span class="soft">${this.session.narrow ? studioWords.tapAnother : studioWords.clickAnother}</span>`
    }${catchingUp === null ? nothing : html` <span class="soft">${studioWords.past(catchingUp)}</span>`}</p>`;
  }

  private tools(): TemplateResult {
    const { span, frozen, tab } = this.state;
    const { store } = this.studio;
    return html`<div class="studio-tools">${choice({
      name: 'span',
      legend: studioWords.span,
      quiet: true,
      value: String(span),
      options: SPANS.map((s) => ({ value: String(s), label: `${s}\u2009s` })),
      onChoose: (value) => store.setState({ span: Number(value) as Span }),
    })}
    ${
      tab === 'plots'
        ? html`<button type="button" class="quiet" aria-pressed=${frozen} title=${studioWords.holdTitle}
            @click=${() => store.setState({ frozen: !frozen })}>${icon(frozen ? 'play' : 'pause')}<span>${frozen ? studioWords.held : studioWords.hold}</span></button>`
        : nothing
    }</div>`;
  }

  private follow(): void {
    const { narrow, detent } = this.session;
    const open = narrow ? detent !== 'bar' : (this.editor.preferences.folds.studio ?? false);
    if (open !== this.state.open) this.studio.store.setState({ open });
    if (open && this.loaded === false) void this.load();
  }

  /** Who does not open the drawer does not wait for its panels and the plotting library. */
  private async load(): Promise<void> {
    try {
      mendLocale();
      await import('./panels.ts');
      this.loaded = true;
    } catch (error) {
      this.loaded = error instanceof Error ? error.message : String(error);
    }
  }

  private turn(): void {
    this.editor.actions.setFold('studio', !this.state.open);
    this.follow();
  }

  private choose(tab: StudioTab): void {
    this.studio.store.setState({ tab });
    if (!this.session.narrow && !this.state.open) this.turn();
  }

  private onKey(event: KeyboardEvent): void {
    const at = STUDIO_TABS.indexOf(this.state.tab);
    const last = STUDIO_TABS.length - 1;
    const next = { ArrowRight: at === last ? 0 : at + 1, ArrowLeft: at === 0 ? last : at - 1, Home: 0, End: last }[
      event.key
    ];
    if (next === undefined) return;
    event.preventDefault();
    this.choose(STUDIO_TABS[next]!);
    void this.updateComplete.then(() => this.querySelector<HTMLElement>(`#studio-tab-${STUDIO_TABS[next]!}`)?.focus());
  }
}

customElements.define('wg-studio', Drawer);
