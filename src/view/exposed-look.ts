import { linearOf, type Rgb, screenOf } from '../core/look/sky-model.ts';
import type { StageLook } from './stage-look.ts';

/** Brightest that a part of the sky was before it was shown: what is white on the screen has a grey when less light is let in. */
const BRIGHTEST = 0.985;

/**
 * A look as a camera shows it that lets in 2^`stops` as much light.
 *
 * What lies under tone mapping takes it as exposure. The sky's colours are the screen's already: each is taken back to light, as if it
 * had come out of 1 - exp(-light), and shown anew.
 */
export function exposedLook(look: StageLook, stops: number): StageLook {
  if (stops === 0) return look;
  const factor = 2 ** stops;
  const shown = (colour: Rgb): Rgb =>
    screenOf(linearOf(colour).map((c) => 1 - (1 - Math.min(BRIGHTEST, Math.max(0, c))) ** factor) as unknown as Rgb);
  const shared = ([tint, share]: readonly [Rgb, number]) => [shown(tint), share] as const;
  // Glow and disc are added in colours of the screen, where twice the light is less than twice the colour.
  const root = factor ** (1 / 2.4);
  const added = (colour: Rgb): Rgb => colour.map((c) => c * root) as unknown as Rgb;
  return {
    ...look,
    horizon: shown(look.horizon),
    middle: shown(look.middle),
    zenith: shown(look.zenith),
    cloud: shown(look.cloud),
    glow: added(look.glow),
    disc: added(look.disc),
    stars: look.stars * root,
    hills: look.hills.map(shared),
    field: shared(look.field),
    exposure: look.exposure * factor,
  };
}
