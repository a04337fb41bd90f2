import { expect, test } from 'vitest';
import { decodeWind } from '../../src/core/link/decode-wind.ts';
import { LinkReader } from '../../src/core/link/reader.ts';
import { roundWind } from '../../src/core/link/round-wind.ts';
import { STILL } from '../../src/core/wind/wind.ts';
import type { FigureSpec, Values } from '../../src/learn/figure.ts';
import { lagged } from '../../src/learn/ping-pong/lagged.ts';
import { field } from '../../src/learn/sum-of-sines/field.ts';
import { gust } from '../../src/learn/sum-of-sines/gust.ts';
import { lean } from '../../src/learn/sum-of-sines/lean.ts';
import { wave } from '../../src/learn/sum-of-sines/wave.ts';
import { windLink } from '../../src/learn/wind-link.ts';
import { gustWind } from '../../src/learn/wind-models/models.ts';
import { sway } from '../../src/learn/wind-models/sway.ts';
import { three } from '../../src/learn/wind-models/three.ts';

const read = (link: string) => {
  const reader = new LinkReader(new Map(new URLSearchParams(link)));
  const { preset, wind } = decodeWind(reader, { breeze: STILL }, { preset: 'breeze', wind: STILL });
  return { preset, wind, faults: reader.faults };
};

test('a wind of a lesson comes to the editor as it is, but for its description', () => {
  const wind = gustWind('spring', 0.7, 0.6, 0.3);
  expect(read(windLink(wind))).toEqual({
    preset: 'own',
    faults: [],
    wind: { ...roundWind(wind), description: '' },
  });
});

test.each<[string, FigureSpec]>([field, wave, lean, gust, lagged, three, sway].map((spec) => [spec.id, spec]))(
  'figure %s opens a wind of its own in the editor',
  (_, spec) => {
    const values: Values = Object.fromEntries(spec.controls.map(({ id, value }) => [id, value]));
    const { preset, faults, wind } = read(spec.open?.(values) ?? '');
    expect([preset, faults]).toEqual(['own', []]);
    expect(wind.waves.length + wind.gusts.length > 0 || wind.model === 'sway').toBe(true);
  },
);
