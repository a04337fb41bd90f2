import { html, type PropertyValues, type TemplateResult } from 'lit';
import { fileWords } from '../words/files.ts';
import { menu, menuItem } from './menu.ts';
import { Part } from './panel.ts';

/** New, open, save; and where the work is kept. */
class FileMenu extends Part {
  protected override render(): TemplateResult {
    const { editor } = this;
    const { fileName, changed } = this.session;
    const words = fileWords.menu;
    const label = fileName === null ? words.label : words.labelOf(fileName, changed);
    const content = html`${menuItem(editor, 'new', 'plus')}${menuItem(editor, 'open', 'open')}<hr>
      ${menuItem(editor, 'save', 'save')}${menuItem(editor, 'saveAs', 'copy')}<hr>${this.state()}`;
    return menu({ id: 'file-menu', icon: 'open', label: words.label, title: label, content });
  }

  protected override updated(changes: PropertyValues): void {
    super.updated(changes);
    this.toggleAttribute('data-changed', this.session.changed);
  }

  /** Where the work is kept: in a file, and by the browser. */
  private state(): TemplateResult {
    const { fileName, changed, saved } = this.session;
    const words = fileWords.menu;
    const inFile = fileName === null ? words.noFile : changed ? words.changedSince(fileName) : words.inFile(fileName);
    return html`<p class="file-state"><span>${inFile}</span><span data-failed=${saved === 'failed'}>${words[saved]}</span></p>`;
  }
}

customElements.define('wg-file-menu', FileMenu);
