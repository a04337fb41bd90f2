import type { Editor } from './editor.ts';
import { type Key, onMac, pressed, sameKey } from './keys.ts';
import { COMMANDS, type Command, type CommandGroup, drawLevels } from './shortcuts.ts';

/** Input elements in which letters, digits and arrows are no text. */
const PLAIN = ['range', 'checkbox', 'radio', 'file', 'color', 'button'];

/** What acts in a frame of another page and in photo mode, where only the picture is shown. */
const IN_FRAMES: readonly CommandGroup[] = ['time', 'wind', 'view'];

/** Number boxes in which something was typed that is not yet used: there, undo is the box's own. */
const typing = new WeakSet<EventTarget>();

const isText = (target: HTMLElement): boolean =>
  target.isContentEditable ||
  target.matches('textarea') ||
  (target instanceof HTMLInputElement && !PLAIN.includes(target.type));

/** Whether `target` uses the key itself: letters in text boxes, Space on buttons, undo where text is written. */
function taken(target: EventTarget | null, { key, mod }: Key): boolean {
  if (!(target instanceof HTMLElement)) return false;
  if (mod) {
    if (key !== 'z' && key !== 'y') return false;
    return isText(target) && (!target.matches('input[type="number"]') || typing.has(target));
  }
  if (target.closest('dialog, [role="dialog"]') && key !== '?') return true;
  if (isText(target) || target.matches('select')) return true;
  return key === ' ' && target.matches('button, summary, input, label, a, [role="button"], [role="option"]');
}

/** Listens to the whole page and does what the table of commands says; returns how to stop. */
export function listenToKeys(editor: Editor): () => void {
  const mac = onMac();
  /** What a key that stayed down has switched on for that time. */
  let held: { readonly key: Key; readonly command: Command } | null = null;
  const onKeyUp = (event: KeyboardEvent): void => {
    if (held?.key.key !== event.key.toLowerCase()) return;
    held.command.act!(editor);
    held = null;
  };
  const onKey = (event: KeyboardEvent): void => {
    if (event.defaultPrevented || event.isComposing) return;
    const key = pressed(event, mac);
    if (!key) return;
    // A dialog and a menu close by themselves; what is left of Escape leaves the modes of the page, wherever the focus is.
    if (key.key === 'escape') {
      const own = event.target instanceof HTMLElement && event.target.closest('dialog[open], :popover-open');
      if (!own && editor.actions.leave()) event.preventDefault();
      return;
    }
    if (taken(event.target, key)) return;
    // Who dictates, or touches keys by mistake, can switch the single ones off.
    if (!key.mod && !editor.preferences.shortcuts) return;
    if (!key.mod && /^[1-4]$/.test(key.key)) {
      drawLevels(editor, Number(key.key));
      return;
    }
    const found = COMMANDS.find((c) => c.act && c.keys.some((k) => sameKey(k, key)));
    const { embed, photo } = editor.session.getState();
    if (!found || ((embed || photo) && !IN_FRAMES.includes(found.group)) || (embed && found.id === 'photo')) return;
    // Even where it can do nothing now: the browser's own meaning of the key would surprise.
    event.preventDefault();
    if (event.repeat && !found.repeats) {
      if (found.whileHeld && (found.enabled?.(editor) ?? true)) held = { key, command: found };
      return;
    }
    if (found.enabled?.(editor) ?? true) found.act!(editor);
  };
  const onInput = (event: Event): void => void typing.add(event.target!);
  const onChange = (event: Event): void => void typing.delete(event.target!);
  window.addEventListener('keydown', onKey);
  window.addEventListener('keyup', onKeyUp);
  window.addEventListener('input', onInput, true);
  window.addEventListener('change', onChange, true);
  window.addEventListener('focusout', onChange, true);
  return () => {
    window.removeEventListener('keydown', onKey);
    window.removeEventListener('keyup', onKeyUp);
    window.removeEventListener('input', onInput, true);
    window.removeEventListener('change', onChange, true);
    window.removeEventListener('focusout', onChange, true);
  };
}
