import type { Shape } from '../deform/radius.ts';
import type { Species } from '../species/species.ts';

/** How much wider than itself a stem is where it leaves its parent: `collar` of core/deform. */
export const COLLAR = 0.7;

/** What multiplies the radius of the stems of a level, as they are drawn: trunks alone have flare. */
export function levelShape({ tree, levels }: Species, level: number): Shape {
  const trunk = level === 0;
  const own = levels[Math.min(level, levels.length - 1)];
  return {
    taper: own?.taper ?? 1,
    flare: trunk ? tree.flare : 0,
    lobes: trunk ? tree.lobes : (own?.lobes ?? 0),
    lobeDepth: trunk ? tree.lobeDepth : (own?.lobeDepth ?? 0),
    lobeFade: 0,
    bulges: tree.bulges,
    bulgeDepth: tree.bulgeDepth,
  };
}
