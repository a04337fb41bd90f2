import { expect, test } from 'vitest';
import { decodeWind } from '../../src/core/link/decode-wind.ts';
import { LinkReader } from '../../src/core/link/reader.ts';
import { roundWind } from '../../src/core/link/round-wind.ts';
import { textFromBase64 } from '../../src/core/link/text.ts';
import { parseSpecies } from '../../src/core/species/parse.ts';
import { STILL } from '../../src/core/wind/wind.ts';
import { defaultsOf, isChoice, isNumber } from '../../src/learn/controls.ts';
import type { FigureSpec, Values } from '../../src/learn/figure.ts';
import { readFigure, writeFigure } from '../../src/learn/permalink.ts';
import { lagged } from '../../src/learn/ping-pong/lagged.ts';
import { textures } from '../../src/learn/ping-pong/textures.ts';
import { field } from '../../src/learn/sum-of-sines/field.ts';
import { gust } from '../../src/learn/sum-of-sines/gust.ts';
import { lean } from '../../src/learn/sum-of-sines/lean.ts';
import { wave } from '../../src/learn/sum-of-sines/wave.ts';
import { windLink } from '../../src/learn/wind-link.ts';
import { gustWind } from '../../src/learn/wind-models/models.ts';
import { resonance } from '../../src/learn/wind-models/resonance.ts';
import { step } from '../../src/learn/wind-models/step.ts';
import { sway } from '../../src/learn/wind-models/sway.ts';
import { three } from '../../src/learn/wind-models/three.ts';

const read = (link: string) => {
  const reader = new LinkReader(new Map(new URLSearchParams(link)));
  const { preset, wind } = decodeWind(reader, { breeze: STILL }, { preset: 'breeze', wind: STILL });
  return { preset, wind, faults: reader.faults };
};

const keptBy = ({ controls, dragged = [] }: FigureSpec) => [...controls, ...dragged];

/** All numbers at one end, the last of each choice, each switch turned. */
const atEnd = (spec: FigureSpec, end: 'min' | 'max'): Values =>
  Object.fromEntries(
    keptBy(spec).map((kept) => [
      kept.id,
      isNumber(kept) ? kept[end] : isChoice(kept) ? (kept.options.at(-1)?.value ?? '') : !kept.value,
    ]),
  );

test('a wind of a lesson comes to the editor as it is, but for its description', () => {
  const wind = gustWind('spring', 0.7, 0.6, 0.3);
  expect(read(windLink(wind))).toEqual({
    preset: 'own',
    faults: [],
    wind: { ...roundWind(wind), description: '' },
  });
});

test.each<[string, FigureSpec]>(
  [field, wave, lean, gust, textures, lagged, three, sway, step, resonance].map((spec) => [spec.id, spec]),
)(
  'figure %s opens its own wind, on its own tree, in the editor, and its address keeps all that was dragged',
  (_, spec) => {
    for (const values of [defaultsOf(keptBy(spec)), atEnd(spec, 'min'), atEnd(spec, 'max')]) {
      const link = spec.open?.(values) ?? '';
      const { preset, faults, wind } = read(link);
      expect([preset, faults]).toEqual(['own', []]);
      expect(wind.waves.length + wind.gusts.length > 0 || wind.model === 'sway').toBe(true);
      const own = new URLSearchParams(link).get('own');
      if (own) expect(parseSpecies(JSON.parse(textFromBase64(own) ?? '')).faults).toBeUndefined();
      const kept = readFigure(writeFigure(spec.id, keptBy(spec), values), keptBy(spec));
      expect({ ...defaultsOf(keptBy(spec)), ...kept }).toEqual(values);
    }
  },
);

test('what the start of a gust is dragged to, the editor gets', () => {
  const values = { ...defaultsOf(keptBy(gust)), fx: -10.5, fy: 4 };
  expect(read(gust.open?.(values) ?? '').wind.gusts[0]).toMatchObject({ x: -10.5, y: 4 });
});
