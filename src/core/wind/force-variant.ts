import type { ForceUniforms } from './force.ts';
import { MAX_GUSTS } from './gust.ts';

/** What a force shader must be able to do: the defines of shaders/wind/force.glsl. Each variant costs only what it names. */
export type ForceDefines = {
  WIND_WAVES: 4 | 8 | 16;
  WIND_GUSTS: 0 | 8;
  WIND_PROFILE: 0 | 1;
  WIND_RECORD: 0 | 1;
};

/** The least that the force at this time asks of a shader. */
export const forceDefines = ({ count, gustCount, profiled, record }: ForceUniforms): ForceDefines => ({
  WIND_WAVES: count > 8 ? 16 : count > 4 ? 8 : 4,
  WIND_GUSTS: gustCount > 0 ? MAX_GUSTS : 0,
  WIND_PROFILE: profiled,
  WIND_RECORD: record === null ? 0 : 1,
});

/**
 * The values of the shader's uniforms, the state's own arrays: as good for all later fills. `windRecord` is a texture, which the
 * caller makes of `record` (1024 texels wide).
 */
export const forceUniforms = ({ waves, phases, gusts, profile, recordAt, recordTravel }: ForceUniforms) => ({
  windWaves: waves,
  windPhases: phases,
  windGusts: gusts,
  windProfile: profile,
  windRecordAt: recordAt,
  windRecordTravel: recordTravel,
});
