import { blowingWaves, type Wind } from '../core/wind/wind.ts';

/**
 * Where a wind pushes on the whole, radians from x to y in tree space: the direction of the sum of its waves' peaks, or of its
 * record's mean; null where nothing blows or all of it cancels out. The scene's handle points there.
 */
export function windDirection(wind: Wind): number | null {
  let x = 0;
  let y = 0;
  for (const { amplitude, direction } of blowingWaves(wind)) {
    x += amplitude * Math.cos(direction);
    y += amplitude * Math.sin(direction);
  }
  const { record } = wind;
  if (record && Math.hypot(x, y) < 1e-9) {
    record.speed.forEach((speed, i) => {
      const direction = record.direction[i] ?? 0;
      x += speed * Math.cos(direction);
      y += speed * Math.sin(direction);
    });
  }
  return Math.hypot(x, y) < 1e-9 ? null : Math.atan2(y, x);
}
