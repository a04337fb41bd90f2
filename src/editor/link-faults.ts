import { oneLine } from '../core/file/one-line.ts';
import type { LinkFault } from '../core/link/link.ts';
import { messageWords } from './words/messages.ts';

/** Faults that a message lists, and the letters of each: a link can hold a megabyte of nonsense. */
const LISTED = 8;

/** What a message says of the faults of a link, a line each. */
export function linkFaultLines(faults: readonly LinkFault[]): string[] {
  const more = faults.length - LISTED;
  return [
    ...faults.slice(0, LISTED).map((f) => messageWords.linkFault(oneLine(f.key), oneLine(f.found, 80), f.allowed)),
    ...(more > 0 ? [messageWords.more(more)] : []),
  ];
}
