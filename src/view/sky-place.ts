import { RADIAN, type Rgb } from '../core/look/sky-model.ts';

/** The default camera's azimuth from +z, radians: the stages are lit for it. */
export const CAMERA_AZIMUTH = 0.2;

/** Direction to a place of the sky, unit length, y up: degrees above the horizon, and right of where the default camera looks. */
export function placeInSky(elevation: number, right: number): Rgb {
  const turn = CAMERA_AZIMUTH - Math.PI - right * RADIAN;
  const level = Math.cos(elevation * RADIAN);
  return [level * Math.sin(turn), Math.sin(elevation * RADIAN), level * Math.cos(turn)];
}
