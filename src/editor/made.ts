import type { LinkDocument } from '../core/link/link.ts';

/** What is looked at, not made: no step of the history, and no difference between a tree and its file. */
const LOOKED_AT = ['time', 'paused', 'rate', 'camera', 'theme'] as const;

/** What the reader made: the document without what is only looked at. */
export type Made = Omit<LinkDocument, (typeof LOOKED_AT)[number]>;

export function madeOf(document: LinkDocument): Made {
  const { time: _time, paused: _paused, rate: _rate, camera: _camera, theme: _theme, ...made } = document;
  return made;
}

const isRecord = (value: unknown): value is Readonly<Record<string, unknown>> =>
  typeof value === 'object' && value !== null;

/**
 * The places at which two values differ: `wind.waves.1.amplitude`, `edits.levels.1.downAngle`; a list that became longer or shorter, and
 * what is an object on one side alone, is one place.
 */
export function differences(a: unknown, b: unknown, path = ''): string[] {
  if (Object.is(a, b)) return [];
  const lists = Array.isArray(a) && Array.isArray(b);
  const deeper =
    isRecord(a) && isRecord(b) && Array.isArray(a) === Array.isArray(b) && !(lists && a.length !== b.length);
  if (!deeper) return [path];
  const keys = [...new Set([...Object.keys(a), ...Object.keys(b)])];
  return keys.flatMap((key) => differences(a[key], b[key], path === '' ? key : `${path}.${key}`));
}

export const sameMade = (a: Made, b: Made): boolean => differences(a, b).length === 0;
