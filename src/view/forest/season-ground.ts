import type { Rgb } from '../../core/look/sky-model.ts';
import type { Season } from '../../core/species/season.ts';
import type { StageLook } from '../stage-look.ts';

/** What a season makes of the grass: factors on the colours of its tips and of what lies below them, part of its height and flowers. */
interface SeasonGround {
  readonly light: Rgb;
  readonly dark: Rgb;
  readonly blades: number;
  readonly flowers: number;
}

/** Green in spring and summer; straw from autumn on, which the winter bleaches. */
const GROUNDS: Readonly<Record<Season, SeasonGround>> = {
  spring: { light: [1, 1.04, 0.94], dark: [0.98, 1.05, 0.95], blades: 0.8, flowers: 1.6 },
  summer: { light: [1, 1, 1], dark: [1, 1, 1], blades: 1, flowers: 1 },
  autumn: { light: [1.17, 1.02, 0.98], dark: [1.24, 1.0, 0.95], blades: 1, flowers: 0 },
  winter: { light: [1.04, 0.95, 1.2], dark: [1.2, 0.98, 1.25], blades: 0.6, flowers: 0 },
};

const times = (a: Rgb, b: Rgb): Rgb => [0, 1, 2].map((k) => Math.min(1, a[k]! * b[k]!)) as unknown as Rgb;

/** A stage's look with its meadows as a season has them, near and far. */
export function groundInSeason(look: StageLook, season: Season): StageLook {
  const { light, dark, blades, flowers } = GROUNDS[season];
  const [field, density] = look.field;
  const mean = light.map((c, k) => 0.55 * c + 0.45 * dark[k]!) as unknown as Rgb;
  return {
    ...look,
    grassLight: times(look.grassLight, light),
    grassDark: times(look.grassDark, dark),
    field: [times(field, mean), density],
    blades: look.blades * blades,
    flowers: Math.min(1, look.flowers * flowers),
  };
}
