import { GrowthBudgetError } from '../core/grow/budget.ts';
import { NothingGrownError } from '../core/grow/nothing-grown.ts';
import { Failure } from './failure.ts';

/**
 * Whether an error says what is wrong with a species or with options, in words for its user. Ours are sentences: a RangeError without a
 * full stop is the engine's own, of a stack or a length, and no fault of theirs.
 */
export const isForeseen = (error: unknown): error is Error =>
  error instanceof GrowthBudgetError ||
  error instanceof NothingGrownError ||
  (error instanceof RangeError && error.message.endsWith('.'));

/** What `make` gives, or a Failure where it cannot for a reason that its user can change. */
export async function foreseen<T>(make: () => T | Promise<T>): Promise<T> {
  try {
    return await make();
  } catch (error) {
    throw isForeseen(error) ? new Failure(error.message) : error;
  }
}
