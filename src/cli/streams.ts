/** Where the command writes: whole lines to standard output and standard error. */
export interface Streams {
  readonly out: (line: string) => void;
  readonly err: (line: string) => void;
  /** Shows a line in place of the last one shown, or none for ''; absent where standard error is no terminal. */
  readonly progress?: ((line: string) => void) | undefined;
}
