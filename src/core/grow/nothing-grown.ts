import type { Species } from '../species/species.ts';

/** Not one stem grew, so there is nothing to draw; the message says what to change. */
export class NothingGrownError extends Error {
  override readonly name = 'NothingGrownError';
  constructor({ levels }: Species, seed: number) {
    const { length, lengthV } = levels[0];
    super(
      `The trunk has no length with seed ${seed}. Raise levels[0].length, which is ${length}` +
        `${lengthV > 0 ? `, or lower levels[0].lengthV, which is ${lengthV}` : ''}.`,
    );
  }
}
