/** One line of the report: how far the GPU is from the reference. */
export interface Check {
  readonly name: string;
  readonly pass: boolean;
  /** Comparisons made; a check of none fails. */
  readonly samples: number;
  /** Largest error; -1 stands for a number that is not finite, which JSON cannot hold. */
  readonly maxError: number;
  readonly tolerance: number;
  /** Unit of the error, and why the tolerance is what it is. */
  readonly note: string;
}

/** What the page finds out; the text of the element `#report`. */
export interface Report {
  readonly renderer: string;
  readonly pass: boolean;
  readonly checks: readonly Check[];
  /** Why there are no checks, where the GPU cannot run them. */
  readonly reason?: string;
  readonly milliseconds: number;
}

/** A check that passes when there are samples and the error is a number within the tolerance. */
export function check(name: string, samples: number, maxError: number, tolerance: number, note: string): Check {
  const finite = Number.isFinite(maxError);
  return {
    name,
    pass: samples > 0 && finite && maxError <= tolerance,
    samples,
    maxError: finite ? maxError : -1,
    tolerance,
    note,
  };
}

/** The checks as a report: it passes when there are some and all pass. */
export const report = (renderer: string, checks: readonly Check[], milliseconds: number, reason?: string): Report => ({
  renderer,
  pass: checks.length > 0 && checks.every((one) => one.pass),
  checks,
  milliseconds,
  ...(reason === undefined ? {} : { reason }),
});
