import { describe, expect, it } from 'vitest';
import { type Key, keyText, pressed } from '../../src/editor/keys.ts';
import { COMMANDS } from '../../src/editor/shortcuts.ts';
import { commandWords } from '../../src/editor/words/commands.ts';

/** A key press as a browser tells it. */
const press = (key: string, held: Partial<KeyboardEvent> & { graph?: boolean } = {}): KeyboardEvent =>
  ({
    key,
    code: '',
    ctrlKey: false,
    metaKey: false,
    altKey: false,
    shiftKey: false,
    getModifierState: (name: string) => name === 'AltGraph' && held.graph === true,
    ...held,
  }) as KeyboardEvent;

const z: Key = { key: 'z', mod: true };

describe('table of commands', () => {
  it('gives each key one meaning', () => {
    const keys = COMMANDS.filter((c) => c.group !== 'sliders')
      .flatMap((c) => c.keys)
      .map((k) => keyText(k, false));
    expect(keys.filter((k, i) => keys.indexOf(k) !== i)).toEqual([]);
  });

  it('has every command once, with words', () => {
    expect(COMMANDS.map((c) => c.id).sort()).toEqual(Object.keys(commandWords.labels).sort());
  });

  it('needs no Shift, Ctrl or Alt for what it calls a single key', () => {
    const single = COMMANDS.flatMap((c) => (c.act ? c.keys : [])).filter((k) => !k.mod);
    expect(single.filter((k) => k.shift || k.key !== k.key.toLowerCase())).toEqual([]);
  });
});

describe('keys', () => {
  it.each([
    [z, 'Ctrl+Z', '⌘Z'],
    [{ key: 'z', mod: true, shift: true }, 'Ctrl+Shift+Z', '⇧⌘Z'],
    [{ key: ' ' }, 'Space', 'Space'],
  ] as [Key, string, string][])('%o is written as each machine writes it', (key, pc, mac) => {
    expect([keyText(key, false), keyText(key, true)]).toEqual([pc, mac]);
  });

  it('takes Ctrl elsewhere for what is ⌘ on a Mac, and nothing with Alt', () => {
    expect(pressed(press('z', { ctrlKey: true }), false)).toEqual(z);
    expect(pressed(press('z', { metaKey: true }), true)).toEqual(z);
    expect(pressed(press('z', { ctrlKey: true }), true)).toBeNull();
    expect(pressed(press('z', { metaKey: true }), false)).toBeNull();
    expect(pressed(press('z', { altKey: true }), false)).toBeNull();
    expect(pressed(press('Z', { ctrlKey: true, shiftKey: true }), false)).toEqual({ ...z, shift: true });
  });

  it('knows the keys that some keyboards have on AltGr alone, and letters that are not Latin', () => {
    expect(pressed(press('[', { ctrlKey: true, altKey: true, graph: true }), false)).toEqual({ key: '[' });
    expect(pressed(press('я', { ctrlKey: true, code: 'KeyZ' }), false)).toEqual(z);
  });
});
