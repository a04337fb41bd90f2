import { hashPcg } from '../math/hash.ts';

/** Neighbours that stay together in the draw order: as many as one instance draws. */
export const BUNDLE = 64;
/** Tiers; each takes one of every 16 neighbours. */
const TIERS = 16;

/** The lowest `bits` bits of `value` in reverse. */
function reversed(value: number, bits: number): number {
  let out = 0;
  for (let b = 0; b < bits; b++) out |= ((value >> b) & 1) << (bits - 1 - b);
  return out;
}

/**
 * A draw order of `count` things whose neighbours by index are neighbours in space: place -> index.
 *
 * Any prefix is spread evenly, and every run of 64 still lies close together, which the texture cache wants: tier by tier
 * it takes one of every 16 neighbours (which one, a hash of the group says, so that no rhythm of the tree shows), and within
 * a tier bundles of 64 stand in bit-reversed order.
 */
export function spreadOrder(count: number): Uint32Array {
  const order = new Uint32Array(count);
  const groups = Math.ceil(count / TIERS);
  const bundles = Math.ceil(groups / BUNDLE);
  const bits = bundles > 1 ? 32 - Math.clz32(bundles - 1) : 0;
  let filled = 0;
  for (let tier = 0; tier < TIERS; tier++) {
    const step = reversed(tier, 4);
    for (let k = 0; k < 1 << bits; k++) {
      const bundle = reversed(k, bits);
      const end = Math.min(groups, (bundle + 1) * BUNDLE);
      for (let group = bundle * BUNDLE; group < end; group++) {
        const i = group * TIERS + ((step + hashPcg(group)) & (TIERS - 1));
        if (i < count) order[filled++] = i;
      }
    }
  }
  return order;
}

/** index -> place of an order that leads from place to index. */
export function inverseOrder(order: Uint32Array): Uint32Array {
  const place = new Uint32Array(order.length);
  for (let k = 0; k < order.length; k++) place[order[k]] = k;
  return place;
}
