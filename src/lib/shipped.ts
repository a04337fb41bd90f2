import type { Species } from '../core/species/species.ts';
import type { Wind } from '../core/wind/wind.ts';
import { type ShippedSource, unknownId } from '../element/shipped-source.ts';

type Modules<T> = Record<string, () => Promise<T>>;

// Each is a module of its own, which is loaded when it is asked for: no address to configure, nothing to copy beside a bundle. The build of the
// library has read the files (build/lib-shipped.ts): what a module holds is a species, not the text of one.
const SPECIES = import.meta.glob(['../../public/species/*.json', '!**/index.json', '!**/*.schema.json'], {
  import: 'default',
}) as Modules<Species>;
const WINDS = import.meta.glob(['../../public/winds/*.json', '!**/index.json', '!**/*.schema.json'], {
  import: 'default',
}) as Modules<Wind>;

const byId = <T>(modules: Modules<T>): Map<string, () => Promise<T>> =>
  new Map(Object.entries(modules).map(([path, load]) => [path.replace(/^.*\/|\.json$/g, ''), load]));

/** A call, since bundlers take no spread for free of side effects. */
const idsOf = (modules: ReadonlyMap<string, unknown>): string[] => [...modules.keys()];

const species = /* @__PURE__ */ byId(SPECIES);
const winds = /* @__PURE__ */ byId(WINDS);

/** A copy, so that whoever changes it changes nobody else's. */
async function copyOf<T>(load: () => Promise<T>, signal: AbortSignal | undefined): Promise<T> {
  signal?.throwIfAborted();
  const one = await load();
  signal?.throwIfAborted();
  return structuredClone(one);
}

/**
 * What ships, from the package itself: a bundler makes a small file of each, and loads those that are asked for.
 *
 * `species` and `winds` are the ids. What is asked for rejects with `UnknownId` where nothing has the id, and with the signal's reason
 * where that aborts.
 *
 * @example
 * ```ts
 * import { shipped } from 'windgrove/core';
 *
 * const willow = await shipped.speciesOf('weeping-willow');
 * const gale = await shipped.windOf('gale');
 * console.log(willow.name, gale.name, shipped.species.length);
 * ```
 */
export const shipped: ShippedSource = {
  species: /* @__PURE__ */ idsOf(species),
  winds: /* @__PURE__ */ idsOf(winds),
  async speciesOf(id, signal) {
    const load = species.get(id);
    if (!load) throw await unknownId('species', id, this.species);
    return copyOf(load, signal);
  },
  async windOf(id, signal) {
    const load = winds.get(id);
    if (!load) throw await unknownId('wind', id, this.winds);
    return copyOf(load, signal);
  },
};
