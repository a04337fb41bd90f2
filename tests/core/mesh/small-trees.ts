import { growPacked } from '../../../src/core/pack/grow-packed.ts';
import type { Species } from '../../../src/core/species/species.ts';
import { edit, shipped } from '../grow/species.ts';

const aspen = edit(shipped('quaking-aspen'), {
  levels: { 1: { branches: 8 }, 2: { branches: 6 } },
  leaves: { count: 5 },
});

/** Clones, long chains, lobes and four levels. */
const willow = edit(shipped('weeping-willow'), {
  tree: { lobes: 5, lobeDepth: 0.12, flare: 0.8 },
  levels: { 1: { branches: 4 }, 2: { branches: 3 }, 3: { branches: 6 } },
  leaves: { count: 2 },
});

/** Small trees that have all that meshing must deal with. */
export const SMALL: Readonly<Record<string, Species>> = {
  aspen,
  willow,
  'open ends': edit(aspen, { levels: { 0: { taper: 0.5 }, 1: { taper: 0 }, 2: { taper: 0.9 } } }),
  'round ends': edit(aspen, { levels: { 0: { taper: 1.5 }, 1: { taper: 2 }, 2: { taper: 1.2 } } }),
  'strings of balls': edit(aspen, { levels: { 1: { taper: 3 }, 2: { taper: 2.6 } } }),
  'in fruit': edit(aspen, { organ: { kind: 'fruit', share: 0.3 }, foliage: { cover: 0.5 } }),
  bulges: edit(aspen, { tree: { bulges: 4, bulgeDepth: 0.3 } }),
};

export const smallTrees = Object.entries(SMALL).map(([name, species]) => [name, growPacked(species, 3)] as const);
