import { html, nothing, type TemplateResult } from 'lit';
import { compareWords } from '../words/wind.ts';
import { Part } from './panel.ts';

/** Part of the width that an arrow key moves the line, and with Shift. */
const STEP = 0.01;
const COARSE = 0.1;
/** The line never leaves the picture. */
const EDGE = 0.02;

/** Two winds on one tree: which side is which, and the line between them. */
class CompareLayer extends Part {
  protected override render(): TemplateResult | typeof nothing {
    const { compare, wind } = this.doc;
    if (!compare) return nothing;
    const { insets } = this.session;
    // The line is drawn in the picture: a part of its whole width, or the middle of what the panels leave of it.
    const side = compare.layout === 'side';
    const middle = `${insets.left}px + (100vw - ${insets.left + insets.right}px) / 2`;
    const at = side ? `calc(${middle})` : `${100 * compare.at}vw`;
    const per = Math.round(100 * compare.at);
    return html`<section class="compared" aria-label=${compareWords.two} style="top: ${insets.top}px; bottom: ${insets.bottom}px; --at: ${at}">
      <p class="side-name a" data-edited=${this.session.side === 'A'}><b>A</b> ${wind.name}</p>
      <p class="side-name b" data-edited=${this.session.side === 'B'}><b>B</b> ${compare.wind.name}</p>
      ${
        side
          ? nothing
          : html`<span class="divider" role="slider" tabindex="0" aria-label=${compareWords.line} aria-orientation="horizontal"
            aria-valuemin="0" aria-valuemax="100" aria-valuenow=${per} aria-valuetext=${compareWords.share(per)}
            title=${compareWords.drag} @pointerdown=${this.hold} @pointermove=${this.pull}
            @keydown=${(e: KeyboardEvent) => this.onKey(e, compare.at)}>↔</span>`
      }
    </section>`;
  }

  private readonly hold = (event: PointerEvent): void => {
    if (event.button === 0) (event.currentTarget as HTMLElement).setPointerCapture(event.pointerId);
  };

  private readonly pull = (event: PointerEvent): void => {
    const divider = event.currentTarget as HTMLElement;
    if (!divider.hasPointerCapture(event.pointerId)) return;
    this.set(event.clientX / window.innerWidth);
  };

  private onKey(event: KeyboardEvent, at: number): void {
    const towards = { ArrowRight: 1, ArrowUp: 1, ArrowLeft: -1, ArrowDown: -1 }[event.key];
    if (!towards) return;
    event.preventDefault();
    this.set(at + towards * (event.shiftKey ? COARSE : STEP));
  }

  private set(at: number): void {
    // Behind the panels nobody could take hold of it again.
    const { left, right } = this.session.insets;
    const width = window.innerWidth;
    const [low, high] = [left / width + EDGE, 1 - right / width - EDGE];
    this.editor.actions.setCompareAt(Math.min(high, Math.max(low, at)));
  }
}

customElements.define('wg-compare', CompareLayer);
