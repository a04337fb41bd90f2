import { html, type PropertyValues, type TemplateResult } from 'lit';
import { LINK_NUMBERS } from '../../core/link/numbers.ts';
import type { Wind } from '../../core/wind/wind.ts';
import { gustMarks } from './gust-marks.ts';
import { icon } from './icons.ts';
import './loop-maker.ts';
import { withKeys } from '../shortcuts.ts';
import { timeWords } from '../words/time.ts';
import { gustWords } from '../words/wind.ts';
import { numberField } from './number-field.ts';
import { Part } from './panel.ts';
import { waveform } from './waveform.ts';

/** Seconds that the ruler shows; it turns the page when time runs out of it. */
const PAGE = 30;

/** Time: play, pause, step, how fast, and a ruler to scrub, under the force of the wind at the foot of the tree. */
class TimeBar extends Part {
  private stopTicking = (): void => {};
  private page = 0;
  /** The waveform is drawn anew only when what it shows has changed. */
  private drawn: { wind: Wind; page: number; blowing: boolean; picture: TemplateResult } | null = null;

  override connectedCallback(): void {
    super.connectedCallback();
    this.stopTicking = this.editor.onFrame((time) => this.tick(time));
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    this.stopTicking();
  }

  protected override render(): TemplateResult {
    const { editor } = this;
    this.page = Math.floor(editor.actions.time() / PAGE);
    return html`${this.transport()}
      <div class="ruler">
        ${this.wave()}
        <input type="range" id="scrub" aria-label=${timeWords.time} min=${this.page * PAGE} max=${(this.page + 1) * PAGE} step="any"
          @input=${(e: Event) => editor.actions.seek((e.target as HTMLInputElement).valueAsNumber)}
          @keydown=${(e: KeyboardEvent) => this.nudge(e)}>
        ${gustMarks(editor, editor.actions.edited().wind.gusts, this.page * PAGE, PAGE)}
        <div class="marks" aria-hidden="true">${[0, 5, 10, 15, 20, 25, 30].map(
          (s) => html`<span style="left: ${(100 * s) / PAGE}%">${this.page * PAGE + s}</span>`,
        )}</div>
        ${this.catchingUp()}
      </div>
      <span class="amount clock"><input type="number" id="time" aria-label=${timeWords.timeNumber} min="0" max=${LINK_NUMBERS.t.max}
        step="any" @change=${(e: Event) => this.typed(e)}><span class="unit" aria-hidden="true">s</span></span>
      ${this.rate()}
      <div class="buttons deeds">
        <button type="button" class="quiet" title=${withKeys('gust', gustWords.throwTitle)} @click=${() => editor.actions.throwGust()}>
          ${icon('gust')}<span>${gustWords.throw}</span></button>
        <wg-loop .editor=${editor}></wg-loop>
      </div>`;
  }

  protected override updated(changes: PropertyValues): void {
    super.updated(changes);
    this.tick(this.editor.actions.time());
  }

  private transport(): TemplateResult {
    const { doc, editor } = this;
    const { actions } = editor;
    const slow = doc.rate < 1;
    const says = doc.paused ? timeWords.play : timeWords.pause;
    return html`<div class="transport">
      <button type="button" class="round" @click=${() => actions.step(-1)} aria-label=${timeWords.back} title=${withKeys('stepBack', timeWords.backTitle)}>
        ${icon('back')}</button>
      <button type="button" class="round" @click=${() => actions.toggle()}
        aria-label=${says} title=${withKeys('play', says)}>
        ${icon(doc.paused ? 'play' : 'pause')}</button>
      <button type="button" class="round" @click=${() => actions.step(1)} aria-label=${timeWords.step}
        title=${withKeys('stepOn', timeWords.stepTitle)}>${icon('step')}</button>
      <button type="button" class="round slow" aria-pressed=${slow} @click=${() => actions.toggleSlow()} aria-label=${timeWords.slow}
        title=${withKeys('slow', timeWords.slowTitle)}><span aria-hidden="true">¼×</span></button>
    </div>`;
  }

  private rate(): TemplateResult {
    return numberField({
      ...LINK_NUMBERS.rate,
      id: 'rate',
      label: timeWords.speed,
      name: timeWords.speedName,
      value: this.doc.rate,
      step: 0.05,
      reset: 1,
      onInput: (rate) => this.editor.actions.setRate(rate),
    });
  }

  private wave(): TemplateResult {
    const { blowing } = this.doc;
    const { wind } = this.editor.actions.edited();
    const { drawn, page } = this;
    if (drawn?.wind !== wind || drawn.page !== page || drawn.blowing !== blowing) {
      this.drawn = { wind, page, blowing, picture: waveform(wind, blowing, page * PAGE, PAGE) };
    }
    return this.drawn!.picture;
  }

  /** After a far jump a tree that remembers its past has to live through it first. */
  private catchingUp(): TemplateResult | '' {
    const { catchingUp } = this.session;
    if (catchingUp === null) return '';
    return html`<p class="catching-up"><progress max="1" .value=${catchingUp} aria-label=${timeWords.catching}></progress>
      <span>${timeWords.catchingUp(catchingUp)}</span></p>`;
  }

  /** Follows the clock without drawing the whole part again. */
  private tick(time: number): void {
    if (Math.floor(time / PAGE) !== this.page) {
      this.requestUpdate();
      return;
    }
    const ruler = this.querySelector<HTMLInputElement>('#scrub');
    const box = this.querySelector<HTMLInputElement>('#time');
    if (!ruler || !box) return;
    ruler.value = String(time);
    ruler.style.setProperty('--filled', `${((100 * (time % PAGE)) / PAGE).toFixed(3)}%`);
    ruler.setAttribute('aria-valuetext', timeWords.spoken(time));
    if (document.activeElement !== box) box.value = time.toFixed(2);
  }

  /** Arrows move by a step of the clock, with Shift by a second: the slider's own step would be of the page. */
  private nudge(event: KeyboardEvent): void {
    const towards = { ArrowUp: 1, ArrowRight: 1, ArrowDown: -1, ArrowLeft: -1 }[event.key];
    if (!towards) return;
    event.preventDefault();
    const { actions } = this.editor;
    actions.seek(Math.max(0, actions.time() + towards * (event.shiftKey ? 1 : 1 / 60)));
  }

  private typed(event: Event): void {
    const box = event.target as HTMLInputElement;
    if (box.value !== '' && box.validity.valid) this.editor.actions.seek(box.valueAsNumber);
    box.value = this.editor.actions.time().toFixed(2);
  }
}

customElements.define('wg-time', TimeBar);
