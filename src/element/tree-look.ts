import type { Season } from '../core/species/season.ts';
import type { ElementDebug, ElementDetail, ElementEnvironment, ElementGround } from './attributes.ts';

/** How a tree is shown. */
export interface TreeLook {
  readonly detail: ElementDetail;
  readonly environment: ElementEnvironment;
  /** Of the day, 0..24; null: the environment's own. */
  readonly hour: number | null;
  readonly ground: ElementGround;
  readonly shadow: boolean;
  readonly dark: boolean;
  /** Levels that are drawn. */
  readonly levels: number;
  readonly leaves: boolean;
  readonly season: Season;
  readonly debug: ElementDebug;
  readonly maxPixelRatio: number;
}

/** What the properties of an element say of it. `dark`: the page is. */
export const lookOf = (element: Omit<TreeLook, 'dark'>, dark: boolean): TreeLook => {
  const { detail, environment, hour, ground, shadow, levels, leaves, season, debug, maxPixelRatio } = element;
  return { detail, environment, hour, ground, shadow, levels, leaves, season, debug, maxPixelRatio, dark };
};
