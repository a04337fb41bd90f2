import { WindFader } from '../../core/wind/fade.ts';
import { DEFAULT_WAVE, type Gust, STILL, type Wave, type Wind, type WindRecord } from '../../core/wind/wind.ts';
import { wizardWind } from '../../core/wind/wizard.ts';
import { type WindSource, windSource } from '../wind-source.ts';

const MIDDLING = { steadiness: 0.3, turbulence: 0.6, stiffness: 1, direction: 0.7, seed: 1 };

/** Beaufort 8: twigs break. */
export const gale: Wind = { ...wizardWind({ ...MIDDLING, beaufort: 8 }), name: 'gale' };

/** Beaufort 11, the most that the wizard has. */
export const violentStorm: Wind = { ...wizardWind({ ...MIDDLING, beaufort: 11 }), name: 'violent storm' };

/** A gale for a model; sways by numbers of its own. */
export const galeOf = (model: Wind['model'], pose: Wind['pose'] = 'exact'): Wind => ({
  ...gale,
  model,
  pose,
  sway: { ...STILL.sway, speed: 30, gust: 15 },
});

const gust: Gust = {
  start: 1,
  x: -5,
  y: 0,
  direction: 0.5,
  speed: 12,
  amplitude: 0.5,
  rise: 0.4,
  fall: 1.5,
  width: 30,
  repeat: 0,
};

const record: WindRecord = {
  name: 'a slow turn',
  step: 0.1,
  speed: Array.from({ length: 90 }, (_, i) => 8 + 4 * Math.sin(i / 7)),
  direction: Array.from({ length: 90 }, (_, i) => 0.5 * Math.sin(i / 20)),
};

const waves = (count: number, direction: number): Wave[] =>
  Array.from({ length: count }, (_, i) => ({
    ...DEFAULT_WAVE,
    amplitude: 0.12,
    direction: direction + 0.2 * i,
    wavelength: 8 + 5 * i,
    phase: 0.3 * i,
  }));

/** The printed forms; not the wizard's wave, whose crest the paper's sign turns into a trough that is as steep as it can be. */
export const printed: Wind = { ...galeOf('direct'), waves: waves(4, 0.7), paper: true };

/** Everything that a force can be made of, so that the shader with all of it runs: 8 waves, gusts, a height profile, a record. */
const everything: Wind = {
  ...STILL,
  name: 'everything',
  waves: waves(8, 0),
  gusts: [gust, { ...gust, start: 1.5, direction: -0.4, width: 0, repeat: 5 }],
  profile: { ...STILL.profile, kind: 'log' },
  zeroMean: true,
  record,
};

/** A wind that fades into another from time 0 on, as a function of time alone. */
function fading(from: Wind, to: Wind, seconds: number): WindSource {
  const fader = new WindFader(from);
  fader.set(to, 0, seconds);
  return {
    ...windSource(to),
    fill: (time, out) => {
      fader.at(time, undefined, out);
    },
  };
}

/** Winds that ask for other shaders than the usual ones, each by its name. */
export function rareWinds(): (readonly [name: string, source: WindSource])[] {
  const models = ['direct', 'spring', 'sway'] as const;
  const pairs = models.flatMap((from) => models.filter((to) => to !== from).map((to) => [from, to] as const));
  return [
    ...(['direct', 'spring'] as const).map((model) => {
      const name = `${model}, 8 waves, gusts, profile and record`;
      return [name, windSource({ ...everything, model })] as const;
    }),
    ...(['direct', 'spring'] as const).map((model) => {
      const other = { ...everything, model, waves: waves(8, 1), record: null };
      return [
        `${model}, 16 waves while one wind fades into another`,
        fading({ ...everything, model }, other, 3),
      ] as const;
    }),
    ...pairs.map(([from, to]) => [`${from} fading into ${to}`, fading(galeOf(from), galeOf(to), 2)] as const),
    ['spring, lagged, fading into sway', fading(galeOf('spring', 'lagged'), galeOf('sway', 'lagged'), 2)],
    ['spring, paper', windSource({ ...printed, model: 'spring' })],
    ['sway, paper', windSource({ ...printed, model: 'sway' })],
  ];
}
