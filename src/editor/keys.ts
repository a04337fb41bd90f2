/** A key with what is held beside it. */
export interface Key {
  /** As `KeyboardEvent.key` names it, letters small. */
  readonly key: string;
  /** Ctrl, on a Mac ⌘. */
  readonly mod?: true;
  readonly shift?: true;
  /** What the help shows where it is not the key's own name. */
  readonly shown?: string;
}

/** Whether the machine's own shortcuts are made with ⌘. */
export const onMac = (): boolean => /mac|iphone|ipad/i.test(globalThis.navigator?.platform ?? '');

const names: Record<string, string> = {
  ' ': 'Space',
  escape: 'Esc',
  delete: 'Del',
  arrows: '← →',
};

/** `Ctrl+Shift+Z`, on a Mac `⇧⌘Z`. */
export function keyText({ key, mod, shift, shown }: Key, mac: boolean): string {
  const name = shown ?? names[key] ?? key.toUpperCase();
  if (mac) return `${shift ? '⇧' : ''}${mod ? '⌘' : ''}${name}`;
  return [mod && 'Ctrl', shift && 'Shift', name].filter(Boolean).join('+');
}

/** What is pressed, as one of the table's keys would have it; null where Alt makes it somebody else's. */
export function pressed(event: KeyboardEvent, mac: boolean): Key | null {
  // AltGr is Ctrl and Alt to some systems, and on many keyboards the only way to [ ] and \.
  const graph = event.getModifierState('AltGraph');
  const mod = !graph && (mac ? event.metaKey : event.ctrlKey);
  const other = !graph && (event.altKey || (mac ? event.ctrlKey : event.metaKey));
  if (other) return null;
  const letter = event.key.toLowerCase();
  // Where letters are not Latin, the place of the key says which is meant.
  const key = mod && !/^[ -~]$/.test(letter) && /^Key[A-Z]$/.test(event.code) ? event.code[3]!.toLowerCase() : letter;
  return { key, ...(mod ? { mod } : {}), ...(mod && event.shiftKey ? { shift: true } : {}) };
}

export const sameKey = (a: Key, b: Key): boolean => a.key === b.key && a.mod === b.mod && a.shift === b.shift;
