import { springOmega } from '../../core/wind/spring-texels.ts';
import { type BendModelName, DEFAULT_GUST, STILL, type Wind } from '../../core/wind/wind.ts';
import { choiceOf, type FigureSpec, numberOf, type Values } from '../figure.ts';
import { someWaves } from '../sum-of-sines/waves.ts';
import { treeStage } from '../tree-stage.ts';
import { windLink } from '../wind-link.ts';
import { longLimb } from './three.ts';

const modelOf = (values: Values): BendModelName => {
  const model = choiceOf(values, 'model');
  return model === 'direct' || model === 'sway' ? model : 'spring';
};

const windFor = (values: Values): Wind => ({
  ...STILL,
  name: 'Breeze with gusts',
  model: modelOf(values),
  strength: numberOf(values, 'strength'),
  waves: someWaves(4, 2.2, 0.26, 1.2),
  gusts: [{ ...DEFAULT_GUST, start: 1, amplitude: 0.45, x: -12, rise: 0.7, fall: 1.8, width: 0, repeat: 9 }],
});

/** The last wind: while nothing changes it must be the same object. */
let last: { key: string; wind: Wind } | null = null;

function sameWind(values: Values): Wind {
  const key = JSON.stringify(values);
  if (last?.key !== key) last = { key, wind: windFor(values) };
  return last.wind;
}

/** One aspen, whose model can be switched. */
export const tree: FigureSpec = {
  id: 'tree',
  title: 'An aspen',
  aspect: 1.25,
  moves: true,
  begin: 3.4,
  controls: [
    {
      id: 'model',
      label: 'Model',
      value: 'spring',
      options: [
        { value: 'direct', label: 'Direct, 2007' },
        { value: 'sway', label: 'Sway, 1995' },
        { value: 'spring', label: 'Spring' },
      ],
    },
    { id: 'strength', label: 'Strength of the wind', min: 0, max: 1, step: 0.05, value: 0.8 },
  ],
  readouts: [
    { id: 'pieces', label: 'Branch pieces' },
    { id: 'limb', label: 'Its longest limb swings', unit: 'Hz' },
    { id: 'trunk', label: 'Its trunk', unit: 'Hz' },
  ],
  open: (values) => windLink(windFor(values)),
  stage: treeStage({
    show: (values) => ({ species: 'quaking-aspen', seed: 1, wind: sameWind(values) }),
    readouts: ({ grown: { packed } }) => {
      const hertz = (piece: number): string => (springOmega(packed, piece, STILL.spring) / (2 * Math.PI)).toFixed(2);
      return { pieces: packed.pieceCount, limb: hertz(longLimb(packed)), trunk: hertz(0) };
    },
    text: (values) => `An aspen in gusts, moved by the model ${choiceOf(values, 'model')}.`,
  }),
};
