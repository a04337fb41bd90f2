import { html, nothing, type TemplateResult } from 'lit';
import '../studio/drawer.ts';
import './compare-layer.ts';
import './grow-panel.ts';
import './help.ts';
import './notices.ts';
import './sheet.ts';
import './statistics.ts';
import './time-bar.ts';
import './view-panel.ts';
import './wind-panel.ts';
import { icon } from './icons.ts';
import { Part } from './panel.ts';

/** The whole interface over the picture: panels at the sides, or one sheet where the window is narrow. */
class App extends Part {
  protected override render(): TemplateResult {
    const { editor } = this;
    return html`<wg-compare .editor=${editor}></wg-compare>
      ${this.session.narrow ? this.narrow() : this.wide()}
      <section class="messages" aria-label="Messages"><wg-notices .editor=${editor}></wg-notices></section>
      ${this.hint()}
      <wg-help .editor=${editor}></wg-help>`;
  }

  private hint(): TemplateResult | typeof nothing {
    const { hint, throwing } = this.session;
    if (throwing)
      return html`<section class="hint" aria-label="Throwing gusts"><p>Click the ground to throw a gust.
        <button type="button" class="text" @click=${() => this.editor.actions.setThrowing(false)}>Stop <kbd>Esc</kbd></button></p></section>`;
    if (!hint) return nothing;
    return html`<section class="hint" aria-label="Hint"><p>${hint}
      <button type="button" class="text" @click=${() => this.editor.actions.hideHint()}>Got it</button></p></section>`;
  }

  private heading(): TemplateResult {
    const { tree, growing } = this.session;
    const name = tree?.species.name ?? growing?.name ?? 'Windgrove';
    return html`<div class="title"><h1>${name}</h1>
      <p>${tree ? html`<i lang="la">${tree.species.latin}</i> <span class="seed-read">no. ${tree.seed}</span>` : nothing}</p></div>`;
  }

  private wide(): TemplateResult {
    const { editor } = this;
    return html`
      <header class="top">${this.heading()}<div class="tools paper"><wg-view .editor=${editor}></wg-view></div></header>
      ${this.side('grow', 'What grows', html`<wg-grow .editor=${editor}></wg-grow><wg-statistics .editor=${editor}></wg-statistics>`)}
      ${this.side('blow', 'What blows', html`<wg-wind .editor=${editor}></wg-wind>`)}
      <footer class="bottom"><wg-studio .editor=${editor} class="paper"></wg-studio>
        <div class="paper"><wg-time .editor=${editor}></wg-time></div></footer>`;
  }

  private side(name: string, title: string, content: TemplateResult): TemplateResult {
    const { folds } = this.editor.preferences;
    const open = folds[name] ?? true;
    const turn = (): void => {
      this.editor.actions.setFold(name, !open);
      this.requestUpdate();
    };
    return html`<aside class="side paper ${name}" aria-labelledby="${name}-title" ?data-folded=${!open}>
      <h2 id="${name}-title"><button type="button" class="head" aria-expanded=${open} aria-controls="${name}-body" @click=${turn}>
        ${title}${icon('down')}</button></h2>
      <div class="body" id="${name}-body" ?hidden=${!open}>${content}</div>
    </aside>`;
  }

  private narrow(): TemplateResult {
    const { editor, doc } = this;
    return html`<header class="top">${this.heading()}
      <div class="buttons">
        <button type="button" class="round" @click=${() => editor.actions.toggle()} aria-label=${doc.paused ? 'Play' : 'Pause'}>
          ${icon(doc.paused ? 'play' : 'pause')}</button>
        <button type="button" class="round" @click=${() => editor.actions.share()} aria-label="Copy link">${icon('link')}</button>
        <button type="button" class="round" @click=${() => editor.actions.setHelp(true)} aria-label="Help">${icon('help')}</button>
      </div></header>
      <wg-sheet .editor=${editor}></wg-sheet>`;
  }
}

customElements.define('wg-app', App);
