import type { LinkDocument } from '../core/link/link.ts';
import { editSpecies } from '../core/species/edits.ts';
import type { Species } from '../core/species/species.ts';
import { type GrownTree, type GrowProgress, growTree } from '../view/picture/grow-tree.ts';
import type { Actions } from './actions.ts';
import { type DocumentStore, watch } from './document-store.ts';
import { FileError } from './file-error.ts';
import type { SessionStore } from './session.ts';
import { loadSpecies, readSpecies } from './species-source.ts';

type Wish = Pick<LinkDocument, 'species' | 'ownSpecies' | 'edits' | 'seed'>;

const same = (a: Wish, b: Wish | null): boolean =>
  b !== null && a.species === b.species && a.ownSpecies === b.ownSpecies && a.edits === b.edits && a.seed === b.seed;

/** Growing takes about half of the time, fitting and packing the rest. */
const stages = { grow: [0, 0.5], fit: [0.5, 0.35], pack: [0.85, 0.15] } as const;

function overall({ stage, done }: GrowProgress): number {
  const [start, share] = stages[stage];
  return start + share * done;
}

/**
 * Grows what the document asks for, in the worker; the latest wish wins, and the tree on the screen stays until the next one
 * stands. A wish that cannot be granted gives a message, and the document goes back to the tree on the screen.
 */
export class Grower {
  private shown: Wish | null = null;
  private wish: Wish | null = null;
  private abort: AbortController | null = null;

  private readonly document: DocumentStore;
  private readonly session: SessionStore;
  private readonly actions: Actions;
  private readonly onTree: (tree: GrownTree, species: Species) => void;

  constructor(
    document: DocumentStore,
    session: SessionStore,
    actions: Actions,
    onTree: (tree: GrownTree, species: Species) => void,
  ) {
    this.document = document;
    this.session = session;
    this.actions = actions;
    this.onTree = onTree;
    watch(
      document,
      (d) => d,
      () => void this.grow(),
    );
  }

  /** The tree on the screen is the one that the document asks for. */
  get current(): boolean {
    return this.abort === null && same(this.document.getState(), this.shown);
  }

  /** Stops growing; the document goes back to the tree on the screen. */
  cancel(): void {
    this.abort?.abort();
    this.goBack();
  }

  /** Grows what the document asks for, unless that stands or grows already. */
  async grow(): Promise<void> {
    const { species, ownSpecies, edits, seed } = this.document.getState();
    const wish = { species, ownSpecies, edits, seed };
    if (same(wish, this.wish)) return;
    this.wish = wish;
    this.abort?.abort();
    const abort = new AbortController();
    this.abort = abort;
    try {
      const base = await this.find(wish);
      const found = editSpecies(base, edits);
      if (abort.signal.aborted) return;
      this.session.setState({ growing: { name: found.name, progress: 0 }, spoken: `Growing ${found.name}` });
      const grown = await growTree(found, seed, {
        signal: abort.signal,
        onProgress: (progress) => {
          if (abort.signal.aborted) return;
          this.session.setState({ growing: { name: found.name, progress: overall(progress) } });
        },
      });
      if (abort.signal.aborted) return;
      this.stand(wish, base, found, grown);
    } catch (error) {
      if (abort.signal.aborted) return;
      this.abort = null;
      this.session.setState({ growing: null });
      if (error instanceof FileError) this.actions.notify('error', error.message, error.lines);
      else
        this.actions.notify('error', 'This tree could not be grown', [
          error instanceof Error ? error.message : String(error),
        ]);
      this.goBack();
    }
  }

  private async find(wish: Wish): Promise<Species> {
    if (wish.ownSpecies !== null) return readSpecies(wish.ownSpecies, 'The species in this link cannot be grown');
    const entry = this.session.getState().species.find((s) => s.id === wish.species);
    if (!entry) throw new FileError(`There is no species ${wish.species}`);
    return loadSpecies(entry);
  }

  private stand(wish: Wish, base: Species, species: Species, grown: GrownTree): void {
    const { stats, packed, milliseconds } = grown;
    this.abort = null;
    this.shown = wish;
    this.session.setState({
      growing: null,
      tree: {
        species,
        base,
        seed: wish.seed,
        figures: {
          stems: stats.levels.reduce((sum, level) => sum + level.stems + level.clones, 0),
          levels: stats.levels.length,
          pieces: packed.pieceCount,
          leaves: packed.leafCount,
          height: stats.height,
          grow: milliseconds.grow + milliseconds.fit + milliseconds.pack,
        },
      },
      spoken: `${species.name}, ${packed.leafCount} leaves`,
    });
    this.onTree(grown, species);
  }

  /** To the tree on the screen, or where there is none yet to a species that ships. */
  private goBack(): void {
    this.abort = null;
    this.session.setState({ growing: null });
    if (this.shown) {
      this.wish = this.shown;
      this.document.setState(this.shown);
    } else if (this.wish?.ownSpecies) {
      this.document.setState({ ownSpecies: null });
    }
  }
}
