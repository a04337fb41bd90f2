import { PIECE_LAYERS, SPRING_LAYERS, STATE_TARGETS, SWAY_LAYERS } from '../pack/layout.ts';
import type { TexelArray } from '../pack/packed.ts';
import { layerStart } from '../pack/texel-array.ts';
import { bendVector } from './bend.ts';
import { windForce } from './force.ts';
import type { Bends, WindToPose } from './push.ts';
import { swayClock, swayStir, swaySwing, swayUniform } from './sway.ts';
import type { BendModelName } from './wind.ts';

/** `piecePush` for whole trees: the same numbers, written out so that hardly anything is allocated for a piece. */
export class PushWriter {
  /** Push on the second edge (3), on the third (3), stir: of the piece last asked for. */
  readonly push = new Float64Array(7);
  readonly #pieces: Float32Array;
  readonly #attach: number;
  readonly #tip: number;
  readonly #wind: WindToPose;
  readonly #springs: Bends['springs'];
  readonly #springPlane: number;
  readonly #sway: TexelArray | undefined;
  readonly #swayParts = new Float64Array(4);
  readonly #clock = new Float64Array(2);

  constructor(pieces: TexelArray, wind: WindToPose, { springs, sway }: Bends) {
    this.#pieces = pieces.data;
    this.#attach = layerStart(pieces, PIECE_LAYERS.ATTACH);
    this.#tip = layerStart(pieces, PIECE_LAYERS.TIP);
    this.#wind = wind;
    this.#springs = springs;
    this.#springPlane = springs ? layerStart(springs.texels, 1) : 0;
    this.#sway = sway;
    swayUniform(wind.sway, wind.loudness, this.#swayParts);
    swayClock(wind.time, this.#clock);
  }

  /** Fills `push` for the piece whose texels are at `at`; `frame` is its base frame now, columns L, T and S. */
  write(at: number, frame: Float64Array): void {
    const { model, from, modelFade } = this.#wind;
    this.push.fill(0);
    if (from === null) this.#add(model, 1, at, frame);
    else {
      this.#add(from, 1 - modelFade, at, frame);
      this.#add(model, modelFade, at, frame);
    }
  }

  #add(model: BendModelName, share: number, at: number, frame: Float64Array): void {
    if (model === 'sway') this.#addSway(share, at, frame);
    else if (model === 'spring' && this.#springs) this.#addSpring(share, at, this.#springs);
    else this.#addForce(share, at);
  }

  #addForce(share: number, at: number): void {
    const wind = this.#wind;
    const pieces = this.#pieces;
    const tip = this.#tip + at;
    const force = windForce(wind, pieces[tip], pieces[tip + 1], pieces[tip + 2]);
    const beta = bendVector(force[0], force[1], pieces[tip + 3], wind.forceExponent, wind.lengthExponent);
    const attach = this.#attach + at;
    this.#share(share, beta[0], beta[1], 0, pieces[attach + 2], pieces[attach + 3]);
    this.push[6] += share * Math.sqrt(force[0] * force[0] + force[1] * force[1]);
  }

  #addSpring(share: number, at: number, { texels, state }: NonNullable<Bends['springs']>): void {
    const plane = this.#springPlane;
    const q = STATE_TARGETS.Q * plane + at;
    const force = state[STATE_TARGETS.BASE * plane + at + 3];
    const l = state[STATE_TARGETS.END * plane + at + 3];
    const t = state[q];
    const s = state[q + 1];
    const r = SPRING_LAYERS.FRAME * plane + at;
    const x = texels.data[r];
    const y = texels.data[r + 1];
    const z = texels.data[r + 2];
    const w = texels.data[r + 3];
    const attach = this.#attach + at;
    this.#share(
      share,
      (1 - 2 * (y * y + z * z)) * l + 2 * (x * y - w * z) * t + 2 * (x * z + w * y) * s,
      2 * (x * y + w * z) * l + (1 - 2 * (x * x + z * z)) * t + 2 * (y * z - w * x) * s,
      2 * (x * z - w * y) * l + 2 * (y * z + w * x) * t + (1 - 2 * (x * x + y * y)) * s,
      this.#pieces[attach + 2],
      this.#pieces[attach + 3],
    );
    const speed = Math.sqrt(state[q + 2] * state[q + 2] + state[q + 3] * state[q + 3]);
    this.push[6] += share * (force + 0.1 * this.#pieces[this.#tip + at + 3] * speed);
  }

  #addSway(share: number, at: number, frame: Float64Array): void {
    if (!this.#sway) return;
    const { data } = this.#sway;
    const gain = layerStart(this.#sway, SWAY_LAYERS.GAIN) + at;
    const offset = layerStart(this.#sway, SWAY_LAYERS.OFFSET) + at;
    const swing = swaySwing(
      data.subarray(gain, gain + 4),
      data.subarray(offset, offset + 2),
      this.#swayParts,
      this.#clock,
    );
    const [t, s] = swing;
    this.#share(
      share,
      frame[3] * t + frame[6] * s,
      frame[4] * t + frame[7] * s,
      frame[5] * t + frame[8] * s,
      data[gain],
      data[gain + 1],
    );
    this.push[6] += share * swayStir(swing, this.#swayParts);
  }

  #share(share: number, x: number, y: number, z: number, second: number, third: number): void {
    const { push } = this;
    const w2 = share * second * this.#wind.softness;
    const w3 = share * third * this.#wind.softness;
    push[0] += w2 * x;
    push[1] += w2 * y;
    push[2] += w2 * z;
    push[3] += w3 * x;
    push[4] += w3 * y;
    push[5] += w3 * z;
  }
}
