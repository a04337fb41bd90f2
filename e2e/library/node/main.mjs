import { writeFile } from 'node:fs/promises';
import { DEFAULT_EXPORT, exportTree, growPacked, hashPacked, shipped } from 'windgrove/core';

const aspen = await shipped.speciesOf('quaking-aspen');
const grown = growPacked(aspen, 1);
console.log(`${grown.stats.height.toFixed(2)} m, ${grown.stats.leaves} leaves, hash ${hashPacked(grown.packed)}`);

const breeze = await shipped.windOf('breeze');
for (const { name, bytes } of await exportTree(aspen, 1, breeze, { ...DEFAULT_EXPORT, format: 'swc' })) {
  await writeFile(name, bytes);
  console.log(name);
}
