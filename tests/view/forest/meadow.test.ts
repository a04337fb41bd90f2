import { expect, test } from 'vitest';
import { FOREST_GRASS_INJECTION } from '../../../src/view/forest/forest-meadow.ts';

test('grass on a terrain has the colours of the terrain, at its tips too', () => {
  const text = FOREST_GRASS_INJECTION.fragment.map((patch) => JSON.stringify(patch)).join('\n');
  const calls = text.slice(text.indexOf('#include <map_fragment>'));
  expect(calls).toContain('terrainBlade(terrainDiffuse(), (');
  expect(calls).not.toMatch(/groundDiffuse|grassLight/);
});
