import { html, type TemplateResult } from 'lit';
import { repeat } from 'lit/directives/repeat.js';
import { icon } from './icons.ts';
import { Part } from './panel.ts';

const kinds = { error: 'Error', warning: 'Note', note: 'Note' } as const;

/** Messages, and what is growing. */
class Notices extends Part {
  protected override render(): TemplateResult {
    const { notices, growing, tree, spoken } = this.session;
    const { actions } = this.editor;
    return html`
      <p class="spoken" role="status" aria-live="polite">${spoken}</p>
      ${
        growing
          ? html`<p class="growing"><span>Growing ${growing.name}…</span>
          <progress max="1" .value=${growing.progress} aria-label="Growing ${growing.name}"></progress>
          ${tree ? html`<button type="button" class="text" @click=${() => actions.cancelGrowing()}>Stop</button>` : ''}</p>`
          : ''
      }
      <div role="alert" class="strips">${repeat(
        notices,
        (n) => n.id,
        (n) => html`<div class="strip" data-kind=${n.kind}>
          <div><strong><span class="kind">${kinds[n.kind]}:</span> ${n.title}</strong>
            ${n.lines.length ? html`<ul>${n.lines.map((line) => html`<li>${line}</li>`)}</ul>` : ''}</div>
          <button type="button" class="round" aria-label="Close this message" @click=${() => actions.dismiss(n.id)}>${icon('close')}</button>
        </div>`,
      )}</div>`;
  }
}

customElements.define('wg-notices', Notices);
