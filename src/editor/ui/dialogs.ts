import { html, nothing, type PropertyValues, type TemplateResult } from 'lit';
import type { Dialog } from '../session.ts';
import { dialogWords } from '../words/dialogs.ts';
import { icon } from './icons.ts';
import { Part } from './panel.ts';

/** The dialogs that lie over the page; the tour draws its own frames. */
export type Framed = Exclude<Dialog, 'tour'>;

/** The element that fills a dialog, and how it is loaded: who never opens it never waits for it. */
const contents: Record<Framed, { readonly tag: string; readonly load: () => Promise<unknown> }> = {
  gallery: { tag: 'wg-gallery', load: () => import('../gallery/gallery.ts') },
  help: { tag: 'wg-help', load: () => import('./help.ts') },
  palette: { tag: 'wg-palette', load: () => import('./palette.ts') },
  history: { tag: 'wg-history', load: () => import('./history.ts') },
  export: { tag: 'wg-export', load: () => import('../export/export-dialog.ts') },
  variety: { tag: 'wg-variety', load: () => import('../variety/variety-dialog.ts') },
};

/** What had the focus; a control of a menu gives way to the button that opened the menu. */
function opener(): HTMLElement | null {
  const focused = document.activeElement;
  const menu = focused?.closest<HTMLElement>('[popover][id]');
  const button = menu && document.querySelector<HTMLElement>(`[popovertarget="${menu.id}"]`);
  return button ?? (focused instanceof HTMLElement ? focused : null);
}

/** One native dialog; what fills it is loaded when it is first opened and stays as it was left. */
class Dialogs extends Part {
  static override properties = { ...Part.properties, failed: { state: true } };
  /** Why the content could not be loaded. */
  declare failed: string | null;
  private readonly made = new Map<Framed, HTMLElement>();
  private shown: Framed | null = null;
  private touring = false;
  private from: HTMLElement | null = null;
  /** A press that began in the dialog and ends beside it selects text; it does not close. */
  private pressed: EventTarget | null = null;

  constructor() {
    super();
    this.failed = null;
  }

  private get name(): Framed | null {
    const { dialog } = this.session;
    return dialog === 'tour' ? null : dialog;
  }

  protected override render(): TemplateResult {
    const { name } = this;
    return html`<dialog class="dialog" data-name=${name ?? nothing} aria-labelledby="dialog-title" @close=${this.onClose}
      @cancel=${(e: Event) => e.target === e.currentTarget && this.close()}
      @pointerdown=${(e: Event) => {
        this.pressed = e.target;
      }} @click=${this.onClick}>${name ? this.filled(name) : nothing}</dialog>`;
  }

  private filled(name: Framed): TemplateResult {
    const made = this.made.get(name);
    return html`<div class="dialog-page">
      <header role="presentation"><h2 id="dialog-title">${dialogWords.headings[name]}</h2>
        <button type="button" class="round" aria-label=${dialogWords.close} @click=${() => this.close()}>${icon('close')}</button></header>
      <div class="dialog-body">${made ?? this.waiting(name)}</div></div>`;
  }

  private waiting(name: Framed): TemplateResult {
    if (this.failed === null) return html`<p class="dialog-wait" role="status">${dialogWords.opening}</p>`;
    return html`<p class="dialog-wait" role="alert">${dialogWords.failed(this.failed)}
      <button type="button" class="text" @click=${() => void this.load(name)}>${dialogWords.again}</button></p>`;
  }

  protected override updated(changes: PropertyValues): void {
    super.updated(changes);
    const dialog = this.querySelector('dialog')!;
    const { name } = this;
    if (name && !dialog.open) {
      this.from = opener();
      dialog.showModal();
    } else if (name && name !== this.shown) {
      this.focusFirst();
    }
    this.shown = name;
    if (name && !this.made.has(name) && this.failed === null) void this.load(name);
    if (!name && dialog.open) dialog.close();
    if (this.session.dialog === 'tour' && !this.touring) void this.tour();
    this.touring = this.session.dialog === 'tour';
  }

  private async load(name: Framed): Promise<void> {
    this.failed = null;
    const { tag, load } = contents[name];
    try {
      await load();
    } catch (error) {
      // The rest of the page goes on; the next opening tries again.
      if (this.name === name) this.failed = error instanceof Error ? error.message : String(error);
      return;
    }
    if (this.made.has(name)) return;
    this.made.set(name, Object.assign(document.createElement(tag), { editor: this.editor }));
    this.requestUpdate();
    await this.updateComplete;
    if (this.name === name) this.focusFirst();
  }

  /** The browser does so when the dialog opens; what comes later or in place of something else is ours to see to. */
  private focusFirst(): void {
    const wanted =
      this.querySelector<HTMLElement>('.dialog-body [autofocus]') ?? this.querySelector<HTMLElement>('.dialog button');
    wanted?.focus();
  }

  private async tour(): Promise<void> {
    try {
      await (await import('../tour.ts')).startTour(this.editor);
    } catch (error) {
      this.editor.actions.closeDialog();
      this.editor.actions.notify('error', dialogWords.tourFailed, [
        error instanceof Error ? error.message : String(error),
      ]);
    }
  }

  /** The session first: whatever is drawn before the dialog's own event comes would open it again. */
  private close(): void {
    this.editor.actions.closeDialog();
  }

  private readonly onClick = (event: MouseEvent): void => {
    // The page inside covers the dialog: only the backdrop has the dialog itself as its target.
    if (event.target === event.currentTarget && this.pressed === event.currentTarget) this.close();
  };

  private readonly onClose = (event: Event): void => {
    if (event.target !== event.currentTarget) return; // a dialog or a popover inside of it
    // The event comes late: the next dialog may have been opened meanwhile, by a quick key.
    if (this.querySelector('dialog')!.open) return;
    this.failed = null;
    // Another dialog that was opened in place of this one stays.
    if (this.name) this.editor.actions.closeDialog();
    const { from } = this;
    this.from = null;
    if (this.session.dialog !== null) return;
    // A page that began with a dialog, or what opened it is gone: the picture is what one came for.
    const back = from?.isConnected && from !== document.body ? from : this.editor.picture.canvas;
    back.focus();
  };
}

customElements.define('wg-dialogs', Dialogs);
