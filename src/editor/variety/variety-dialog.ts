import { html, type TemplateResult } from 'lit';
import '../styles/variety.css';
import { Part } from '../ui/panel.ts';
import { varietyWords } from '../words/variety.ts';
import './blend-tab.ts';
import './like-tab.ts';
import './seeds-tab.ts';

const TABS = ['seeds', 'like', 'blend'] as const;
type Tab = (typeof TABS)[number];

/** Other trees to choose from: other seeds, variants, blends. Only the tab that is open makes pictures. */
class Variety extends Part {
  private tab: Tab = 'seeds';

  protected override render(): TemplateResult {
    const { tab } = this;
    return html`<div role="tablist" class="tabs" aria-label=${varietyWords.tabsLabel} @keydown=${this.onKey}>${TABS.map(
      (
        t,
      ) => html`<button type="button" role="tab" id="variety-tab-${t}" aria-controls="variety-panel" aria-selected=${t === tab}
        tabindex=${t === tab ? 0 : -1} ?autofocus=${t === tab} @click=${() => this.choose(t)}>${varietyWords.tabs[t]}</button>`,
    )}</div>
    <div role="tabpanel" id="variety-panel" aria-labelledby="variety-tab-${tab}">${this.content()}</div>`;
  }

  private content(): TemplateResult {
    const { editor } = this;
    if (this.tab === 'seeds') return html`<wg-variety-seeds .editor=${editor}></wg-variety-seeds>`;
    if (this.tab === 'like') return html`<wg-variety-like .editor=${editor}></wg-variety-like>`;
    return html`<wg-variety-blend .editor=${editor}></wg-variety-blend>`;
  }

  private choose(tab: Tab): void {
    this.tab = tab;
    this.requestUpdate();
  }

  private readonly onKey = (event: KeyboardEvent): void => {
    const at = TABS.indexOf(this.tab);
    const to = { ArrowRight: at + 1, ArrowLeft: at + TABS.length - 1, Home: 0, End: TABS.length - 1 }[event.key];
    if (to === undefined) return;
    event.preventDefault();
    const next = TABS[to % TABS.length]!;
    this.choose(next);
    void this.updateComplete.then(() => this.querySelector<HTMLElement>(`#variety-tab-${next}`)?.focus());
  };
}

customElements.define('wg-variety', Variety);
