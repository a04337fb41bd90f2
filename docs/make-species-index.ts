// `npx tsx docs/make-species-index.ts`: completes public/species/index.json with what the gallery needs of the species' files. Run it after a
// species was added or its facts or seasons were changed; docs/make-portraits.ts does it too.
import { writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { folder, indexText, readIndex, wholeEntry } from './species-index.ts';

const entries = readIndex().map(wholeEntry);
writeFileSync(join(folder, 'index.json'), indexText(entries));
console.log(`${entries.length} species`);
