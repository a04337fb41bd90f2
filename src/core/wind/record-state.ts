import { ORIGIN } from './place.ts';
import { forceOfSpeed } from './speed.ts';
import type { WindRecord } from './wind.ts';

/** Samples in a row of the record's texture. */
export const RECORD_WIDTH = 1024;

/** A measured wind as it blows at one time. Twin: the uniforms of shaders/wind/record.glsl. */
export interface RecordUniforms {
  /**
   * 4 a sample: force x, y of it and of the next one (world axes, metres), whole rows of 1024, for an RGBA32F texture as it is; the same
   * array as long as the record is the same. null: none blows.
   */
  record: Float32Array | null;
  /** At the tree's place: whole sample | fraction of the way to the next, 0..1 | samples around | weight, 0..1. */
  recordAt: Float32Array;
  /** Samples a metre downwind, as a vector in tree axes, x | y | cosine and sine of the tree's yaw. */
  recordTravel: Float32Array;
}

export const createRecordUniforms = (): RecordUniforms => ({
  record: null,
  recordAt: new Float32Array(4),
  recordTravel: new Float32Array(4),
});

/** A record made ready for playing. */
interface PlayedRecord {
  texels: Float32Array;
  count: number;
  /** Mean wind, metres a second. */
  mean: [x: number, y: number];
}

/** Seconds over which the end of a record becomes its beginning. */
const BLEND = 4;

/** Metres a second: turbulence is carried at least this fast, also by a wind that blows from everywhere. */
const SLOWEST = 0.5;

const smoothstep = (x: number): number => x * x * (3 - 2 * x);

const played = new WeakMap<WindRecord, PlayedRecord>();

/** Seconds after which a record begins again. */
export const recordSeconds = (record: WindRecord): number => record.step * countOf(record);

const countOf = ({ speed, direction }: WindRecord): number => Math.min(speed.length, direction.length);

/**
 * The samples of a record as forces (4 a sample, `RecordUniforms.record`). Its last four seconds, or the last quarter of a short one, blend
 * into its first ones played backwards, so that it goes on at the beginning without a jump and all before is as measured.
 */
export function playedRecord(record: WindRecord): PlayedRecord {
  let result = played.get(record);
  if (!result) {
    result = playRecord(record);
    played.set(record, result);
  }
  return result;
}

function playRecord(record: WindRecord): PlayedRecord {
  const count = countOf(record);
  const forces = new Float64Array(2 * count);
  let [sumX, sumY] = [0, 0];
  for (let i = 0; i < count; i++) {
    const [cos, sin] = [Math.cos(record.direction[i]), Math.sin(record.direction[i])];
    sumX += record.speed[i] * cos;
    sumY += record.speed[i] * sin;
    forces[2 * i] = forceOfSpeed(record.speed[i]) * cos;
    forces[2 * i + 1] = forceOfSpeed(record.speed[i]) * sin;
  }
  const blend = Math.min(Math.floor(count / 4), Math.ceil(BLEND / record.step));
  for (let i = 1; i < blend; i++) {
    const h = smoothstep(1 - i / blend);
    const at = 2 * (count - i);
    forces[at] += (forces[2 * i] - forces[at]) * h;
    forces[at + 1] += (forces[2 * i + 1] - forces[at + 1]) * h;
  }
  const texels = new Float32Array(4 * RECORD_WIDTH * Math.max(1, Math.ceil(count / RECORD_WIDTH)));
  for (let i = 0; i < count; i++) {
    const next = (i + 1) % count;
    texels.set([forces[2 * i], forces[2 * i + 1], forces[2 * next], forces[2 * next + 1]], 4 * i);
  }
  return { texels, count, mean: [sumX / count, sumY / count] };
}

/**
 * Writes a record as it blows at `time` seconds around a tree at `place` to `out`, with a weight of 0..1. Turbulence is frozen: the mean
 * wind carries it along, and a point downwind hears what was heard upwind (Taylor 1938, "The spectrum of turbulence").
 */
export function fillRecord(
  out: RecordUniforms,
  record: WindRecord | null,
  weight: number,
  time: number,
  place = ORIGIN,
): void {
  out.record = null;
  if (record === null || !(weight > 0) || countOf(record) < 1) return;
  const { texels, count, mean } = playedRecord(record);
  const speed = Math.hypot(...mean);
  const perMetre = speed > 0 ? 1 / (speed * Math.max(speed, SLOWEST) * record.step) : 0;
  const [gx, gy] = [mean[0] * perMetre, mean[1] * perMetre];
  const index = time / record.step - (gx * place.x + gy * place.y);
  const wrapped = index - count * Math.floor(index / count);
  const whole = Math.min(Math.floor(wrapped), count - 1);
  const [cos, sin] = [Math.cos(place.yaw), Math.sin(place.yaw)];
  out.record = texels;
  out.recordAt[0] = whole;
  out.recordAt[1] = Math.min(wrapped - whole, 1);
  out.recordAt[2] = count;
  out.recordAt[3] = weight;
  out.recordTravel[0] = gx * cos + gy * sin;
  out.recordTravel[1] = gy * cos - gx * sin;
  out.recordTravel[2] = cos;
  out.recordTravel[3] = sin;
}

/** Force of the record at (x, y) in tree axes: metres, horizontal; linear between samples. Twin: shaders/wind/record.glsl. */
export function recordForce(
  { record, recordAt, recordTravel }: RecordUniforms,
  x: number,
  y: number,
): [x: number, y: number] {
  if (record === null) return [0, 0];
  const [cos, sin] = [recordTravel[2], recordTravel[3]];
  const i = recordAt[1] - (recordTravel[0] * x + recordTravel[1] * y);
  const whole = Math.floor(i);
  const f = i - whole;
  const count = recordAt[2];
  let index = recordAt[0] + whole;
  index -= count * Math.floor((index + 0.5) / count);
  const at = 4 * index;
  const fx = (record[at] + (record[at + 2] - record[at]) * f) * recordAt[3];
  const fy = (record[at + 1] + (record[at + 3] - record[at + 1]) * f) * recordAt[3];
  return [fx * cos + fy * sin, fy * cos - fx * sin];
}
