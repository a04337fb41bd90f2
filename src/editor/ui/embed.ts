import { html, type TemplateResult } from 'lit';
import { embedWords } from '../words/embed.ts';
import './compare-layer.ts';
import { icon } from './icons.ts';
import { Part } from './panel.ts';

/** What is left of the interface in a frame of another page: play, and where the tree comes from. */
class Embed extends Part {
  protected override render(): TemplateResult {
    const { paused } = this.doc;
    return html`<div class="embed">
      <button type="button" class="round paper" aria-label=${paused ? embedWords.play : embedWords.pause}
        @click=${() => this.editor.actions.toggle()}>${icon(paused ? 'play' : 'pause')}</button>
      <a class="paper" href=${location.href} title=${embedWords.open} target="_blank" rel="noopener" @click=${this.follow}>${embedWords.made}</a>
    </div>`;
  }

  /** The address follows the picture: the link is what it is when it is clicked. */
  private follow(event: Event): void {
    const address = new URL(location.href);
    address.hash = address.hash.replace(/(^#|&)embed=1(&|$)/, (_, before: string, after: string) =>
      after ? before : '',
    );
    (event.currentTarget as HTMLAnchorElement).href = address.href;
  }
}

customElements.define('wg-embed', Embed);
