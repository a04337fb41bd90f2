import { html, type TemplateResult } from 'lit';
import { repeat } from 'lit/directives/repeat.js';
import type { Notice } from '../session.ts';
import { frameWords } from '../words/frame.ts';
import { icon } from './icons.ts';
import { Part } from './panel.ts';

/** Messages, and what is growing. */
class Notices extends Part {
  private take({ id, offer }: Notice): void {
    this.editor.actions.dismiss(id);
    offer?.act();
  }

  protected override render(): TemplateResult {
    const { notices, growing, tree, spoken } = this.session;
    const { actions } = this.editor;
    return html`
      <p class="spoken" role="status" aria-live="polite">${spoken}</p>
      ${
        growing
          ? html`<p class="growing"><span>${frameWords.growing(growing.name)}…</span>
          <progress max="1" .value=${growing.progress} aria-label=${frameWords.growing(growing.name)}></progress>
          ${tree ? html`<button type="button" class="text" @click=${() => actions.cancelGrowing()}>${frameWords.stop}</button>` : ''}</p>`
          : ''
      }
      <div role="alert" class="strips">${repeat(
        notices,
        (n) => n.id,
        (n) => html`<div class="strip" data-kind=${n.kind}>
          <div><strong><span class="kind">${frameWords.kinds[n.kind]}</span> ${n.title}</strong>
            ${n.lines.length ? html`<ul>${n.lines.map((line) => html`<li>${line}</li>`)}</ul>` : ''}
            ${n.offer ? html`<button type="button" class="text" @click=${() => this.take(n)}>${n.offer.label}</button>` : ''}</div>
          <button type="button" class="round" aria-label=${frameWords.closeMessage} @click=${() => actions.dismiss(n.id)}>${icon('close')}</button>
        </div>`,
      )}</div>`;
  }
}

customElements.define('wg-notices', Notices);
