import type { StageId } from '../core/link/document.ts';
import { along, linearOf, mixRgb, type Rgb, rgb, screenOf, sunAt, sunTint, tintAlong } from '../core/look/sky-model.ts';
import { placeInSky } from './sky-place.ts';
import {
  CLEAR,
  CLOUD_WHITE,
  GRASS_NIGHT,
  GRASS_STALKS,
  GROUND_LIGHT,
  MOON_PLACE,
  MOON_RISES,
  MOON_STRENGTH,
  MOON_TINT,
  OVERCAST,
  OVERCAST_NIGHT,
  ownHour,
  SKY_LIGHT,
  SKY_STRENGTH,
  STAGE_TABLE,
  STALKS_LIT,
  STARS,
  type StageTable,
  SUN_STRENGTH,
} from './stage-table.ts';
import { studioLook } from './studio-look.ts';

/** Colours and light of a stage at an hour. */
export interface StageLook {
  /** Sky as the screen shows it (sRGB, 0..1): no tone mapping follows. */
  readonly horizon: Rgb;
  readonly middle: Rgb;
  readonly zenith: Rgb;
  /** Around the sun, added; and the disc of sun or moon. */
  readonly glow: Rgb;
  readonly disc: Rgb;
  readonly cloud: Rgb;
  readonly cloudCover: number;
  readonly stars: number;
  /** Skylines, the farthest first: colour in clear air, and how much of it the air between leaves. */
  readonly hills: readonly (readonly [tint: Rgb, density: number])[];
  readonly skyline: readonly [number, number, number, number];
  /** What the ground fades into, likewise: fields at the foot of the skylines. */
  readonly field: readonly [tint: Rgb, density: number];
  /** From the scene to what gives light, unit length, y up; and where the glow is, which a moon leaves where the sun went down. */
  readonly direction: Rgb;
  readonly discDirection: Rgb;
  readonly glowDirection: Rgb;
  /** Light, linear; it goes through tone mapping. */
  readonly sun: Rgb;
  readonly sunIntensity: number;
  /** How much wider than under a clear sky the rim of a shadow is. */
  readonly softness: number;
  readonly skyLight: Rgb;
  readonly groundLight: Rgb;
  readonly skyIntensity: number;
  readonly exposure: number;
  /** sRGB. */
  readonly grassLight: Rgb;
  readonly grassDark: Rgb;
  readonly earth: Rgb;
  readonly blades: number;
  readonly flowers: number;
  readonly ground: StageTable['ground'];
}

/** Screen colour of what reflects `light`: near what tone mapping makes of it. */
const screenOfLight = (light: Rgb): Rgb => screenOf(light.map((c) => 1 - Math.exp(-1.15 * c)) as unknown as Rgb);

const scaled = (a: Rgb, s: number): Rgb => a.map((c) => c * s) as unknown as Rgb;
const times = (a: Rgb, b: Rgb): Rgb => a.map((c, k) => c * b[k]!) as unknown as Rgb;
const luma = ([r, g, b]: Rgb): number => 0.3 * r + 0.59 * g + 0.11 * b;

/** Forest in the distance. */
const FOREST = rgb('#44583a');

/**
 * The look of a stage at an hour of the day by the sun, 0..24, or at its own (null), of which the dark theme has another.
 * It follows the hour without a jump.
 */
export function lookAt(stage: StageId, hour: number | null, dark: boolean): StageLook {
  if (stage === 'studio') return studioLook(hour, dark);
  const table = STAGE_TABLE[stage];
  const sun = sunAt(hour ?? ownHour(stage, dark));
  const { elevation } = sun;
  const { overcast, mist } = table;
  const open = 1 - 0.94 * overcast;

  const far = tintAlong(CLEAR.horizon, elevation);
  const day = luma(far) / luma(rgb(OVERCAST.horizon));
  const dim = Math.min(1, day);
  const shade = mixRgb(rgb(OVERCAST_NIGHT), [1, 1, 1], dim * dim);
  const greyed = (grey: string): Rgb => times(scaled(rgb(grey), dim), shade);
  const under = (place: 'zenith' | 'middle' | 'horizon', part = 0.94): Rgb =>
    mixRgb(tintAlong(CLEAR[place], elevation), greyed(OVERCAST[place]), part * overcast);
  const clearCloud = mixRgb(far, [1, 1, 1], along(CLOUD_WHITE, elevation));

  const moon = elevation < MOON_RISES;
  const right = sun.azimuth - table.heading;
  const glowDirection = placeInSky(Math.max(-2, elevation), right);
  const direction = moon ? placeInSky(...MOON_PLACE) : placeInSky(Math.max(1, elevation), right);
  const light = moon ? linearOf(rgb(MOON_TINT)) : mixRgb(sunTint(elevation), [1, 0.97, 0.94], 0.2 + 0.5 * overcast);
  const strength = (moon ? along(MOON_STRENGTH, elevation) : along(SUN_STRENGTH, elevation)) * (1 - 0.86 * overcast);
  const skyLight = linearOf(mixRgb(tintAlong(SKY_LIGHT, elevation), times([0.93, 0.95, 0.97], shade), 0.8 * overcast));
  const skyIntensity = along(SKY_STRENGTH, elevation) * (1 - overcast) + (1.8 + 1.45 * dim * dim) * overcast;

  // What lies far away is lit as the ground is: sun by its height, and the whole sky.
  const direct = strength * (0.25 + 0.75 * Math.max(0, direction[1]));
  const falls = light.map((c, k) => c * direct + skyLight[k]! * skyIntensity) as unknown as Rgb;
  const seen = (albedo: Rgb): Rgb => screenOfLight(scaled(times(linearOf(albedo), falls), 1 / Math.PI / 0.6));
  const stalks = mixRgb([1, 1, 1], GRASS_STALKS, open * along(STALKS_LIT, elevation));
  const shown = (albedo: string, day: Rgb): Rgb => times(rgb(albedo), mixRgb(rgb(GRASS_NIGHT), day, dim));
  const grassLight = shown(table.grassLight, stalks);
  const grassDark = shown(table.grassDark, stalks);
  const forest = seen(FOREST);
  const grass = seen(mixRgb(grassLight, grassDark, 0.45));
  return {
    horizon: under('horizon', 0.62),
    middle: under('middle'),
    zenith: under('zenith'),
    glow: scaled(tintAlong(CLEAR.glow, elevation), (0.55 + mist) * open),
    disc: moon
      ? scaled([0.5, 0.53, 0.56], (open * along(MOON_STRENGTH, elevation)) / 2.4)
      : scaled([1, 0.9, 0.7], open),
    cloud: mixRgb(clearCloud, greyed(OVERCAST.cloud), overcast),
    cloudCover: table.clouds,
    stars: along(STARS, elevation) * open,
    hills: [
      [forest, 0.3 - 0.14 * mist],
      [forest, 0.5 - 0.2 * mist],
      [forest, 0.72 - 0.24 * mist],
      [forest, 0.9 - 0.24 * mist],
    ],
    skyline: table.skyline,
    field: [grass, 0.86 - 0.26 * mist],
    direction,
    discDirection: moon ? direction : glowDirection,
    glowDirection,
    sun: light,
    sunIntensity: strength,
    softness: 1 + 5 * overcast,
    skyLight,
    groundLight: linearOf(mixRgb(tintAlong(GROUND_LIGHT, elevation), times(rgb('#8d9684'), shade), overcast)),
    skyIntensity,
    exposure: 1,
    grassLight,
    grassDark,
    earth: shown(table.earth, [1, 1, 1]),
    blades: table.blades,
    flowers: table.flowers,
    ground: table.ground,
  };
}

/** A colour of the screen as CSS writes it. */
export const css = (colour: Rgb): string =>
  `rgb(${colour.map((c) => Math.round(255 * Math.min(1, Math.max(0, c)))).join(' ')})`;
