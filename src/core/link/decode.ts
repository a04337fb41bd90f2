import type { Wave, Wind } from '../wind/wind.ts';
import { type CameraPose, type LinkDocument, THEMES, VIEW_MODES } from './document.ts';
import { roundDocument, roundTime } from './encode.ts';
import { allowed, CAMERA_NUMBERS, LINK_NUMBERS, type NumberRule, readNumber, WAVE_NUMBERS } from './numbers.ts';
import { textFromBase64 } from './text.ts';
import { shownNumber, withNumber } from './waves.ts';

/** One value of a link that could not be used. */
export interface LinkFault {
  /** Where: a key of the link, or `w2 speed`, `cam distance`. */
  readonly key: string;
  /** What stood there, as it stood; text from outside, never markup. */
  readonly found: string;
  /** What may stand there, in words. */
  readonly allowed: string;
}

export interface DecodeOptions {
  /** What is used where the link says nothing, or nonsense. */
  readonly defaults: LinkDocument;
  /** Ids of the species that ship. */
  readonly species: readonly string[];
  /** Presets of the wind by id. */
  readonly winds: Readonly<Record<string, Wind>>;
}

/**
 * Reads what `encodeLink` wrote, or a person typed: each value that is wrong gives a fault and its default, the rest applies.
 *
 * Never throws. Keys that no link has are faults too: most often they are a slip of the pen.
 */
export function decodeLink(link: string, options: DecodeOptions): { document: LinkDocument; faults: LinkFault[] } {
  const { defaults, species, winds } = options;
  const faults: LinkFault[] = [];
  const values = new Map(new URLSearchParams(link.replace(/^[#?]/, '')));

  const take = (key: string): string | undefined => {
    const value = values.get(key);
    values.delete(key);
    return value;
  };
  const fault = (key: string, found: string, allowed: string): void => void faults.push({ key, found, allowed });
  const read = <T>(key: string, fallback: T, allowedWords: string, parse: (text: string) => T | undefined): T => {
    const text = take(key);
    if (text === undefined) return fallback;
    const value = parse(text);
    if (value === undefined) fault(key, text, allowedWords);
    return value ?? fallback;
  };
  const number = (key: keyof typeof LINK_NUMBERS, fallback: number): number =>
    read(key, fallback, allowed(LINK_NUMBERS[key]), (text) => readNumber(LINK_NUMBERS[key], text));
  const flag = (key: string, fallback: boolean): boolean =>
    read(key, fallback, '0 or 1', (text) => (text === '1' ? true : text === '0' ? false : undefined));
  const choice = <T extends string>(key: string, fallback: T, among: readonly T[]): T =>
    read(key, fallback, among.join(', '), (text) => among.find((entry) => entry === text));

  /** A list of numbers, each bad one in its fallback's stead; null where it is no such list, or has no fallback. */
  const list = (key: string, text: string, rules: readonly NumberRule[], fallback?: readonly number[]) => {
    const parts = text.split(',');
    const numbers = rules.map((rule, i) => readNumber(rule, parts[i] ?? ''));
    if (parts.length !== rules.length || (!fallback && numbers.includes(undefined))) {
      fault(key, text, `${rules.length} numbers: ${rules.map((r) => `${r.label} (${r.min} to ${r.max})`).join(', ')}`);
      return null;
    }
    return numbers.map((value, i) => {
      if (value === undefined) fault(`${key} ${rules[i]!.label}`, parts[i]!, allowed(rules[i]!));
      return value ?? fallback![i]!;
    });
  };

  const camera = (): CameraPose | null => {
    const text = take('cam');
    const numbers = text === undefined ? null : list('cam', text, CAMERA_NUMBERS);
    if (!numbers) return text === undefined ? defaults.camera : null;
    const [azimuth, elevation, distance, x, y, z] = numbers as [number, number, number, number, number, number];
    return { azimuth, elevation, distance, target: [x, y, z] };
  };

  const wave = (key: string, fallback: Wave): Wave => {
    const text = take(key);
    if (text === undefined) return fallback;
    const off = text.endsWith(',off');
    const before = WAVE_NUMBERS.map((n) => shownNumber(fallback, n));
    const numbers = list(key, off ? text.slice(0, -4) : text, WAVE_NUMBERS, before);
    if (!numbers) return fallback;
    return WAVE_NUMBERS.reduce((w, n, i) => withNumber(w, n, numbers[i]!), { ...fallback, on: !off });
  };

  const preset = choice('wind', defaults.preset, Object.keys(winds));
  const base = winds[preset] ?? defaults.wind;
  const own = read('own', null, 'a species file as base64url', (text) => textFromBase64(text) ?? undefined);
  const document = roundDocument({
    species: choice('s', defaults.species, species),
    ownSpecies: own,
    seed: number('seed', defaults.seed),
    time: roundTime(number('t', defaults.time)),
    paused: flag('paused', defaults.paused),
    rate: number('rate', defaults.rate),
    camera: camera(),
    levelsShown: number('levels', defaults.levelsShown),
    showLeaves: flag('leaves', defaults.showLeaves),
    view: choice('view', defaults.view, VIEW_MODES),
    theme: choice('theme', defaults.theme, THEMES),
    blowing: flag('blow', defaults.blowing),
    preset,
    wind: {
      ...base,
      strength: number('strength', base.strength),
      waves: base.waves.map((fallback, i) => wave(`w${i + 1}`, fallback)),
      forceExponent: number('p', base.forceExponent),
      lengthExponent: number('m', base.lengthExponent),
      pose: choice('pose', base.pose, ['exact', 'lagged']),
      paper: flag('paper', base.paper),
    },
  });
  for (const [key, value] of values) fault(key, value, 'nothing of this name');
  return { document, faults };
}
