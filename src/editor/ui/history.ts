import { html, nothing, type PropertyValues, type TemplateResult } from 'lit';
import { changeLabel } from '../history-label.ts';
import { namesIn } from '../history-names.ts';
import { historyWords, stepWords } from '../words/history.ts';
import { Part } from './panel.ts';
import './snapshots.ts';

/** What was done, step by step, and named states: click one and the tree is there. */
class History extends Part {
  /** Line that the arrow keys have reached; null: the present one. */
  private at: number | null = null;
  private shown = -1;
  private stop: (() => void) | null = null;

  override connectedCallback(): void {
    super.connectedCallback();
    this.at = null;
    this.shown = -1;
    // Which steps there are is known a moment after the document changes.
    this.stop = this.editor.document.history.subscribe(() => this.requestUpdate());
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    this.stop?.();
  }

  protected override render(): TemplateResult {
    return html`<section aria-labelledby="snapshots-title"><h3 id="snapshots-title">${historyWords.snapshots}</h3>
        <wg-snapshots .editor=${this.editor}></wg-snapshots></section>
      <section aria-labelledby="steps-title"><h3 id="steps-title">${historyWords.steps}</h3>${this.steps()}</section>`;
  }

  private steps(): TemplateResult {
    const { history } = this.editor.document;
    const { states, index } = history;
    if (states.length === 1) return html`<p class="soft">${historyWords.empty}</p>`;
    const names = namesIn(this.editor.session);
    const focused = Math.min(states.length - 1, this.at ?? index);
    return html`<p class="soft">${historyWords.stepsHelp}</p>
      <ol class="steps-list" @keydown=${(e: KeyboardEvent) => this.onKey(e, focused, states.length)}>${states.map(
        (state, i) => html`<li><button type="button" class="step" tabindex=${i === focused ? 0 : -1}
          aria-current=${i === index ? 'step' : nothing} ?data-later=${i > index} ?autofocus=${i === index}
          @click=${() => this.go(i)}><span>${i === 0 ? stepWords.start : changeLabel(states[i - 1]!, state, names)}</span>${
            i === index ? html`<small>${historyWords.present}</small>` : nothing
          }${i > index ? html`<small>${historyWords.later}</small>` : nothing}</button></li>`,
      )}</ol>`;
  }

  protected override updated(changes: PropertyValues): void {
    super.updated(changes);
    const { index } = this.editor.document.history;
    if (index === this.shown) return;
    this.shown = index;
    this.querySelector('[aria-current="step"]')?.scrollIntoView({ block: 'nearest' });
  }

  private go(index: number): void {
    this.at = null;
    this.editor.actions.goTo(index);
  }

  private onKey(event: KeyboardEvent, at: number, count: number): void {
    const to = { ArrowDown: at + 1, ArrowUp: at - 1, Home: 0, End: count - 1 }[event.key];
    if (to === undefined || event.ctrlKey || event.metaKey || event.altKey) return;
    event.preventDefault();
    this.at = Math.min(count - 1, Math.max(0, to));
    this.requestUpdate();
    void this.updateComplete.then(() => this.querySelector<HTMLElement>('.step[tabindex="0"]')?.focus());
  }
}

customElements.define('wg-history', History);
