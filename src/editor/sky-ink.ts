import type { StageId } from '../core/link/document.ts';
import { linearOf, mixRgb, type Rgb } from '../core/look/sky-model.ts';
import { lookAt } from '../view/stage-look.ts';
import { type DocumentStore, watch } from './document-store.ts';

/** What stands on the sky is written in dark ink, or in light one. */
export type SkyInk = 'dark' | 'light';

/** Relative luminance of the inks, as tokens.css has them for the two themes (WCAG 2.2). */
const INKS: Readonly<Record<SkyInk, number>> = { dark: 0.014, light: 0.81 };

/** Where the name of the tree stands, between the middle of the sky (0) and its zenith (1). */
const HEIGHT = 0.3;

const luminance = (colour: Rgb): number => {
  const [r, g, b] = linearOf(colour);
  return 0.2126 * r + 0.7152 * g + 0.0722 * b;
};

/** Contrast of an ink with the sky of a stage at an hour, or at its own (null), 1..21. */
export function contrastOnSky(ink: SkyInk, stage: StageId, hour: number | null, dark: boolean): number {
  const { middle, zenith } = lookAt(stage, hour, dark);
  const sky = luminance(mixRgb(middle, zenith, HEIGHT)) + 0.05;
  const own = INKS[ink] + 0.05;
  return Math.max(sky, own) / Math.min(sky, own);
}

/** The ink that is read best on a sky: that asks for the hour, and not for the theme. */
export const inkOnSky = (stage: StageId, hour: number | null, dark: boolean): SkyInk =>
  contrastOnSky('dark', stage, hour, dark) >= contrastOnSky('light', stage, hour, dark) ? 'dark' : 'light';

/** Keeps `data-sky-ink` of the page as stage and hour say; the answer is for when the theme changes. */
export function followSkyInk(document: DocumentStore): (dark: boolean) => void {
  let isDark = false;
  const apply = (): void => {
    const { stage, hour } = document.getState();
    window.document.documentElement.dataset.skyInk = inkOnSky(stage, hour, isDark);
  };
  watch(document, (d) => d.stage, apply);
  watch(document, (d) => d.hour, apply);
  return (dark) => {
    isDark = dark;
    apply();
  };
}
