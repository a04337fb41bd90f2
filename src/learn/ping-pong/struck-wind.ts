import { createWindState, type WindState, windStateAt } from '../../core/wind/fade.ts';
import type { Wind } from '../../core/wind/wind.ts';
import { STEP } from '../../gpu/step.ts';
import type { WindSource } from '../../gpu/wind-source.ts';
import { someWaves, windOf } from '../sum-of-sines/waves.ts';
import { steadyGust } from './chain.ts';

const SOFT = { strength: 1, lengthExponent: 0.6, stiffness: 0.5 } as const;
/** What blows while nothing is struck. */
export const BREEZE = windOf(someWaves(4, 2.2, 0.3, 1), SOFT);
const STRUCK = windOf([], { ...SOFT, gusts: [steadyGust(0.4)] });
const CALM = windOf([], SOFT);

/**
 * A breeze; or, `struck`, a push that is there at once with step 0 and gone at once `turn` steps later, and so on: after a blow a pose that
 * lags is seen to come home depth by depth.
 */
export class StruckWind implements WindSource {
  pose: Wind['pose'] = 'exact';
  revision = 1;
  readonly epoch = 1;
  readonly past = 1;
  readonly turn: number;
  #struck = false;

  constructor(turn: number) {
    this.turn = turn;
  }

  get struck(): boolean {
    return this.#struck;
  }

  set struck(struck: boolean) {
    if (struck === this.#struck) return;
    this.#struck = struck;
    this.revision++;
  }

  fill(time: number, out: WindState): void {
    windStateAt(this.#windAt(Math.round(time / STEP)), time, undefined, out);
  }

  at(time: number): WindState {
    const state = createWindState();
    this.fill(time, state);
    return state;
  }

  #windAt(step: number): Wind {
    if (!this.#struck) return BREEZE;
    return step >= 0 && Math.floor(step / this.turn) % 2 === 0 ? STRUCK : CALM;
  }
}
