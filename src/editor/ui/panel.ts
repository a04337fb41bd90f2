import { LitElement, type PropertyValues } from 'lit';
import type { LinkDocument } from '../../core/link/link.ts';
import type { Editor } from '../editor.ts';
import type { Session } from '../session.ts';

/**
 * A part of the interface: drawn again when the document or the session changes.
 *
 * Light DOM: one style sheet, and labels that reach their inputs across parts.
 */
export abstract class Part extends LitElement {
  static override properties = { editor: { attribute: false } };
  declare editor: Editor;
  private stops: (() => void)[] = [];

  protected override createRenderRoot(): HTMLElement {
    return this;
  }

  override connectedCallback(): void {
    super.connectedCallback();
    // What changed while it was out of the page, as a closed dialog's content is, it was not told of.
    this.requestUpdate();
  }

  /** It listens from its first drawing in the page on: an element whose class is loaded when it stands there already has its editor only then. */
  protected override update(changes: PropertyValues): void {
    if (this.isConnected && this.stops.length === 0) {
      const again = (): void => this.requestUpdate();
      this.stops = [this.editor.document.subscribe(again), this.editor.session.subscribe(again)];
    }
    super.update(changes);
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    for (const stop of this.stops) stop();
    this.stops = [];
  }

  protected get doc(): LinkDocument {
    return this.editor.document.getState();
  }

  protected get session(): Session {
    return this.editor.session.getState();
  }
}
