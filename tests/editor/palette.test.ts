import { describe, expect, it } from 'vitest';
import type { Editor } from '../../src/editor/editor.ts';
import { fits, plain } from '../../src/editor/fuzzy.ts';
import { findEntries, paletteEntries } from '../../src/editor/palette-entries.ts';
import { createSession } from '../../src/editor/session.ts';

const session = createSession({
  species: [{ id: 'weeping-willow', name: 'Weeping Willow', latin: 'Salix babylonica', file: '' }],
  canUndo: false,
});
const editor = {
  session,
  document: { getState: () => ({ edits: {}, camera: null }) },
} as unknown as Editor;
const entries = paletteEntries(editor);
const best = (query: string): string | undefined => findEntries(entries, query)[0]?.label;

describe('palette', () => {
  it('has every setting of the tree beside the commands, each once', () => {
    expect(entries.length).toBeGreaterThan(150);
    expect(new Set(entries.map((e) => e.id)).size).toBe(entries.length);
  });

  it.each([
    ['down angle limb', 'Down angle of limbs'],
    ['limbs down', 'Down angle of limbs'],
    ['DOWN ANGLE of TWIGS', 'Down angle of twigs'],
    ['willow', 'Grow Weeping Willow'],
    ['salix', 'Grow Weeping Willow'],
    ['dark', 'Dark colours'],
    ['export', 'Export…'],
    ['wire', 'Wireframe'],
    ['play', 'Play or pause'],
    ['1downangle', 'Down angle of limbs'],
  ])('finds by %s: %s', (query, label) => {
    expect(best(query)).toBe(label);
  });

  it('leaves out what cannot be done now', () => {
    expect(entries.map((e) => e.id)).not.toContain('command-undo');
    session.setState({ canUndo: true });
    expect(paletteEntries(editor).map((e) => e.id)).toContain('command-undo');
  });

  it('shows all in their order while nothing is asked, and nothing for what is not there', () => {
    expect(findEntries(entries, '  ')).toEqual(entries);
    expect(findEntries(entries, 'qqq')).toEqual([]);
  });
});

describe('fits', () => {
  it.each([
    ['dal', 'down angle of limbs', true],
    ['dwn', 'down angle of limbs', false],
    ['angle down', 'down angle of limbs', true],
    ['angle up', 'down angle of limbs', false],
  ])('%s in %s: %s', (query, text, found) => {
    expect(fits(query, text) > 0).toBe(found);
  });

  it('finds letters without their marks', () => {
    expect(plain('Étoile, (no. 3)…')).toBe('etoile no 3');
  });
});
