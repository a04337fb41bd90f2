import { WAVE_NUMBERS } from '../core/link/numbers.ts';
import { GUST_NUMBERS } from '../core/link/wind-numbers.ts';
import type { Wind } from '../core/wind/wind.ts';
import { WIND_PARTS } from '../core/wind/wind-parameters.ts';
import { differences } from './made.ts';
import { stepWords as words } from './words/history.ts';

interface Blowing {
  readonly preset: string;
  readonly wind: Wind;
}

/** Numbers of the entries that differ, from 0, and the keys in which they do. */
function changedEntries(paths: readonly string[], list: 'waves' | 'gusts') {
  const found = paths.filter((path) => path.startsWith(`${list}.`)).map((path) => path.split('.'));
  return { indices: [...new Set(found.map(([, i]) => Number(i)))], keys: [...new Set(found.map(([, , key]) => key!))] };
}

/** The first place at which two lists differ. */
const firstChange = (a: readonly object[], b: readonly object[]): number => {
  const at = a.findIndex((entry, i) => differences(entry, b[i]).length > 0);
  return at < 0 ? a.length : at;
};

function wavesLabel(before: Wind, after: Wind, paths: readonly string[]): string | null {
  const [was, is] = [before.waves, after.waves];
  if (is.length > was.length) return words.waveAdded(firstChange(was, is) + 1);
  if (is.length < was.length) return words.waveRemoved(firstChange(is, was) + 1);
  const { indices, keys } = changedEntries(paths, 'waves');
  if (indices.length === 0) return null;
  if (indices.length > 1) {
    if (keys.every((key) => key === 'direction')) return words.windDirection;
    const texts = (waves: typeof was): string =>
      waves
        .map((wave) => JSON.stringify(wave))
        .toSorted()
        .join();
    return texts(was) === texts(is) ? words.waveMoved : words.waves;
  }
  const index = indices[0]!;
  const wave = is[index]!;
  if (keys.includes('solo')) return wave.solo ? words.waveAlone(index + 1) : words.wave(index + 1);
  if (keys.includes('on')) return words[wave.on ? 'on' : 'off'](words.wave(index + 1));
  // The phase goes along with others, so that the crests stay where they are.
  const meant = keys.filter((key) => key !== 'phase' || keys.length === 1);
  const number = meant.length === 1 ? WAVE_NUMBERS.find(({ key }) => key === meant[0]) : undefined;
  return number ? words.part(words.wave(index + 1), number.label) : words.wave(index + 1);
}

function gustsLabel(before: Wind, after: Wind, paths: readonly string[]): string | null {
  const [was, is] = [before.gusts.length, after.gusts.length];
  if (is > was) return words.gustAdded;
  if (is < was) return is === 0 && was > 1 ? words.gustsRemoved : words.gustRemoved;
  const { indices, keys } = changedEntries(paths, 'gusts');
  if (indices.length === 0) return null;
  // Where there are as many as can be, the oldest goes when one is thrown.
  if (indices.length > 1) return words.gustAdded;
  const number = keys.length === 1 ? GUST_NUMBERS.find(({ key }) => key === keys[0]) : undefined;
  return number ? words.part(words.gust(indices[0]! + 1), number.label) : words.gust(indices[0]! + 1);
}

/** The name of a setting by its path in the wind. */
function settingName(path: string): string {
  const [group, key] = path.split('.') as [string, string?];
  const part = group === 'profile' || group === 'spring' || group === 'sway' ? WIND_PARTS[group] : null;
  const parameters = part ? part.parameters : WIND_PARTS.whole.parameters;
  const label = parameters.find((p) => p.key === (part ? key : group))?.label.toLowerCase();
  if (label === undefined) return (part ?? WIND_PARTS.springLevels).title.toLowerCase();
  return part ? words.part(part.title.toLowerCase(), label) : label;
}

/** What was changed of a wind, in a few words; null: nothing. */
export function windLabel(before: Blowing, after: Blowing): string | null {
  const [was, is] = [before.wind, after.wind];
  const paths = differences(was, is);
  if (before.preset !== after.preset || (paths.includes('name') && paths.length > 1)) return words.wind(is.name);
  if (paths.length === 0) return null;
  if (paths.some((path) => path === 'record' || path.startsWith('record.')))
    return is.record ? words.record(is.record.name) : words.recordRemoved;
  const waves = wavesLabel(was, is, paths);
  const strength = paths.includes('strength');
  if (waves === words.windDirection && strength) return words.windTurned;
  if (waves !== null) return waves;
  const gusts = gustsLabel(was, is, paths);
  if (gusts !== null) return gusts;
  if (strength) return words.strength(is.strength);
  const settings = [...new Set(paths.map((path) => path.split('.').slice(0, 2).join('.')))];
  return settings.length === 1 ? words.ofTheWind(settingName(settings[0]!)) : words.settings(settings.length);
}
