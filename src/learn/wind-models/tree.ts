import type { PackedTree } from '../../core/pack/packed.ts';
import { windStateAt } from '../../core/wind/fade.ts';
import { Probe } from '../../core/wind/probe.ts';
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

/** What is asked what the limb does, for the tree and wind of last time. */
let asked: { tree: PackedTree; wind: Wind; probe: Probe } | null = null;
const reading = { fx: 0, fy: 0, x: 0, y: 0, z: 0 };

/** How the end of a tree's longest limb is moved at a time, and what pushes it there: metres. */
function limbMoved(tree: PackedTree, wind: Wind, time: number): { moved: number; force: number } {
  if (asked?.tree !== tree || asked.wind !== wind) {
    const probe = new Probe(tree, longLimb(tree), { wind, at: (at, out) => windStateAt(wind, at, undefined, out) });
    asked = { tree, wind, probe };
  }
  const { fx, fy, x, y, z } = asked.probe.read(Math.round(60 * time), reading);
  return { moved: Math.hypot(x, y, z), force: Math.hypot(fx, fy) };
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
    { id: 'force', label: 'Force at its longest limb', unit: 'm' },
    { id: 'moved', label: 'Its end is moved by', unit: 'cm' },
    { id: 'limb', label: 'As a spring it swings', unit: 'Hz' },
    { id: 'trunk', label: 'And the trunk', unit: 'Hz' },
  ],
  open: (values) => windLink(windFor(values)),
  stage: treeStage({
    show: (values) => ({ species: 'quaking-aspen', seed: 1, wind: sameWind(values) }),
    readouts: ({ grown: { packed } }, values, time) => {
      const hertz = (piece: number): string => (springOmega(packed, piece, STILL.spring) / (2 * Math.PI)).toFixed(2);
      const { moved, force } = limbMoved(packed, sameWind(values), time);
      return {
        force: force.toFixed(2),
        moved: (100 * moved).toFixed(1),
        limb: hertz(longLimb(packed)),
        trunk: hertz(0),
      };
    },
    text: (values) => `An aspen in gusts, moved by the model ${choiceOf(values, 'model')}.`,
  }),
};
