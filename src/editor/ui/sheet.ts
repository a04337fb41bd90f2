import { html, type TemplateResult } from 'lit';
import { DETENTS, PANELS, type Panel } from '../session.ts';
import { frameWords } from '../words/frame.ts';
import { Part } from './panel.ts';

/** The sheet at the foot of a narrow window: pulled by its handle to a third, two thirds or all of the height. */
class Sheet extends Part {
  private drag: { from: number; height: number; moved: boolean } | null = null;

  protected override render(): TemplateResult {
    const { detent, tab } = this.session;
    return html`<section class="sheet paper" data-detent=${detent} aria-label=${frameWords.controls}
      @pointerdown=${hold} @keydown=${(e: KeyboardEvent) => this.onTabKey(e)}>
      <button type="button" class="handle" aria-label=${frameWords.sheetHeight(frameWords.heights[detent])}
        @click=${() => this.cycle()} @keydown=${(e: KeyboardEvent) => this.onHandleKey(e)}
        @pointerdown=${(e: PointerEvent) => this.start(e)} @pointermove=${(e: PointerEvent) => this.move(e)}
        @pointerup=${(e: PointerEvent) => this.end(e)} @pointercancel=${() => this.cancel()}></button>
      <div role="tablist" aria-label=${frameWords.controls}>${PANELS.map(
        (p) => html`<button type="button" role="tab" id="tab-${p}" aria-controls="tab-panel" aria-selected=${p === tab}
          tabindex=${p === tab ? 0 : -1} @click=${() => this.choose(p)}>${frameWords.tabs[p]}</button>`,
      )}</div>
      <div role="tabpanel" id="tab-panel" aria-labelledby="tab-${tab}" tabindex="-1">${this.panel(tab)}</div>
    </section>`;
  }

  private panel(tab: Panel): TemplateResult {
    const { editor } = this;
    if (!this.session.panels) return html``;
    if (tab === 'grow') return html`<wg-grow .editor=${editor}></wg-grow>`;
    if (tab === 'wind') return html`<wg-wind .editor=${editor}></wg-wind>`;
    if (tab === 'studio') return html`<wg-studio .editor=${editor}></wg-studio>`;
    if (tab === 'time') return html`<wg-time .editor=${editor}></wg-time>`;
    return html`<wg-view .editor=${editor}></wg-view><wg-statistics .editor=${editor}></wg-statistics>`;
  }

  private choose(tab: Panel): void {
    this.editor.actions.setTab(tab);
    if (this.session.detent === 'bar') this.editor.actions.setDetent('third');
  }

  private onTabKey(event: KeyboardEvent): void {
    const { target } = event;
    // The studio in the sheet has tabs of its own.
    if (!(target instanceof HTMLElement) || target.role !== 'tab' || !target.id.startsWith('tab-')) return;
    const towards = { ArrowRight: 1, ArrowLeft: PANELS.length - 1 }[event.key];
    if (!towards) return;
    event.preventDefault();
    const next = PANELS[(PANELS.indexOf(this.session.tab) + towards) % PANELS.length]!;
    this.editor.actions.setTab(next);
    void this.updateComplete.then(() => this.querySelector<HTMLElement>(`#tab-${next}`)?.focus());
  }

  private onHandleKey(event: KeyboardEvent): void {
    const towards = { ArrowUp: 1, ArrowDown: -1 }[event.key];
    if (!towards) return;
    event.preventDefault();
    const at = DETENTS.indexOf(this.session.detent) + towards;
    this.editor.actions.setDetent(DETENTS[Math.min(DETENTS.length - 1, Math.max(0, at))]!);
  }

  private cycle(): void {
    if (this.drag?.moved) return; // the click at the end of a pull
    this.editor.actions.setDetent(DETENTS[(DETENTS.indexOf(this.session.detent) + 1) % DETENTS.length]!);
  }

  private start(event: PointerEvent): void {
    (event.currentTarget as HTMLElement).setPointerCapture(event.pointerId);
    this.drag = { from: event.clientY, height: this.sheet().offsetHeight, moved: false };
  }

  private move(event: PointerEvent): void {
    const { drag } = this;
    if (!drag || !(event.currentTarget as HTMLElement).hasPointerCapture(event.pointerId)) return;
    drag.moved ||= Math.abs(event.clientY - drag.from) > 4;
    if (drag.moved) this.sheet().style.height = `${drag.height + drag.from - event.clientY}px`;
  }

  private end(event: PointerEvent): void {
    if (!this.drag?.moved) {
      this.cancel();
      return;
    }
    const height = this.drag.height + this.drag.from - event.clientY;
    this.sheet().style.height = '';
    const share = height / window.innerHeight;
    const near = { bar: 0.12, third: 0.36, 'two-thirds': 0.66, all: 0.94 };
    const best = DETENTS.reduce((a, b) => (Math.abs(near[b] - share) < Math.abs(near[a] - share) ? b : a));
    this.editor.actions.setDetent(best);
    // The click that follows must still see that this was a pull.
    requestAnimationFrame(() => this.cancel());
  }

  private cancel(): void {
    this.sheet().style.height = '';
    this.drag = null;
  }

  private sheet(): HTMLElement {
    return this.querySelector<HTMLElement>('.sheet')!;
  }
}

/** While a slider, a dial or a point of a curve is held, the rest of the sheet steps back so that the tree is seen. */
function hold(event: PointerEvent): void {
  const held =
    event.target instanceof Element && event.target.closest('input[type="range"], .dial, .curve [data-drag]');
  if (!held) return;
  const field = held.closest('.field, .wave-head, .gust-head') ?? held;
  // A curve may stand in the row of its parameter or by itself.
  const stay = [field, held.closest('.curve') ?? field];
  const root = document.documentElement;
  root.classList.add('holding');
  for (const each of stay) each.classList.add('held');
  const release = (): void => {
    root.classList.remove('holding');
    for (const each of stay) each.classList.remove('held');
    window.removeEventListener('pointerup', release);
    window.removeEventListener('pointercancel', release);
  };
  window.addEventListener('pointerup', release);
  window.addEventListener('pointercancel', release);
}

customElements.define('wg-sheet', Sheet);
