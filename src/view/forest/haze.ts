import { type Camera, type Color, SRGBColorSpace, Vector3 } from 'three';
import type { Rgb } from '../../core/look/sky-model.ts';
import type { StageLook } from '../stage-look.ts';

const ahead = new Vector3();

/** Part of the fields' colour that is left in the haze of a forest: beyond it lies air, not a meadow's end. */
export const AIRY = 0.6;

/** The colour of the haze in a level direction (x, z), as the screen has it. Twin: farField in shaders/stage/sky.glsl. */
export function airColour({ horizon, glow, glowDirection, field }: StageLook, x: number, z: number): Rgb {
  const length = Math.hypot(x, z) || 1;
  const near = Math.max(0, (x * glowDirection[0] + z * glowDirection[2]) / length);
  const n4 = near * near * near * near;
  const shine = 0.7 * n4 + 0.6 * Math.exp(36 * Math.log(Math.max(near, 1e-9)));
  const [tint, share] = field;
  return [0, 1, 2].map((k) => {
    const sky = 1 - (1 - (horizon[k] as number)) * Math.exp(-shine * (glow[k] as number));
    return sky + ((tint[k] as number) - sky) * share * AIRY;
  }) as unknown as Rgb;
}

/** Density of the haze of a forest, 1 / metre: its far side stands back, and what lies beyond it goes. `mist`: as the stage has it, 0..1. */
export const hazeDensity = (size: number, mist: number): number => (0.75 + 0.95 * mist) / Math.max(250, size);

/** Writes the haze as a camera sees it in the middle of its view: three's fog has one colour. */
export function hazeColour(look: StageLook, camera: Camera, out: Color): void {
  camera.getWorldDirection(ahead);
  // Over a third of the view, so that the glow round the sun does not colour all of it.
  const angle = Math.atan2(ahead.z, ahead.x);
  const parts = [-0.3, 0, 0.3].map((turn) => airColour(look, Math.cos(angle + turn), Math.sin(angle + turn)));
  const [r, g, b] = [0, 1, 2].map((k) => parts.reduce((sum, c) => sum + (c[k] as number) / 3, 0));
  out.setRGB(r as number, g as number, b as number, SRGBColorSpace);
}
