import { html, type TemplateResult } from 'lit';
import { windFileWords } from '../words/wind-panel.ts';
import { icon } from './icons.ts';
import { Part } from './panel.ts';

/** The wind as JSON: to the clipboard and back, as a file and back. */
class WindFiles extends Part {
  protected override render(): TemplateResult {
    const { actions } = this.editor;
    const { record } = actions.edited().wind;
    return html`<div class="buttons">
        <button type="button" class="quiet" @click=${() => actions.copyWind()}>${icon('copy')}<span>${windFileWords.copy}</span></button>
        <button type="button" class="quiet" @click=${() => actions.saveWind()}>${icon('save')}<span>${windFileWords.download}</span></button>
      </div>
      <label class="paste"><span>${windFileWords.paste}</span>
        <textarea rows="2" spellcheck="false" placeholder=${windFileWords.pasteLike} @paste=${this.paste} @change=${this.typed}></textarea></label>
      <label class="button open-file">${icon('open')}<span>${windFileWords.open}</span>
        <input type="file" accept=".json,.csv,application/json,text/csv" class="spoken" @change=${this.open}></label>
      ${record ? html`<p class="soft">${windFileWords.measured(record.name)} <button type="button" class="text" @click=${() => actions.setRecord(null)}>${windFileWords.takeOut}</button></p>` : ''}`;
  }

  /** A paste is the whole of what is meant: it blows at once, and the box is free again. */
  private paste(event: ClipboardEvent): void {
    event.preventDefault();
    const text = event.clipboardData?.getData('text/plain') ?? '';
    const box = event.currentTarget as HTMLTextAreaElement;
    box.value = this.editor.actions.pasteWind(text) ? '' : text.slice(0, 2000);
  }

  private typed(event: Event): void {
    const box = event.currentTarget as HTMLTextAreaElement;
    if (box.value.trim() !== '' && this.editor.actions.pasteWind(box.value)) box.value = '';
  }

  private open(event: Event): void {
    const input = event.target as HTMLInputElement;
    const file = input.files?.[0];
    if (file) this.dispatchEvent(new CustomEvent('own-file', { detail: file, bubbles: true }));
    input.value = ''; // the same file can be chosen again after it was mended
  }
}

customElements.define('wg-wind-files', WindFiles);
