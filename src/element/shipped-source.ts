import type { Species } from '../core/species/species.ts';
import type { Wind } from '../core/wind/wind.ts';

/** Where the species and winds that ship come from: files beside the page, or modules of a bundle. */
export interface ShippedSource {
  /** Ids that are known so far: a source of files knows none before it has read its lists. */
  readonly species: readonly string[];
  readonly winds: readonly string[];
  /** Rejects where there is none of this id, or it cannot be had. */
  speciesOf(id: string, signal?: AbortSignal): Promise<Species>;
  windOf(id: string, signal?: AbortSignal): Promise<Wind>;
}

/** How ids look; everything else is an address. */
const ID = /^[a-z0-9]+(-[a-z0-9]+)*$/;

/** Whether `name` is the id of something that ships, by its look; otherwise it is the address of a file. */
export const isShippedId = (name: string): boolean => ID.test(name);

/** There is no species or wind of this id. */
export class UnknownId extends Error {
  override readonly name = 'UnknownId';
}

/** That error, with the id that was probably meant: found by what is loaded only then. */
export async function unknownId(kind: 'species' | 'wind', id: string, known: readonly string[]): Promise<UnknownId> {
  const { nearest } = await import('../core/file/nearest.ts');
  const near = nearest(id, known);
  return new UnknownId(`No ${kind} "${id}" ships.${near ? ` Was "${near}" meant?` : ''}`);
}

/** One folder of files and its list, each read when it is first asked for and kept. */
class Folder<Item> {
  ids: readonly string[] = [];
  readonly #kind: 'species' | 'wind';
  readonly #base: () => URL;
  readonly #read: (url: URL, signal?: AbortSignal) => Promise<Item>;
  readonly #kept = new Map<string, Item>();

  constructor(kind: 'species' | 'wind', base: () => URL, read: (url: URL, signal?: AbortSignal) => Promise<Item>) {
    this.#kind = kind;
    this.#base = base;
    this.#read = read;
  }

  async of(id: string, signal?: AbortSignal): Promise<Item> {
    const known = this.#kept.get(id);
    if (known) return known;
    try {
      const item = await this.#read(new URL(`${id}.json`, this.#base()), signal);
      this.#kept.set(id, item);
      return item;
    } catch (error) {
      if (signal?.aborted) throw signal.reason;
      // A misspelt id is the commonest reason: the list can tell, where it comes at all.
      if (this.ids.length === 0) await this.#list(signal).catch(() => undefined);
      if (this.ids.length > 0 && !this.ids.includes(id)) throw await unknownId(this.#kind, id, this.ids);
      throw error;
    }
  }

  async #list(signal?: AbortSignal): Promise<void> {
    const [{ loadText }, { parseIndex }] = await Promise.all([
      import('../view/load.ts'),
      import('../core/file/shipped-index.ts'),
    ]);
    const text = await loadText(new URL('index.json', this.#base()), signal ? { signal } : {});
    this.ids = parseIndex(JSON.parse(text)).entries?.map(({ id }) => id) ?? [];
  }
}

/** Reads `BASE/species/ID.json` and `BASE/winds/ID.json` when they are asked for; `base` may be relative to the document. */
export function fetchedFrom(base: URL | string): ShippedSource {
  const folder = (name: string) => (): URL => new URL(`${name}/`, new URL(base, document.baseURI));
  const options = (signal?: AbortSignal): { signal?: AbortSignal } => (signal ? { signal } : {});
  const species = new Folder('species', folder('species'), async (url, signal) =>
    (await import('../view/load.ts')).loadSpecies(url, options(signal)),
  );
  const winds = new Folder('wind', folder('winds'), async (url, signal) =>
    (await import('../view/load.ts')).loadWind(url, options(signal)),
  );
  return {
    get species() {
      return species.ids;
    },
    get winds() {
      return winds.ids;
    },
    speciesOf: (id, signal) => species.of(id, signal),
    windOf: (id, signal) => winds.of(id, signal),
  };
}
