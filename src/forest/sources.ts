import { type IndexEntry, parseIndex } from '../core/file/shipped-index.ts';
import type { ForestDocument } from '../core/forest/forest.ts';
import { parseForest } from '../core/forest/parse-forest.ts';
import type { Species } from '../core/species/species.ts';
import type { Wind } from '../core/wind/wind.ts';
import { LoadError, loadSpecies, loadText, loadWind } from '../view/load.ts';

/** A scene that ships. */
export interface Scene {
  readonly id: string;
  readonly name: string;
  readonly description: string;
  readonly document: ForestDocument;
}

async function fetchIndex(path: string): Promise<readonly IndexEntry[]> {
  const { entries, faults } = parseIndex(JSON.parse(await loadText(path)));
  if (entries) return entries;
  throw new LoadError(path, faults);
}

/** Species, winds and scenes that ship; files are fetched when they are asked for, once. */
export class Sources {
  readonly species: readonly IndexEntry[];
  readonly winds: readonly IndexEntry[];
  readonly scenes: readonly Scene[];
  readonly #species = new Map<string, Promise<Species>>();
  readonly #winds = new Map<string, Promise<Wind>>();

  private constructor(species: readonly IndexEntry[], winds: readonly IndexEntry[], scenes: readonly Scene[]) {
    this.species = species;
    this.winds = winds;
    this.scenes = scenes;
  }

  /** Throws Error where a list or a scene cannot be loaded. */
  static async load(): Promise<Sources> {
    const [species, winds, forests] = await Promise.all(
      ['species', 'winds', 'forests'].map((folder) => fetchIndex(`${folder}/index.json`)),
    );
    const known = { species: species!.map(({ id }) => id), winds: winds!.map(({ id }) => id) };
    const scenes = await Promise.all(
      forests!.map(async ({ id, name, file, description = '' }) => {
        const { forest, faults } = parseForest(await loadText(`forests/${file}`), known);
        if (!forest) throw new LoadError(file, faults);
        return { id, name, description, document: forest };
      }),
    );
    return new Sources(species!, winds!, scenes);
  }

  /** Ids of what ships. */
  get known(): { species: string[]; winds: string[] } {
    return { species: this.species.map(({ id }) => id), winds: this.winds.map(({ id }) => id) };
  }

  nameOf(species: string): string {
    return this.species.find(({ id }) => id === species)?.name ?? species;
  }

  /** The species of a mix, by id. */
  async speciesOf(ids: readonly string[]): Promise<ReadonlyMap<string, Species>> {
    const load = (id: string): Promise<Species> => loadSpecies(`species/${this.#file(this.species, id)}`);
    return new Map(await Promise.all(ids.map(async (id) => [id, await once(this.#species, id, load)] as const)));
  }

  windOf(id: string): Promise<Wind> {
    return once(this.#winds, id, () => loadWind(`winds/${this.#file(this.winds, id)}`));
  }

  #file(list: readonly IndexEntry[], id: string): string {
    return list.find((entry) => entry.id === id)?.file ?? `${id}.json`;
  }
}

/** What failed is tried again when it is asked for again. */
function once<T>(kept: Map<string, Promise<T>>, id: string, load: (id: string) => Promise<T>): Promise<T> {
  const found = kept.get(id);
  if (found) return found;
  const loading = load(id);
  kept.set(id, loading);
  loading.catch(() => kept.delete(id));
  return loading;
}
