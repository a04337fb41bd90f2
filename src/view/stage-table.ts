import type { StageId } from '../core/link/document.ts';
import type { Curve, Rgb } from '../core/look/sky-model.ts';

/** What a stage is, before the hour lights it. */
export interface StageTable {
  /** Its own hour: in the light theme, in the dark one. */
  readonly hours: readonly [light: number, dark: number];
  /** Where the default camera looks: degrees from north by east. The sun's side follows from it. */
  readonly heading: number;
  /** How much of the sky is under cloud, 0..1. */
  readonly overcast: number;
  /** Thin cloud on what is left, 0..1. */
  readonly clouds: number;
  /** Water and dust in the air, 0..1: glow around the sun, mist at the foot of the hills. */
  readonly mist: number;
  readonly grassLight: string;
  readonly grassDark: string;
  readonly earth: string;
  /** Of the grass: height (0: none), share of flowers. */
  readonly blades: number;
  readonly flowers: number;
  /** Of the ground: how much its colour varies, earth that shows, stripes of a mower, a path. */
  readonly ground: readonly [varied: number, bare: number, mown: number, path: number];
  /** Height of the skylines as tangents: hills far and near, forest, single trees. */
  readonly skyline: readonly [number, number, number, number];
}

export const STAGE_TABLE: Readonly<Record<Exclude<StageId, 'studio'>, StageTable>> = {
  meadow: {
    hours: [8.6, 20.75],
    heading: 20,
    overcast: 0,
    clouds: 0.75,
    mist: 0.45,
    grassLight: '#8f9a55',
    grassDark: '#465a33',
    earth: '#8a7458',
    blades: 1,
    flowers: 0.1,
    ground: [1, 1, 0, 0],
    skyline: [0.05, 0.036, 0.02, 0.017],
  },
  park: {
    hours: [10, 20.75],
    heading: 20,
    overcast: 1,
    clouds: 1,
    mist: 0.55,
    grassLight: '#7f9658',
    grassDark: '#54703f',
    earth: '#9a8a72',
    blades: 0.45,
    flowers: 0,
    ground: [0.5, 0.5, 0.6, 1],
    skyline: [0.03, 0.03, 0.045, 0.05],
  },
  golden: {
    hours: [18.95, 19.35],
    heading: -28,
    overcast: 0,
    clouds: 0.6,
    mist: 0.85,
    grassLight: '#9aa058',
    grassDark: '#4d5c31',
    earth: '#8a7050',
    blades: 1.2,
    flowers: 0.05,
    ground: [1, 0.8, 0, 0],
    skyline: [0.06, 0.045, 0.024, 0.02],
  },
};

/** Hour of noon, at which the studio's lamp hangs where it does by itself. */
export const NOON = 12;

/** The hour that a stage has where none is asked for, in the light theme or the dark one. */
export const ownHour = (stage: StageId, dark: boolean): number =>
  stage === 'studio' ? NOON : STAGE_TABLE[stage].hours[dark ? 1 : 0];

/** The clear sky as the screen shows it, by the sun's elevation. */
export const CLEAR: Readonly<Record<'zenith' | 'middle' | 'horizon' | 'glow', Curve<string>>> = {
  zenith: [
    [-16, '#152342'],
    [-8, '#20386a'],
    [-4, '#32538c'],
    [0, '#4f76ab'],
    [6, '#6c98c6'],
    [20, '#82aed6'],
    [34, '#8ab4d9'],
    [66, '#73a5d4'],
  ],
  middle: [
    [-16, '#24375f'],
    [-8, '#3f5d94'],
    [-4, '#6d87b4'],
    [0, '#93a5bf'],
    [6, '#b9c8d4'],
    [20, '#c6dbe8'],
    [34, '#cbdfeb'],
    [66, '#bcd7ea'],
  ],
  horizon: [
    [-16, '#3f5781'],
    [-8, '#7d8fb5'],
    [-4, '#c9adab'],
    [0, '#e0bf9c'],
    [6, '#f0dcbc'],
    [20, '#eeeee2'],
    [34, '#edf0ea'],
    [66, '#e2ebee'],
  ],
  glow: [
    [-16, '#000000'],
    [-8, '#4d2c1a'],
    [-4, '#7d421f'],
    [0, '#a35f24'],
    [6, '#a5722f'],
    [20, '#604c2a'],
    [66, '#40382a'],
  ],
};

/** How much whiter than the horizon a thin cloud is. */
export const CLOUD_WHITE: Curve<number> = [
  [0, 0],
  [12, 0.5],
];
/** The cloud's own grey under a closed sky by day: overhead, between, at the horizon. */
export const OVERCAST = { zenith: '#a3aeb6', middle: '#c4ccd0', horizon: '#e2e5e3', cloud: '#e9ecec' } as const;

/** Light of the whole sky, and of the ground from below. */
export const SKY_LIGHT: Curve<string> = [
  [-16, '#a2a2dc'],
  [-6, '#a4a6d4'],
  [0, '#bcbfd0'],
  [6, '#cad2e0'],
  [30, '#d9e6f6'],
];
export const GROUND_LIGHT: Curve<string> = [
  [-16, '#3d4650'],
  [-6, '#4c5048'],
  [0, '#8c8468'],
  [6, '#a0996c'],
  [30, '#a2ad84'],
];
export const SKY_STRENGTH: Curve<number> = [
  [-16, 2.3],
  [-6, 2.6],
  [-2, 2.9],
  [1, 2],
  [6, 1.5],
  [30, 2.15],
];

/** Strength of the sun, and of the moon that takes its place. Between them neither throws a shadow. */
export const SUN_STRENGTH: Curve<number> = [
  [-1.4, 0],
  [0.5, 1.8],
  [3, 4.2],
  [7, 5.4],
  [15, 4.8],
  [30, 4.1],
  [65, 3.7],
];
export const MOON_STRENGTH: Curve<number> = [
  [-6, 3],
  [-1.9, 0],
];
export const MOON_TINT = '#adb6f3';
/**
 * Dry stalks and seed heads stand above the leaves of a meadow: the flatter the sun's light, the more of it they catch. They turn it golden, where
 * amber light on leaves alone is a loud yellow-green. What they make of the grass's colour, and how much of it by the sun's elevation.
 */
export const GRASS_STALKS: Rgb = [1.08, 0.97, 1.25];
export const STALKS_LIT: Curve<number> = [
  [-4, 0],
  [0, 1],
  [8, 1],
  [32, 0],
];
/** Grass by night: colours fade, blue the least. */
export const GRASS_NIGHT = '#90a0d0';
/** What is left of a closed sky's grey when the sun has gone. */
export const OVERCAST_NIGHT = '#b0bdee';
/** Elevation of the sun below which the moon is the light, degrees; its place: elevation, and right of where the camera looks. */
export const MOON_RISES = -1.6;
export const MOON_PLACE = [34, 72] as const;

/** Stars that are seen, 0..1. */
export const STARS: Curve<number> = [
  [-12, 1],
  [-3, 0],
];
