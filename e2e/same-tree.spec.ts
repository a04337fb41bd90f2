import { readFileSync } from 'node:fs';
import { expect, test } from '@playwright/test';
import { growPacked } from '../src/core/pack/grow-packed.ts';
import { hashPacked } from '../src/core/pack/hash-packed.ts';

for (const [name, seed] of [
  ['quaking-aspen', 1],
  ['black-tupelo', 7],
  ['weeping-willow', 1],
  ['california-black-oak', 3],
] as const) {
  test(`the worker of a browser grows the same ${name} as Node, bit for bit`, async ({ page }) => {
    const species = JSON.parse(readFileSync(`public/species/${name}.json`, 'utf8'));
    await page.goto(`e2e/pages/same-tree.html?species=${name}&seed=${seed}`);
    await expect(page.locator('#report')).toHaveText(hashPacked(growPacked(species, seed).packed));
  });
}
