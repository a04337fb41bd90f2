import { linearOf, mixRgb, type Rgb, rgb, screenOf } from '../../core/look/sky-model.ts';
import type { Season } from '../../core/species/season.ts';
import type { Species } from '../../core/species/species.ts';

/** Earth and old leaves. */
const OLD = rgb('#5a4630');
/** How much of this year's leaves lies there, by season. */
const FALLEN: Readonly<Record<Season, number>> = { spring: 0.1, summer: 0.08, autumn: 0.62, winter: 0.35 };

/** The colour of what lies under the trees of a mix, as the screen has it: old leaves, and in autumn those that have just come down. */
export function litterColour(mix: readonly Species[], trees: readonly number[], season: Season): Rgb {
  let sum: Rgb = [0, 0, 0];
  let all = 0;
  mix.forEach(({ autumn, foliage }, i) => {
    const fallen = linearOf(rgb(autumn.second ?? autumn.colour ?? foliage.second ?? foliage.colour));
    const count = trees[i] as number;
    sum = [0, 1, 2].map((k) => (sum[k] as number) + count * (fallen[k] as number)) as unknown as Rgb;
    all += count;
  });
  if (all === 0) return OLD;
  const mean = sum.map((c) => (0.75 * c) / all) as unknown as Rgb;
  return screenOf(mixRgb(linearOf(OLD), mean, FALLEN[season]));
}
