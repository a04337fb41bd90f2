import type { WindState } from '../core/wind/fade.ts';
import { forceDefines } from '../core/wind/force-variant.ts';
import { uses } from '../core/wind/push.ts';
import type { BendModelName } from '../core/wind/wind.ts';

/** The wind's programs: the pose, one step of the springs, and the springs' state at the start of a run. */
export type ProgramOf = 'pose' | 'spring' | 'spring seed';

const PROGRAMS: readonly ProgramOf[] = ['pose', 'spring', 'spring seed'];
/** As WIND_MODEL and WIND_FROM number them. */
const MODELS: readonly BendModelName[] = ['direct', 'spring', 'sway'];
const WAVES = [4, 8, 16];

/** The parts of a variant and how many values each has, the first counting least. */
const SIZES = { waves: 3, gusts: 2, profile: 2, record: 2, paper: 2, model: 3, from: 4, whole: 2, program: 3 } as const;
type Parts = Record<keyof typeof SIZES, number>;
const NAMES = Object.keys(SIZES) as (keyof Parts)[];

const pack = (parts: Parts): number => NAMES.reduceRight((sum, name) => sum * SIZES[name] + parts[name], 0);

function unpack(variant: number): Parts {
  let rest = variant;
  return Object.fromEntries(
    NAMES.map((name) => {
      const part = rest % SIZES[name];
      rest = Math.floor(rest / SIZES[name]);
      return [name, part];
    }),
  ) as Parts;
}

const NO_FORCE = { waves: 0, gusts: 0, profile: 0, record: 0 };

/**
 * The number of the least shader that does what a wind asks of a program: what it does not use makes no difference. `whole`: springs
 * are asked for at a step, not between two.
 */
export function variantOf(program: ProgramOf, wind: WindState, whole = false): number {
  const defines = forceDefines(wind);
  const force = {
    waves: WAVES.indexOf(defines.WIND_WAVES),
    gusts: defines.WIND_GUSTS > 0 ? 1 : 0,
    profile: defines.WIND_PROFILE,
    record: defines.WIND_RECORD,
  };
  const number = PROGRAMS.indexOf(program);
  if (program !== 'pose') return pack({ ...force, paper: 0, model: 0, from: MODELS.length, whole: 0, program: number });
  const direct = uses(wind, 'direct');
  return pack({
    ...(direct ? force : NO_FORCE),
    paper: wind.paper ? 1 : 0,
    model: MODELS.indexOf(wind.model),
    from: wind.from === null ? MODELS.length : MODELS.indexOf(wind.from),
    whole: whole && uses(wind, 'spring') ? 1 : 0,
    program: number,
  });
}

/** What a variant is, in the words of its shader. */
export function definesOf(variant: number): { program: ProgramOf; defines: Record<string, number> } {
  const parts = unpack(variant);
  const program = PROGRAMS[parts.program];
  const force: Record<string, number> = {
    WIND_WAVES: WAVES[parts.waves],
    WIND_GUSTS: 8 * parts.gusts,
    WIND_PROFILE: parts.profile,
    WIND_RECORD: parts.record,
  };
  if (program === 'spring') return { program, defines: force };
  if (program === 'spring seed') return { program, defines: { ...force, SPRING_SEED: 1 } };
  return {
    program,
    defines: {
      ...force,
      WIND_MODEL: parts.model,
      ...(parts.from < MODELS.length ? { WIND_FROM: parts.from } : {}),
      ...(parts.paper ? { WIND_PAPER: 1 } : {}),
      ...(parts.whole ? { SPRING_WHOLE: 1 } : {}),
    },
  };
}

/** What is likely to come next where a variant is in use: a fade, which has twice the waves, and a gust. */
export function variantsToWarm(variant: number): number[] {
  const parts = unpack(variant);
  const program = PROGRAMS[parts.program];
  // A spring is posed at a step where time stands, and between two where it runs.
  if (program === 'pose' && MODELS[parts.model] === 'spring') return [pack({ ...parts, whole: 1 - parts.whole })];
  const evaluates = program === 'spring' || (program === 'pose' && MODELS[parts.model] === 'direct');
  if (!evaluates || parts.from < MODELS.length) return [];
  const more = { ...parts, waves: Math.min(parts.waves + 1, WAVES.length - 1) };
  return [more, { ...parts, gusts: 1 }, { ...more, gusts: 1 }].map(pack).filter((each) => each !== variant);
}
