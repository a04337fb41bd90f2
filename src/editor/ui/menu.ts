import { html, nothing, type TemplateResult } from 'lit';
import type { Editor } from '../editor.ts';
import { type CommandId, command, keysOf } from '../shortcuts.ts';
import { commandWords } from '../words/commands.ts';
import { type Icon, icon } from './icons.ts';

/** A button that opens a few more of them below it. */
export interface Menu {
  readonly id: string;
  readonly icon: Icon;
  /** What the button says; spoken only where `quiet`. */
  readonly label: string;
  readonly title?: string;
  readonly quiet?: boolean;
  readonly content: TemplateResult;
}

/** Pixels between a button and its menu, and between a menu and the edge of the window. */
const GAP = 4;
const EDGE = 8;

/** Puts a menu under its button, flush with the side that has room. */
function place(event: Event): void {
  const { newState } = event as Event & { newState: string };
  const menu = event.currentTarget as HTMLElement;
  const button = document.querySelector(`[popovertarget="${menu.id}"]`);
  if (event.target !== menu || newState !== 'open' || !button) return;
  const { left, right, bottom } = button.getBoundingClientRect();
  const rightwards = (left + right) / 2 < window.innerWidth / 2;
  menu.style.left = rightwards ? `${Math.max(EDGE, left)}px` : 'auto';
  menu.style.right = rightwards ? 'auto' : `${Math.max(EDGE, window.innerWidth - right)}px`;
  menu.style.top = `${bottom + GAP}px`;
  menu.style.maxHeight = `${window.innerHeight - bottom - GAP - EDGE}px`;
}

export const menu = (
  m: Menu,
): TemplateResult => html`<button type="button" class="quiet menu-button" popovertarget=${m.id}
    title=${m.title ?? (m.quiet ? m.label : nothing)}>${icon(m.icon)}<span class=${m.quiet ? 'spoken' : ''}>${m.label}</span></button>
  <div popover id=${m.id} class="menu paper" role="group" aria-label=${m.label} @beforetoggle=${place}>${m.content}</div>`;

/** A command as a line of a menu, with its key; the menu closes. */
export function menuItem(editor: Editor, id: CommandId, sign?: Icon): TemplateResult {
  const { act, enabled } = command(id);
  const [keys] = keysOf(id);
  const choose = (event: Event): void => {
    // A menu of a menu closes both.
    for (let open = (event.currentTarget as Element).closest<HTMLElement>('[popover]'); open; ) {
      open.hidePopover();
      open = open.parentElement?.closest<HTMLElement>('[popover]') ?? null;
    }
    act?.(editor);
  };
  return html`<button type="button" class="menu-item" ?disabled=${!(enabled?.(editor) ?? true)} @click=${choose}>
    ${sign ? icon(sign) : nothing}<span>${commandWords.labels[id]}</span>${keys ? html`<kbd>${keys}</kbd>` : nothing}</button>`;
}
