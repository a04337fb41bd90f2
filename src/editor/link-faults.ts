import { oneLine } from '../core/file/one-line.ts';
import type { LinkFault } from '../core/link/link.ts';

/** Faults that a message lists, and the letters of each: a link can hold a megabyte of nonsense. */
const LISTED = 8;

/** What a message says of the faults of a link, a line each. */
export function linkFaultLines(faults: readonly LinkFault[]): string[] {
  const more = faults.length - LISTED;
  return [
    ...faults.slice(0, LISTED).map((f) => `${oneLine(f.key)}: found “${oneLine(f.found, 80)}”; allowed: ${f.allowed}.`),
    ...(more > 0 ? [`${more} more like these.`] : []),
  ];
}
