import { expect, it } from 'vitest';
import { shortcuts } from '../../src/editor/shortcuts.ts';

it('gives each key one meaning', () => {
  const keys = shortcuts.filter((s) => s.act).flatMap((s) => s.keys.map((k) => k.key));
  expect(new Set(keys).size).toBe(keys.length);
});
