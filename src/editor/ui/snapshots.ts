import { html, type TemplateResult } from 'lit';
import { repeat } from 'lit/directives/repeat.js';
import { LONGEST_SNAPSHOT_NAME } from '../../core/project/limits.ts';
import type { Snapshot } from '../session.ts';
import { historyWords } from '../words/history.ts';
import { icon } from './icons.ts';
import { Part } from './panel.ts';

/** Named states with small pictures: take, open, rename, delete. */
class Snapshots extends Part {
  protected override render(): TemplateResult {
    const { snapshots } = this.session;
    return html`<button type="button" class="button take" @click=${() => this.editor.actions.takeSnapshot('')}>
        ${icon('plus')}<span>${historyWords.take}</span></button>
      ${snapshots.length === 0 ? html`<p class="soft">${historyWords.noSnapshots}</p>` : ''}
      <ul class="snapshots">${repeat(
        snapshots,
        ({ id }) => id,
        (snapshot) => this.card(snapshot),
      )}</ul>`;
  }

  private card({ id, name, when, thumbnail }: Snapshot): TemplateResult {
    const { actions } = this.editor;
    const rename = (event: Event): void => {
      const box = event.target as HTMLInputElement;
      actions.renameSnapshot(id, box.value);
      // What cannot be a name goes, and the last one comes back.
      box.value = this.session.snapshots.find((s) => s.id === id)?.name ?? name;
    };
    return html`<li class="snapshot">
      <button type="button" class="snapshot-picture" aria-label=${historyWords.open(name)} title=${historyWords.open(name)}
        @click=${() => actions.openSnapshot(id)}>${
          thumbnail
            ? html`<img src=${thumbnail} alt="" width="96" height="72">`
            : html`<span class="soft">${historyWords.noPicture}</span>`
        }</button>
      <div><input type="text" class="snapshot-name" aria-label=${historyWords.renameOf(name)} title=${historyWords.rename} .value=${name}
          maxlength=${LONGEST_SNAPSHOT_NAME} spellcheck="false" autocomplete="off" @change=${rename}
          @keydown=${(e: KeyboardEvent) => e.key === 'Enter' && (e.target as HTMLElement).blur()}>
        <time class="soft" datetime=${new Date(when).toISOString()}>${historyWords.when(when)}</time></div>
      <button type="button" class="round" aria-label=${historyWords.removeOf(name)} title=${historyWords.remove}
        @click=${() => actions.deleteSnapshot(id)}>${icon('bin')}</button>
    </li>`;
  }
}

customElements.define('wg-snapshots', Snapshots);
