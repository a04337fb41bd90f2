import type { CheckProgram } from '../program.ts';
import { bendPrograms } from './bends.ts';
import { forcePrograms } from './winds-force.ts';

/** The three stages of the wind pass, function by function. */
export const windPrograms: readonly CheckProgram[] = [...forcePrograms, ...bendPrograms];
