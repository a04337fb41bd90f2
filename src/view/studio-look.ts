import { linearOf, type Rgb, rgb } from '../core/look/sky-model.ts';
import { placeInSky } from './sky-place.ts';
import type { StageLook } from './stage-look.ts';
import { NOON } from './stage-table.ts';

/** Where the key light hangs: degrees up, and right of the camera's view; each hour takes it a step around the tree. */
const UP = 46;
const RIGHT = 126;
const AN_HOUR = 15;

/** Floor and backdrop in one grey, in the light theme and in the dark one. */
const GREYS = {
  light: { top: '#aeb1b1', middle: '#c6c8c7', low: '#d3d4d2', floor: '#cccdcb', sky: 2.3, key: 2.7 },
  dark: { top: '#191c1f', middle: '#24282b', low: '#2f3437', floor: '#474c4f', sky: 1.35, key: 3 },
} as const;

/** A grey room without corners: one soft key light, and a fill from everywhere. */
export function studioLook(hour: number | null, dark: boolean): StageLook {
  const grey = GREYS[dark ? 'dark' : 'light'];
  const none: Rgb = [0, 0, 0];
  const low = rgb(grey.low);
  const direction = placeInSky(UP, RIGHT + (hour === null ? 0 : (hour - NOON) * AN_HOUR));
  return {
    horizon: low,
    middle: rgb(grey.middle),
    zenith: rgb(grey.top),
    glow: dark ? [0.1, 0.105, 0.11] : [0.3, 0.3, 0.29],
    disc: none,
    cloud: none,
    cloudCover: 0,
    stars: 0,
    hills: [0, 0, 0, 0].map(() => [low, 0] as const),
    skyline: [0, 0, 0, 0],
    field: [low, 0],
    direction,
    discDirection: direction,
    glowDirection: placeInSky(14, -8),
    sun: [1, 0.96, 0.9],
    sunIntensity: grey.key,
    softness: 3,
    skyLight: linearOf(rgb('#e9eef2')),
    groundLight: linearOf(rgb(dark ? '#5c5d5e' : '#a9a8a5')),
    skyIntensity: grey.sky,
    exposure: 1,
    grassLight: rgb(grey.floor),
    grassDark: rgb(grey.floor),
    earth: rgb(grey.floor),
    blades: 0,
    flowers: 0,
    ground: [0, 0, 0, 0],
  };
}
