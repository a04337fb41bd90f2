import { html, type TemplateResult } from 'lit';
import type { Editor } from '../editor.ts';

/** A part that folds away, and stays as it was left. */
export const fold = (
  editor: Editor,
  name: string,
  summary: string | TemplateResult,
  content: TemplateResult,
  openAtFirst = false,
): TemplateResult => html`<details class="fold" ?open=${editor.preferences.folds[name] ?? openAtFirst}
  @toggle=${(e: Event) => editor.actions.setFold(name, (e.currentTarget as HTMLDetailsElement).open)}>
  <summary>${summary}</summary><div class="folded">${content}</div></details>`;
