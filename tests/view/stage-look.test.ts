import { describe, expect, it } from 'vitest';
import { STAGES } from '../../src/core/link/document.ts';
import { linearOf, type Rgb, rgb, screenOf, sunAt, sunTint } from '../../src/core/look/sky-model.ts';
import { lookAt, type StageLook } from '../../src/view/stage-look.ts';
import { STAGE_TABLE } from '../../src/view/stage-table.ts';

/** Every number of a look but the directions, which turn to the moon's while nothing shines. */
const numbers = (look: StageLook): number[] =>
  Object.entries(look)
    .filter(([key]) => !/direction|disc|^sun$/i.test(key))
    .flatMap(([, value]) => [value].flat(3) as number[]);

describe('the sun of a summer day', () => {
  it('stands in the south and highest at noon, rises in the north-east and goes down in the north-west', () => {
    expect(sunAt(12).azimuth).toBeCloseTo(180, 6);
    expect(sunAt(12).elevation).toBeCloseTo(90 - 47 + 22, 6);
    expect(sunAt(0).elevation).toBeCloseTo(-(90 - 47 - 22), 6);
    expect(sunAt(24).elevation).toBeCloseTo(sunAt(0).elevation, 6);
    const [morning, evening] = [sunAt(4.2), sunAt(19.8)];
    expect(Math.abs(morning.elevation)).toBeLessThan(2);
    expect(morning.azimuth).toBeGreaterThan(45);
    expect(morning.azimuth).toBeLessThan(75);
    expect(evening.azimuth).toBeCloseTo(360 - morning.azimuth, 6);
  });

  it('is white high up and amber low down', () => {
    const [, green, blue] = sunTint(4);
    expect(blue).toBeLessThan(0.3);
    expect(green).toBeGreaterThan(2 * blue);
    expect(Math.min(...sunTint(65))).toBeGreaterThan(0.8);
  });
});

describe.each(STAGES)('the look of %s', (stage) => {
  it('follows the hour without a jump, and what throws shadows turns only while nothing shines', () => {
    for (let hour = 0; hour < 24; hour += 0.05) {
      const [a, b] = [lookAt(stage, hour, false), lookAt(stage, hour + 0.05, false)];
      const [from, to] = [numbers(a), numbers(b)];
      expect(Math.max(...from.map((x, i) => Math.abs(x - to[i]!)))).toBeLessThan(0.5);
      const turned = Math.hypot(...a.direction.map((x, i) => x - b.direction[i]!));
      if (turned > 0.06) expect(Math.max(a.sunIntensity, b.sunIntensity)).toBeLessThan(0.15);
    }
  });

  it('is never too dark to see the tree: light at every hour, and a horizon behind it that is lighter than its leaves', () => {
    const luma = ([r, g, b]: readonly [number, number, number]): number => 0.3 * r + 0.59 * g + 0.11 * b;
    for (let hour = 0; hour < 24; hour += 0.25) {
      const { horizon, zenith, skyLight, skyIntensity } = lookAt(stage, hour, false);
      expect(luma(horizon)).toBeGreaterThan(0.24);
      expect(luma(horizon)).toBeGreaterThan(luma(zenith));
      expect(luma(skyLight) * skyIntensity).toBeGreaterThan(0.55);
    }
  });

  it('lights the default view from the side, and leaves no colour of the sky beyond the screen', () => {
    for (const dark of [false, true]) {
      const { direction, zenith, middle, horizon, cloud } = lookAt(stage, null, dark);
      expect(Math.hypot(...direction)).toBeCloseTo(1, 6);
      expect(Math.abs(direction[0])).toBeGreaterThan(0.45);
      for (const part of [zenith, middle, horizon, cloud].flat()) {
        expect(part).toBeGreaterThanOrEqual(0);
        expect(part).toBeLessThanOrEqual(1);
      }
    }
  });
});

describe.each(['meadow', 'golden'] as const)('the grass of %s', (stage) => {
  /** As the sun alone shows it: hue in degrees (30 orange, 60 yellow; beyond it is lime), saturation 0..1. */
  const seen = (hour: number): { hue: number; saturation: number } => {
    const { grassLight, sun } = lookAt(stage, hour, false);
    const [r, g, b] = screenOf(linearOf(grassLight).map((c, k) => c * sun[k]!) as unknown as Rgb);
    return { hue: (60 * (g - b)) / (r - b), saturation: 1 - b / Math.max(r, g) };
  };

  it('is golden while the sun is low, not lime, and no louder than that', () => {
    for (let hour = 4.4; hour < 5.55; hour += 0.05) {
      for (const { hue, saturation } of [seen(hour), seen(24 - hour)]) {
        expect(hue).toBeGreaterThan(38);
        expect(hue).toBeLessThan(53.5);
        expect(saturation).toBeLessThan(0.64);
      }
    }
  });

  it('is as the table has it while the sun is high', () => {
    for (const hour of [8.6, 12, 15]) {
      const { grassLight, grassDark } = lookAt(stage, hour, false);
      const kept = [...rgb(STAGE_TABLE[stage].grassLight), ...rgb(STAGE_TABLE[stage].grassDark)];
      [...grassLight, ...grassDark].forEach((c, k) => {
        expect(c).toBeCloseTo(kept[k]!, 6);
      });
    }
  });
});
