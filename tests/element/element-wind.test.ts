import { readFileSync } from 'node:fs';
import { describe, expect, test } from 'vitest';
import { meanPush } from '../../src/core/wind/force.ts';
import { parseWind } from '../../src/core/wind/parse-wind.ts';
import { speedOfForce } from '../../src/core/wind/speed.ts';
import { STILL, type Wind } from '../../src/core/wind/wind.ts';
import { elementWind } from '../../src/element/element-wind.ts';

const AS_IT_IS = { windSpeed: null, windDirection: null, gust: null, model: null };
const breeze = parseWind(readFileSync('public/winds/breeze.json', 'utf8')).wind as Wind;

function mean({ waves }: Wind): { speed: number; degrees: number } {
  let [x, y] = [0, 0];
  for (const { amplitude, sharpness, direction } of waves) {
    x += amplitude * meanPush(sharpness) * Math.cos(direction);
    y += amplitude * meanPush(sharpness) * Math.sin(direction);
  }
  return { speed: speedOfForce(Math.hypot(x, y)), degrees: (Math.atan2(y, x) * 180) / Math.PI };
}

describe('the wind that the attributes ask for', () => {
  test('is the wind itself where they ask for nothing', () => {
    expect(elementWind(breeze, AS_IT_IS)).toBe(breeze);
  });

  test.each([1, 6, 20])('has the mean speed of %s m/s, and its waves keep pace', (windSpeed) => {
    const wind = elementWind(breeze, { ...AS_IT_IS, windSpeed });
    expect(mean(wind).speed).toBeCloseTo(windSpeed, 6);
    expect(wind.waves[0]!.speed / breeze.waves[0]!.speed).toBeCloseTo(windSpeed / mean(breeze).speed, 6);
    expect(mean(wind).degrees).toBeCloseTo(mean(breeze).degrees, 6);
  });

  test('blows up out of still air, and not at 0', () => {
    // The wave that stands still is on its crest where the tree is; `mean` takes it for one that passes.
    const { speed } = mean(elementWind(STILL, { ...AS_IT_IS, windSpeed: 6 }));
    expect(speed).toBeGreaterThan(5.6);
    expect(speed).toBeLessThan(6.1);
    expect(elementWind(STILL, { ...AS_IT_IS, windSpeed: 0 }).waves).toEqual([]);
  });

  test('blows to the direction, whole', () => {
    const wind = elementWind(breeze, { ...AS_IT_IS, windDirection: 120 });
    expect(mean(wind).degrees).toBeCloseTo(120, 6);
    expect(wind.waves[1]!.direction - wind.waves[0]!.direction).toBeCloseTo(
      breeze.waves[1]!.direction - breeze.waves[0]!.direction,
      9,
    );
  });

  test('has a gust that comes again, the stronger the more is asked for, and none at 0', () => {
    const peak = (gust: number): number => elementWind(breeze, { ...AS_IT_IS, gust }).gusts[0]?.amplitude ?? 0;
    expect(peak(0)).toBe(0);
    expect(peak(1) / peak(0.25)).toBeCloseTo(4, 9);
    expect(elementWind(STILL, { ...AS_IT_IS, gust: 0.5 }).gusts[0]!.amplitude).toBeGreaterThan(0.02);
  });

  test('is answered by the model', () => {
    expect(elementWind(breeze, { ...AS_IT_IS, model: 'direct' }).model).toBe('direct');
  });
});
