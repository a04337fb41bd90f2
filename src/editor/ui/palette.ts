import { html, nothing, type PropertyValues, type TemplateResult } from 'lit';
import { type Entry, findEntries, paletteEntries } from '../palette-entries.ts';
import { paletteWords } from '../words/palette.ts';
import { Part } from './panel.ts';

/** Lines that are drawn at one time; who wants the next ones types on. */
const MOST = 60;
/** Lines that Page Up and Page Down pass. */
const PAGE = 8;

/** Everything by its name: a text box over a list, as the ARIA practice of an editable combobox has it. */
class Palette extends Part {
  static override properties = { ...Part.properties, query: { state: true }, at: { state: true } };
  declare query: string;
  /** Line of the list that Enter takes. */
  declare at: number;
  private entries: readonly Entry[] = [];
  private moved = false;

  constructor() {
    super();
    this.query = '';
    this.at = 0;
  }

  override connectedCallback(): void {
    super.connectedCallback();
    // What can be done has changed since it was open last.
    this.entries = paletteEntries(this.editor);
    this.query = '';
    this.at = 0;
  }

  protected override render(): TemplateResult {
    const found = findEntries(this.entries, this.query);
    const shown = found.slice(0, MOST);
    const active = shown[this.at];
    return html`<input type="text" class="palette-query" autofocus role="combobox" aria-expanded="true" aria-controls="palette-list"
        aria-autocomplete="list" aria-label=${paletteWords.label} aria-activedescendant=${active ? `palette-${active.id}` : nothing}
        placeholder=${paletteWords.placeholder} autocomplete="off" autocapitalize="off" spellcheck="false" enterkeyhint="go"
        .value=${this.query} @input=${this.onInput} @keydown=${(e: KeyboardEvent) => this.onKey(e, shown)}>
      <p class="spoken" role="status">${paletteWords.count(found.length)}</p>
      <div role="listbox" id="palette-list" class="palette-list" aria-label=${paletteWords.results} tabindex="-1">${shown.map(
        (each, i) => html`<div role="option" id="palette-${each.id}" aria-selected=${i === this.at}
          @click=${() => this.choose(each)} @pointermove=${() => this.point(i)}><span>${each.label}</span>${
            each.detail ? html`<span class="palette-detail">${each.detail}</span>` : nothing
          }</div>`,
      )}</div>
      ${found.length === 0 ? html`<p class="soft">${paletteWords.none}</p>` : nothing}
      ${found.length > MOST ? html`<p class="soft">${paletteWords.more(found.length - MOST)}</p>` : nothing}`;
  }

  protected override updated(changes: PropertyValues): void {
    super.updated(changes);
    if (!this.moved) return;
    this.moved = false;
    this.querySelector('[aria-selected="true"]')?.scrollIntoView({ block: 'nearest' });
  }

  private readonly onInput = (event: Event): void => {
    this.query = (event.target as HTMLInputElement).value;
    this.at = 0;
    this.moved = true;
  };

  /** A pointer that rests while the list moves below it chooses nothing. */
  private point(at: number): void {
    if (at !== this.at) this.at = at;
  }

  private onKey(event: KeyboardEvent, shown: readonly Entry[]): void {
    const last = shown.length - 1;
    if (event.key === 'Enter' && !event.isComposing) {
      event.preventDefault();
      const chosen = shown[this.at];
      if (chosen) this.choose(chosen);
      return;
    }
    const to = {
      ArrowDown: this.at === last ? 0 : this.at + 1,
      ArrowUp: this.at === 0 ? last : this.at - 1,
      PageDown: Math.min(last, this.at + PAGE),
      PageUp: Math.max(0, this.at - PAGE),
    }[event.key];
    if (to === undefined) return;
    event.preventDefault();
    this.at = Math.max(0, to);
    this.moved = true;
  }

  /** Closes first: what is done may open something else, or put the focus somewhere. */
  private choose({ run }: Entry): void {
    this.closest('dialog')!.addEventListener('close', run, { once: true });
    this.editor.actions.closeDialog();
  }
}

customElements.define('wg-palette', Palette);
