import { editSpecies } from '../core/species/edits.ts';
import type { Species } from '../core/species/species.ts';
import { type GrownTree, type GrowProgress, type GrowSettings, growTree } from '../view/picture/grow-tree.ts';
import type { Actions } from './actions.ts';
import { type DocumentStore, watch } from './document-store.ts';
import { Drafts } from './draft.ts';
import { FileError } from './file-error.ts';
import type { SessionStore, TreeFigures } from './session.ts';
import { loadSpecies, readSpecies } from './species-source.ts';
import { changedPaths, sameGrowth, sameSource, sameWish, type Wish, wishOf } from './wish.ts';
import { growingWords } from './words/growing.ts';

/** Growing takes about half of the time, fitting and packing the rest. */
const stages = { grow: [0, 0.5], fit: [0.5, 0.35], pack: [0.85, 0.15] } as const;

function overall({ stage, done }: GrowProgress): number {
  const [start, share] = stages[stage];
  return start + share * done;
}

/** Milliseconds after which a reader is told that something grows: what is quicker would only flicker. */
const TOLD = 150;

/** Whole trees that are kept, the one on the screen among them: looking at the species and back again grows nothing. */
const KEPT = 2;

/** A tree that has grown. */
interface Stand {
  readonly wish: Wish;
  readonly base: Species;
  /** The base with the edits in it. */
  readonly species: Species;
  readonly grown: GrownTree;
  /** Something was left out. */
  readonly rough: boolean;
}

/** The tree on the screen. */
interface Shown extends Stand {
  /** The picture was told that others follow at once. */
  readonly fleeting: boolean;
}

/** A tree that grows. */
interface Run {
  readonly wish: Wish;
  readonly rough: boolean;
  readonly abort: AbortController;
}

/** Puts a tree on the screen; `draft`: others follow at once. */
export type OnTree = (tree: GrownTree, species: Species, draft: boolean) => void;

const isWhole = (settings: GrowSettings): boolean => Object.keys(settings).length === 0;

const figuresOf = ({ stats, packed, milliseconds }: GrownTree): TreeFigures => ({
  stems: stats.levels.reduce((sum, level) => sum + level.stems + level.clones, 0),
  levels: stats.levels.length,
  pieces: packed.pieceCount,
  leaves: packed.leafCount,
  height: stats.height,
  grow: milliseconds.grow + milliseconds.fit + milliseconds.pack,
});

/**
 * Grows what the document asks for, in the worker; the latest wish wins, and the tree on the screen stays until the next one
 * stands. A wish that cannot be granted gives a message, and the document goes back to the last whole tree.
 *
 * While a control is dragged no tree is given up for the next wish: trees follow the hand as fast as they grow, and those that would be
 * too slow for it leave out leaves or twigs. The whole tree comes when the hand rests.
 */
export class Grower {
  /** What is on the screen. */
  private shown: Shown | null = null;
  /** Whole trees, the latest first. */
  private whole: readonly Stand[] = [];
  /** The latest whole tree of the document itself: what it goes back to. */
  private good: Wish | null = null;
  private run: Run | null = null;
  private readonly drafts = new Drafts();
  private told: ReturnType<typeof setTimeout> | undefined;

  private readonly document: DocumentStore;
  private readonly session: SessionStore;
  private readonly actions: Actions;
  private readonly onTree: OnTree;

  constructor(document: DocumentStore, session: SessionStore, actions: Actions, onTree: OnTree) {
    this.document = document;
    this.session = session;
    this.actions = actions;
    this.onTree = onTree;
    const grow = () => void this.grow();
    // Who changes a number, or undoes it, wants to see what that does.
    watch(
      document,
      (d) => d.edits,
      () => actions.setPeek(false),
    );
    watch(document, (d) => d, grow);
    watch(
      session,
      (s) => s.editing,
      () => {
        this.drafts.begin();
        grow();
      },
    );
    watch(session, (s) => s.peek, grow);
  }

  /** The tree on the screen is the one that is asked for, whole. */
  get current(): boolean {
    const { run, shown } = this;
    return run === null && shown !== null && !shown.rough && !shown.fleeting && sameWish(shown.wish, this.wish);
  }

  /** Stops growing; the document goes back to the tree on the screen. */
  cancel(): void {
    if (!this.run) return;
    this.stop();
    this.goBack(false);
  }

  private get editing(): boolean {
    return this.session.getState().editing;
  }

  /** What is asked for: the document, or while somebody compares the species alone. */
  private get wish(): Wish {
    const wish = wishOf(this.document.getState());
    return this.session.getState().peek ? { ...wish, edits: {}, treeName: null } : wish;
  }

  /** Grows what is asked for, unless that stands or grows already. */
  async grow(): Promise<void> {
    const { wish, run, editing, shown } = this;
    if (run) {
      // In other colours it is put when it stands.
      if (sameGrowth(run.wish, wish) && (!run.rough || editing)) return;
      // What grows is shown, and then the next one begins.
      if (editing && (run.rough || !this.isSlow(wish))) return;
      this.stop();
    }
    const there = shown && (!shown.rough || editing) ? [shown, ...this.whole] : this.whole;
    const stand = there.find((one) => sameGrowth(one.wish, wish));
    if (stand) this.dress(stand, wish);
    else await this.start(wish);
  }

  /** Whether a whole tree would be too slow for a hand. */
  private isSlow(wish: Wish): boolean {
    return !isWhole(this.settings(wish, null));
  }

  private settings(wish: Wish, species: Species | null): GrowSettings {
    const [last] = this.whole;
    if (!this.editing || !last || !sameSource(last.wish, wish)) return {};
    return this.drafts.settings(species ?? last.species, last.grown, changedPaths(last.wish.edits, wish.edits));
  }

  /** A tree that stands, in the colours and under the name that are asked for. */
  private dress(stand: Stand, wish: Wish): void {
    const { shown } = this;
    const drawn = shown?.grown === stand.grown && changedPaths(shown.wish.edits, wish.edits).length === 0;
    const settles = shown?.fleeting === true && !this.editing;
    if (drawn && !settles && shown.wish.treeName === wish.treeName) return;
    this.stand({ ...stand, wish, species: dressed(stand.base, wish) }, !drawn || settles);
  }

  private async start(wish: Wish): Promise<void> {
    const abort = new AbortController();
    const { signal } = abort;
    // The run is there before its species is: who asks in between must not start a second one.
    let run: Run = { wish, abort, rough: false };
    this.run = run;
    this.tell(this.nameOf(wish));
    try {
      const base = await this.find(wish);
      if (signal.aborted) return;
      const species = dressed(base, wish);
      const settings = this.settings(wish, species);
      const rough = !isWhole(settings);
      run = { wish, abort, rough };
      this.run = run;
      const grown = await growTree(species, wish.seed, {
        ...settings,
        signal,
        onProgress: (progress) => {
          const { growing } = this.session.getState();
          if (signal.aborted || !growing) return;
          this.session.setState({ growing: { name: growing.name, progress: overall(progress) } });
        },
      });
      if (signal.aborted) return;
      this.drafts.learn(grown);
      this.untell();
      this.run = null;
      // Colours or the name may have changed meanwhile.
      const now = sameGrowth(this.wish, wish) ? this.wish : wish;
      this.stand({ wish: now, base, species: dressed(base, now), grown, rough }, true);
      await this.grow();
    } catch (error) {
      if (signal.aborted) return;
      this.run = null;
      this.untell();
      if (error instanceof FileError) this.actions.notify('error', error.message, error.lines);
      else this.actions.notify('error', growingWords.failed, [error instanceof Error ? error.message : String(error)]);
      this.goBack(true);
    }
  }

  /** Tells the reader that something loads and grows, unless it stands at once. */
  private tell(name: string): void {
    const begin = (): void => {
      this.session.setState({ growing: { name, progress: 0 } });
      if (!this.editing) this.actions.say(growingWords.growing(name));
    };
    if (this.shown) this.told = setTimeout(begin, TOLD);
    else begin();
  }

  /** What a wish is called before its species is there. */
  private nameOf(wish: Wish): string {
    const { shown } = this;
    if (wish.treeName !== null) return wish.treeName;
    if (shown && sameSource(shown.wish, wish)) return shown.base.name;
    const entry = this.session.getState().species.find((s) => s.id === wish.species);
    return wish.ownSpecies === null && entry ? entry.name : growingWords.own;
  }

  private untell(): void {
    clearTimeout(this.told);
    if (this.session.getState().growing) this.session.setState({ growing: null });
  }

  private stop(): void {
    this.run?.abort.abort();
    this.run = null;
    this.untell();
  }

  private async find(wish: Wish): Promise<Species> {
    const { shown } = this;
    if (shown && shown.wish.ownSpecies === wish.ownSpecies && shown.wish.species === wish.species) return shown.base;
    if (wish.ownSpecies !== null) return readSpecies(wish.ownSpecies, growingWords.linkFailed);
    const entry = this.session.getState().species.find((s) => s.id === wish.species);
    if (!entry) throw new FileError(growingWords.noSpecies(wish.species));
    return loadSpecies(entry);
  }

  /** Takes a tree as the one on the screen; `draw`: the picture does not have it. */
  private stand(stand: Stand, draw: boolean): void {
    const { wish, base, species, grown, rough } = stand;
    const former = this.shown;
    const fleeting = this.editing;
    this.shown = { ...stand, fleeting };
    if (!rough) {
      this.whole = [stand, ...this.whole.filter((one) => one.grown !== grown)].slice(0, KEPT);
      if (!this.session.getState().peek) this.good = wish;
    }
    const { tree } = this.session.getState();
    const another = !former || former.wish.seed !== wish.seed || former.base !== base;
    this.session.setState({
      tree: {
        species,
        base,
        source: { species: wish.species, ownSpecies: wish.ownSpecies },
        seed: wish.seed,
        // A draft's figures would say that the tree has no leaves.
        figures: rough && tree ? tree.figures : figuresOf(grown),
        stems: grown.stems,
        draft: rough,
      },
      ...(another ? { spoken: growingWords.stands(species.name, grown.packed.leafCount) } : {}),
    });
    if (draw) this.onTree(grown, species, fleeting);
  }

  /** To the last whole tree, or where there is none yet to what can be grown for sure. `failed`: the present wish cannot. */
  private goBack(failed: boolean): void {
    this.actions.setPeek(false);
    if (this.good) {
      this.document.history.withdraw(this.good, failed);
      // A draft of what was given up may be on the screen.
      void this.grow();
      return;
    }
    const { edits, ownSpecies, species } = this.document.getState();
    const shipped = this.session.getState().species;
    // Kept by an older page, maybe, that had more species.
    const gone = ownSpecies === null && !shipped.some(({ id }) => id === species);
    if (gone && shipped[0]) this.document.setState({ species: shipped[0].id });
    else if (Object.keys(edits).length > 0) this.document.setState({ edits: {} });
    else if (ownSpecies !== null) this.document.setState({ ownSpecies: null });
  }
}

/** The species that a wish is of, under its name. */
function dressed(base: Species, { edits, treeName }: Wish): Species {
  const species = editSpecies(base, edits);
  return treeName === null ? species : { ...species, name: treeName };
}
