import { html, type TemplateResult } from 'lit';
import { type LoopedWind, loopPeriod, loopWind } from '../../core/wind/loop.ts';
import type { Wind } from '../../core/wind/wind.ts';
import { loopWords } from '../words/time.ts';
import { icon } from './icons.ts';
import { Part } from './panel.ts';

/** Seconds that a loop may take. */
const LEAST = 1;
const MOST = 600;

/** Makes the wind come around every so many seconds, for a film without a seam. */
class LoopMaker extends Part {
  private seconds = 10;
  private made: { readonly wind: Wind; readonly looped: LoopedWind } | null = null;
  private looked: { readonly wind: Wind; readonly period: number | null } | null = null;

  protected override render(): TemplateResult {
    return html`<button type="button" class="quiet" popovertarget="loop-maker" title=${loopWords.title}>
        ${icon('loop')}<span>${loopWords.loop}</span></button>
      <div popover id="loop-maker" class="pop paper" role="group" aria-label=${loopWords.loop} @toggle=${() => this.requestUpdate()}>
        <form @submit=${this.make}><label for="loop-seconds">${loopWords.every}</label>
          <span class="amount"><input type="number" id="loop-seconds" min=${LEAST} max=${MOST} step="any" required .value=${String(this.seconds)}
            @change=${this.typed}><span class="unit">s</span></span>
          <button type="submit" class="button">${loopWords.make}</button></form>
        <p class="soft" role="status">${this.words()}</p>
      </div>`;
  }

  private words(): string {
    const { wind } = this.editor.actions.edited();
    if (this.made?.wind === wind) {
      const { change, open } = this.made.looped;
      return [loopWords.done(change), ...open.map((gap) => loopWords.seam[gap])].join(' ');
    }
    // Looking for a period takes a moment: only who asks for it pays.
    if (!this.querySelector('[popover]')?.matches(':popover-open')) return '';
    if (this.looked?.wind !== wind) this.looked = { wind, period: loopPeriod(wind) };
    const { period } = this.looked;
    const now = period === null ? loopWords.never : period === 0 ? loopWords.still : loopWords.now(period);
    return `${now} ${loopWords.how}`;
  }

  private typed(event: Event): void {
    const box = event.target as HTMLInputElement;
    if (box.validity.valid && box.value !== '') this.seconds = box.valueAsNumber;
    else box.value = String(this.seconds);
  }

  private make(event: Event): void {
    event.preventDefault();
    const { actions } = this.editor;
    const looped = actions.loopEvery(this.seconds, loopWind);
    this.made = { wind: actions.edited().wind, looped };
    this.requestUpdate();
  }
}

customElements.define('wg-loop', LoopMaker);
