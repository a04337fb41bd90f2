import { html, nothing, type TemplateResult } from 'lit';
import { frameWords } from '../words/frame.ts';
import './dialogs.ts';
import './notices.ts';
import './sheet.ts';
import './top-bar.ts';
import { icon } from './icons.ts';
import { loadPanels } from './load-panels.ts';
import { Part } from './panel.ts';
import { growWidth, panelEdge } from './panel-edge.ts';

/** The whole interface over the picture: panels at the sides, or one sheet where the window is narrow. */
class App extends Part {
  private readonly onResize = (): void => this.requestUpdate();
  private photo = false;
  private photoLoaded = false;
  /** What had the focus before photo mode. */
  private from: HTMLElement | null = null;

  override connectedCallback(): void {
    super.connectedCallback();
    window.addEventListener('resize', this.onResize);
    // Only links from the time when the editor itself stood in frames ask for it.
    if (this.session.embed) void import('./embed.ts').then(() => this.requestUpdate());
    else loadPanels(this.editor);
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    window.removeEventListener('resize', this.onResize);
  }

  protected override render(): TemplateResult {
    const { editor } = this;
    // It comes with the panels: what is compared is rarely what is seen first.
    const compared = customElements.get('wg-compare') ? html`<wg-compare .editor=${editor}></wg-compare>` : nothing;
    if (this.session.embed)
      return html`${compared}${this.messages()}${customElements.get('wg-embed') ? html`<wg-embed .editor=${editor}></wg-embed>` : nothing}`;
    return html`${compared}
      <header class="top"><wg-top .editor=${editor}></wg-top></header>
      ${this.session.narrow ? html`<wg-sheet .editor=${editor}></wg-sheet>` : this.wide()}
      ${this.messages()}${this.hint()}
      ${this.session.panels ? html`<wg-stem .editor=${editor}></wg-stem>` : nothing}
      ${this.session.photo && this.photoLoaded ? html`<wg-photo .editor=${editor}></wg-photo>` : nothing}
      <wg-dialogs .editor=${editor}></wg-dialogs>`;
  }

  protected override willUpdate(): void {
    const { photo } = this.session;
    if (photo === this.photo) return;
    this.photo = photo;
    document.documentElement.classList.toggle('photo', photo);
    if (photo) void this.openPhoto();
    else if (this.from?.isConnected) this.from.focus();
  }

  private async openPhoto(): Promise<void> {
    this.from = document.activeElement instanceof HTMLElement ? document.activeElement : null;
    try {
      await import('../photo/photo-mode.ts');
      this.photoLoaded = true;
      this.requestUpdate();
    } catch (error) {
      this.editor.actions.setPhoto(false);
      this.editor.actions.notify('error', frameWords.photoFailed, [
        error instanceof Error ? error.message : String(error),
      ]);
    }
  }

  protected override updated(): void {
    // Messages and the hint stand clear of the panel, however wide it was pulled.
    this.style.setProperty('--grow', `${growWidth(this.editor)}px`);
  }

  private messages(): TemplateResult {
    return html`<section class="messages" aria-label=${frameWords.messages}><wg-notices .editor=${this.editor}></wg-notices></section>`;
  }

  private hint(): TemplateResult | typeof nothing {
    const { hint, throwing, offer } = this.session;
    const { actions } = this.editor;
    if (throwing)
      return html`<section class="hint" aria-label=${frameWords.throwing}><p>${frameWords.throwHint}
        <button type="button" class="text" @click=${() => actions.setThrowing(false)}>${frameWords.stop} <kbd>Esc</kbd></button></p></section>`;
    if (!hint) return nothing;
    return html`<section class="hint" aria-label=${frameWords.hint}><p>${hint}
      ${offer ? html`<button type="button" class="text" @click=${() => actions.openDialog('tour')}>${frameWords.showAround}</button>` : nothing}
      <button type="button" class="text" @click=${() => actions.hideHint()}>${frameWords.gotIt}</button></p></section>`;
  }

  private wide(): TemplateResult {
    const { editor } = this;
    return html`
      ${this.side('grow', frameWords.grows, html`<wg-grow .editor=${editor}></wg-grow><wg-statistics .editor=${editor}></wg-statistics>`)}
      ${this.side('blow', frameWords.blows, html`<wg-wind .editor=${editor}></wg-wind>`)}
      <footer class="bottom">${
        this.session.panels
          ? html`<wg-studio .editor=${editor} class="paper"></wg-studio>
            <div class="paper"><wg-time .editor=${editor}></wg-time></div>`
          : html`<div class="paper studio-place"></div><div class="paper time-place"></div>`
      }</footer>`;
  }

  private side(name: 'grow' | 'blow', title: string, content: TemplateResult): TemplateResult {
    const { folds } = this.editor.preferences;
    const open = folds[name] ?? true;
    const turn = (): void => {
      this.editor.actions.setFold(name, !open);
      this.requestUpdate();
    };
    return html`<aside class="side paper ${name}" aria-labelledby="${name}-title" ?data-folded=${!open}>
      <h2 id="${name}-title"><button type="button" class="head" aria-expanded=${open} aria-controls="${name}-body" @click=${turn}>
        ${title}${icon('down')}</button></h2>
      <div class="body" id="${name}-body" ?hidden=${!open}>${this.session.panels ? content : nothing}</div>
      ${open && name === 'grow' ? panelEdge(this.editor, () => this.requestUpdate()) : nothing}
    </aside>`;
  }
}

customElements.define('wg-app', App);
