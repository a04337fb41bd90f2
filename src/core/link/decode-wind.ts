import {
  DEFAULT_GUST,
  DEFAULT_WAVE,
  type Gust,
  MOST_GUSTS,
  MOST_WAVES,
  SPRING_LEVELS,
  type SpringLevel,
  STILL,
  type Wave,
  type Wind,
  type WindRecord,
} from '../wind/wind.ts';
import { OWN_WIND } from './document.ts';
import { WAVE_NUMBERS } from './numbers.ts';
import type { LinkReader } from './reader.ts';
import { allowed, readNumber } from './rule.ts';
import { shownNumber, withGustNumber, withNumber } from './waves.ts';
import { GUST_NUMBERS, PROFILE_NUMBERS, SPRING_NUMBERS, SWAY_NUMBERS, WIND_NUMBERS } from './wind-numbers.ts';

export type Winds = Readonly<Record<string, Wind>>;

/** Keys that every link has which this program wrote: such a link says all of its wind, and the ones that it lacks are plain. */
const ALWAYS = ['strength', 'p', 'm'] as const;

/**
 * Reads a wind and the id of that which it began as.
 *
 * A link that was written whole means the same for ever: what it leaves out is as in `STILL`, and where it names no model it is
 * from the time when there was one, `direct`. A line that somebody typed changes the wind that it names.
 */
export function decodeWind(reader: LinkReader, winds: Winds, fallback: { preset: string; wind: Wind }) {
  const preset = reader.choice('wind', fallback.preset, [...Object.keys(winds), OWN_WIND]);
  const named = winds[preset] ?? fallback.wind;
  const whole = ALWAYS.every((key) => reader.has(key));
  const base: Wind = whole
    ? { ...STILL, name: named.name, description: named.description, waves: named.waves, model: 'direct' }
    : named;
  const own = preset === OWN_WIND;
  const text = (key: string, before: string): string => (own ? (reader.take(key) ?? before) : before);
  const wind: Wind = {
    ...base,
    name: text('name', base.name),
    description: text('says', own && whole ? '' : base.description),
    strength: reader.linkNumber('strength', base.strength),
    waves: waves(reader, base.waves, whole),
    gusts: gusts(reader, base.gusts),
    profile: profile(reader, base),
    zeroMean: reader.flag('zero', base.zeroMean),
    record: record(reader, base, winds),
    stiffness: reader.number('stiff', WIND_NUMBERS.stiffness, base.stiffness),
    model: reader.choice('model', base.model, ['direct', 'spring', 'sway']),
    spring: { ...spring(reader, base), levels: springLevels(reader, base.spring.levels) },
    sway: sway(reader, base),
    forceExponent: reader.linkNumber('p', base.forceExponent),
    lengthExponent: reader.linkNumber('m', base.lengthExponent),
    pose: reader.choice('pose', base.pose, ['exact', 'lagged']),
    paper: reader.flag('paper', base.paper),
  };
  return { preset, wind };
}

/** As many as the link says; else those that it lists where it was written whole, or those of the wind that it changes. */
function waves(reader: LinkReader, before: readonly Wave[], whole: boolean): Wave[] {
  const listed = Array.from({ length: MOST_WAVES }, (_, i) => i + 1).filter((i) => reader.has(`w${i}`));
  const last = listed.at(-1) ?? 0;
  const count = reader.linkNumber('waves', whole && last > 0 ? last : Math.max(before.length, last));
  return Array.from({ length: count }, (_, i) => wave(reader, `w${i + 1}`, before[i] ?? DEFAULT_WAVE));
}

function wave(reader: LinkReader, key: string, fallback: Wave): Wave {
  const text = reader.take(key);
  if (text === undefined) return { ...fallback };
  const [, list, off, solo] = /^(.*?)(,off)?(,solo)?$/s.exec(text)!;
  const before = WAVE_NUMBERS.map((n) => shownNumber(fallback, n));
  const numbers = reader.list(key, list!, WAVE_NUMBERS, before);
  if (!numbers) return { ...fallback };
  return WAVE_NUMBERS.reduce((w, n, i) => withNumber(w, n, numbers[i]!), { ...fallback, on: !off, solo: !!solo });
}

function gusts(reader: LinkReader, before: readonly Gust[]): Gust[] {
  const keys = Array.from({ length: MOST_GUSTS }, (_, i) => `g${i + 1}`).filter((key) => reader.has(key));
  if (keys.length === 0) return [...before];
  return keys.flatMap((key) => {
    const text = reader.take(key)!;
    // Older links have no repeat, and those of gusts that come once leave it out.
    const once = text.split(',').length === GUST_NUMBERS.length - 1;
    const numbers = reader.list(key, once ? `${text},${DEFAULT_GUST.repeat}` : text, GUST_NUMBERS);
    return numbers ? [GUST_NUMBERS.reduce((g, n, i) => withGustNumber(g, n, numbers[i]!), {} as Gust)] : [];
  });
}

function profile(reader: LinkReader, { profile: before }: Wind): Wind['profile'] {
  const numbers = [before.height, before.roughness, before.exponent];
  const found = reader.wordAndNumbers('profile', ['none', 'log', 'power'], PROFILE_NUMBERS, numbers);
  if (!found) return before;
  const [height, roughness, exponent] = found.numbers as [number, number, number];
  return { kind: found.word, height, roughness, exponent };
}

/** A record that ships, by its name; `sample` is the first of them. One of the reader's own is in no link. */
function record(reader: LinkReader, base: Wind, winds: Winds): WindRecord | null {
  const shipped = Object.values(winds).flatMap((w) => (w.record ? [w.record] : []));
  const names = shipped.map((r) => r.name).join(', ');
  return reader.read('rec', base.record, `sample${names && ` or ${names}`}; open a record of your own again`, (text) =>
    text === 'sample' ? shipped[0] : shipped.find((r) => r.name === text),
  );
}

function spring(reader: LinkReader, { spring: before }: Wind): Omit<Wind['spring'], 'levels'> {
  const text = reader.take('spring');
  const numbers =
    text === undefined
      ? null
      : reader.list('spring', text, SPRING_NUMBERS, [before.frequency, before.damping, before.inertia]);
  if (!numbers) return before;
  const [frequency, damping, inertia] = numbers as [number, number, number];
  return { frequency, damping, inertia };
}

/** `0.8,grown,2`: a number for each level that has one of its own. */
function springLevels(reader: LinkReader, before: readonly SpringLevel[]): SpringLevel[] {
  const column = (key: string, rule: typeof WIND_NUMBERS.hertz | typeof WIND_NUMBERS.damping) => {
    const text = reader.take(key);
    if (text === undefined) return null;
    return text
      .split(',')
      .slice(0, SPRING_LEVELS)
      .map((part, i) => {
        if (part === 'grown') return null;
        const value = readNumber(rule, part);
        if (value === undefined) reader.fault(`${key} level ${i}`, part, `${allowed(rule)}, or grown`);
        return value ?? null;
      });
  };
  const hertz = column('levelhz', WIND_NUMBERS.hertz);
  const damping = column('leveldamp', WIND_NUMBERS.damping);
  if (!hertz && !damping) return [...before];
  return Array.from({ length: Math.max(hertz?.length ?? 0, damping?.length ?? 0) }, (_, i) => ({
    frequency: hertz?.[i] ?? null,
    damping: damping?.[i] ?? null,
  }));
}

function sway(reader: LinkReader, { sway: before }: Wind): Wind['sway'] {
  const numbers = [before.speed, before.gust, before.rate];
  const found = reader.wordAndNumbers('sway', ['ratio', 'cantilever'], SWAY_NUMBERS, numbers);
  if (!found) return before;
  const [speed, gust, rate] = found.numbers as [number, number, number];
  return { reading: found.word, speed, gust, rate };
}
