import { MECHANICS, MECHANICS_SIZE, PIECE_LAYERS, TEXEL } from '../../core/pack/layout.ts';
import type { PackedTree } from '../../core/pack/packed.ts';
import { layerStart } from '../../core/pack/texel-array.ts';
import type { WindState } from '../../core/wind/fade.ts';

/** Stems of a level that are looked at; its draw order is spread evenly. */
const SAMPLE = 48;

/** Deflection of a tip whose direction is bent by 1, in lengths: the integral of z^1.8. */
const ASIDE = 1 / 2.8;

/**
 * Stems do not all swing at once at their widest: the fastest hundredth of the tips of aspens, willows and oaks moves at about a sixth of
 * the sum, in a breeze and in a gale (measured).
 */
const AT_ONCE = 1 / 6;

/** Frequencies above this are swung at small amplitudes: what a wind drives is slower. rad/s */
const DRIVEN = 5;

interface Stem {
  readonly third: number;
  /** Metres a second of the tip for a bend of 1. */
  readonly quick: number;
}

/** How fast the twigs of a tree move, judged from a sample of its stems. */
export class GroveMotion {
  readonly #levels: readonly (readonly Stem[])[];
  #exponent = Number.NaN;
  #gain = 0;

  constructor({ branches, levels, mechanics, pieces }: PackedTree) {
    const tips = layerStart(pieces, PIECE_LAYERS.TIP) + 3;
    this.#levels = levels.map(({ start, count }) =>
      Array.from({ length: Math.min(count, SAMPLE) }, (_, k) => {
        const piece = branches.data[TEXEL * (start + k)] as number;
        const at = MECHANICS_SIZE * piece;
        const part = (entry: number): number => mechanics[at + entry] as number;
        const omega = Math.min(part(MECHANICS.OMEGA), DRIVEN);
        return {
          third: Math.max(pieces.data[tips + TEXEL * piece] as number, 1e-3),
          quick: ASIDE * part(MECHANICS.LENGTH) * part(MECHANICS.FLEXIBILITY) * omega,
        };
      }),
    );
  }

  /** Metres a second that the tips move at most, about; `force`: metres, in the middle of the tree now. */
  speed({ waves, count, lengthExponent, softness, loudness, model, sway }: Readonly<WindState>, force: number): number {
    if (lengthExponent !== this.#exponent) {
      this.#exponent = lengthExponent;
      // Each level is carried along by the one below.
      this.#gain = this.#levels.reduce((sum, stems) => sum + mean(stems, lengthExponent), 0);
    }
    let peaks = 0;
    for (let i = 0; i < count; i++) peaks += waves[4 * i + 2] as number;
    if (model === 'sway') peaks = 0.01 * (sway.speed + sway.gust) * loudness;
    return AT_ONCE * this.#gain * softness * 0.5 * (peaks + force);
  }
}

const mean = (stems: readonly Stem[], exponent: number): number =>
  stems.reduce((sum, { third, quick }) => sum + quick * third ** -exponent, 0) / Math.max(1, stems.length);
