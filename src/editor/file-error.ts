import { type Fault, faultText } from '../core/file/fault.ts';
import { messageWords } from './words/messages.ts';

/** Faults that a message lists; a file of another kind has hundreds. */
const LISTED = 8;

/** Something about a file that the reader must know; `lines` say where, what was found, what is allowed. */
export class FileError extends Error {
  override readonly name = 'FileError';
  readonly lines: readonly string[];
  constructor(title: string, lines: readonly string[] = []) {
    super(title);
    this.lines = lines;
  }

  /** What a parser found wrong, under `title`. */
  static of(title: string, faults: readonly Fault[]): FileError {
    const more = faults.length - LISTED;
    return new FileError(title, [
      ...faults.slice(0, LISTED).map(faultText),
      ...(more > 0 ? [messageWords.more(more)] : []),
    ]);
  }
}
