import { Part } from '../ui/panel.ts';
import type { Studio } from './studio.ts';
import type { StudioState } from './studio-state.ts';

/** A part of the drawer: drawn again when the document, the session or the studio's own state changes. */
export abstract class StudioPart extends Part {
  private stopStudio = (): void => {};

  override connectedCallback(): void {
    super.connectedCallback();
    this.stopStudio = this.studio.store.subscribe((now, before) => {
      if (this.answers(now, before)) this.requestUpdate();
    });
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    this.stopStudio();
  }

  protected get studio(): Studio {
    return this.editor.studio;
  }

  protected get state(): StudioState {
    return this.studio.store.getState();
  }

  /** Whether a change of the studio's state is one that is seen here; pointing at a time changes it with each move. */
  protected answers(now: StudioState, before: StudioState): boolean {
    return (Object.keys(now) as (keyof StudioState)[]).some((key) => key !== 'hover' && now[key] !== before[key]);
  }
}
