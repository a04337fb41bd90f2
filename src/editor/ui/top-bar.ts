import { html, nothing, type TemplateResult } from 'lit';
import { type CommandId, command, withKeys } from '../shortcuts.ts';
import { topWords } from '../words/top-bar.ts';
import './file-menu.ts';
import { type Icon, icon } from './icons.ts';
import { menu, menuItem } from './menu.ts';
import { Part } from './panel.ts';
import './view-panel.ts';

/** The name of the tree, and what is done with the whole of it: undo, keep, share, take away, look. */
class TopBar extends Part {
  protected override render(): TemplateResult {
    return this.session.narrow ? this.narrow() : this.wide();
  }

  private heading(): TemplateResult {
    const { tree, growing } = this.session;
    const name = tree?.species.name ?? growing?.name ?? topWords.app;
    return html`<div class="title"><h1 title=${name}>${name}</h1>
      <p>${tree ? html`<i lang="la">${tree.species.latin}</i> <span class="seed-read">${topWords.seed(tree.seed)}</span>` : nothing}</p></div>`;
  }

  private wide(): TemplateResult {
    const { editor } = this;
    return html`${this.heading()}
      <div class="tools paper" role="group" aria-label=${topWords.tools}>
        <div class="tool-group steps">${this.undo()}${this.round('history', 'history')}</div>
        <div class="tool-group whole-tree"><wg-file-menu .editor=${editor}></wg-file-menu>
          ${menu({ id: 'share-menu', icon: 'share', label: topWords.share, title: topWords.shareTitle, content: this.share() })}
          ${this.worded('export', 'export', topWords.export, topWords.exportTitle)}
          ${this.worded('variety', 'many', topWords.variety, topWords.varietyTitle)}</div>
        <wg-view .editor=${editor} class="tool-group"></wg-view>
        <div class="tool-group finding">${this.round('gallery', 'leaf')}${this.round('palette', 'find')}${this.round('help', 'help')}</div>
      </div>`;
  }

  private narrow(): TemplateResult {
    const { editor, doc } = this;
    const says = doc.paused ? topWords.play : topWords.pause;
    return html`${this.heading()}
      <div class="buttons"><span class="steps">${this.undo()}</span>
        <button type="button" class="round" aria-label=${says} @click=${() => editor.actions.toggle()}>${icon(doc.paused ? 'play' : 'pause')}</button>
        ${menu({ id: 'more-menu', icon: 'more', label: topWords.more, quiet: true, content: this.more() })}
      </div>`;
  }

  private more(): TemplateResult {
    const { editor } = this;
    return html`<wg-file-menu .editor=${editor}></wg-file-menu>
      ${menuItem(editor, 'share', 'link')}${menuItem(editor, 'embed', 'code')}<hr>
      ${menuItem(editor, 'history', 'history')}${menuItem(editor, 'gallery', 'leaf')}${menuItem(editor, 'variety', 'many')}${menuItem(editor, 'export', 'export')}<hr>
      ${menuItem(editor, 'palette', 'find')}${menuItem(editor, 'tour', 'walk')}${menuItem(editor, 'help', 'help')}`;
  }

  private share(): TemplateResult {
    const { editor } = this;
    return html`${menuItem(editor, 'share', 'link')}${menuItem(editor, 'embed', 'code')}<p>${topWords.shareHelp}</p>`;
  }

  /** They say what would come back, not only that something would. */
  private undo(): TemplateResult {
    const { canUndo, canRedo } = this.session;
    return html`${this.round('undo', 'undo', canUndo ? topWords.undo(this.editor.actions.undoText()) : topWords.nothingToUndo)}
      ${this.round('redo', 'redo', canRedo ? topWords.redo(this.editor.actions.redoText()) : topWords.nothingToRedo)}`;
  }

  private round(id: CommandId, sign: Icon, says?: string): TemplateResult {
    const { act, enabled } = command(id);
    const title = withKeys(id, says);
    return html`<button type="button" class="round" title=${title} aria-label=${title}
      ?disabled=${!(enabled?.(this.editor) ?? true)} @click=${() => act?.(this.editor)}>${icon(sign)}</button>`;
  }

  private worded(id: CommandId, sign: Icon, label: string, title: string): TemplateResult {
    return html`<button type="button" class="quiet" title=${withKeys(id, title)} @click=${() => command(id).act?.(this.editor)}>
      ${icon(sign)}<span>${label}</span></button>`;
  }
}

customElements.define('wg-top', TopBar);
