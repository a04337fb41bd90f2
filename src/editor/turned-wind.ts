import type { Wind } from '../core/wind/wind.ts';

/** The wind with all of its waves turned by `angle` radians about the vertical. What blows past once, and what was measured, stays. */
export const turnedWind = (wind: Wind, angle: number): Wind => ({
  ...wind,
  waves: wind.waves.map((wave) => ({ ...wave, direction: wave.direction + angle })),
});
