/** Where the command writes: whole lines to standard output and standard error. */
export interface Streams {
  readonly out: (line: string) => void;
  readonly err: (line: string) => void;
}
