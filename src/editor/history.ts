import type { TemporalState } from 'zundo';
import type { StoreApi } from 'zustand/vanilla';
import type { LinkDocument } from '../core/link/link.ts';
import type { KeptFile } from './kept-file.ts';
import { differences, type Made, madeOf, sameMade } from './made.ts';

/** Steps that can be undone. */
export const MOST_STEPS = 200;

/** Milliseconds within which the next press of a key belongs to the step of the last one. */
export const KEY_PAUSE = 600;

/** The part of a document that says which tree is grown. */
type Tree = Pick<LinkDocument, 'species' | 'ownSpecies' | 'edits' | 'seed'>;

/** What can be undone and redone: states before the present one, oldest first, and after it, the next one last. */
export interface Steps {
  readonly past: readonly Made[];
  readonly future: readonly Made[];
  readonly files: readonly FileStep[];
}

/** What the history needs of the store that it is of. */
export interface Recorded {
  getState(): LinkDocument;
  setState(change: Partial<LinkDocument>): void;
  /** Does what is no step in the history, whatever listeners change in answer. */
  quietly(act: () => void): void;
  readonly temporal: StoreApi<TemporalState<Made>>;
}

/** Another file was opened with a step: what goes along with it though the document does not hold it. */
export interface FileStep {
  /** Index of the state that the step led to. */
  readonly at: number;
  readonly before: KeptFile | null;
  readonly after: KeptFile | null;
}

const sameTree = (a: Tree, b: Tree): boolean =>
  a.species === b.species &&
  a.ownSpecies === b.ownSpecies &&
  a.seed === b.seed &&
  differences(a.edits, b.edits).length === 0;

const within = (part: readonly string[], whole: readonly string[]): boolean => part.every((key) => whole.includes(key));

/**
 * The steps of a document, which zundo keeps, and the rules by which changes become steps.
 *
 * All changes between `hold` and `release` are one step, and so are those of one action (`together`). Presses of a key merge while they
 * follow each other within KEY_PAUSE and change the same values. Nothing else merges. A step that ends where it began is none.
 */
export class History {
  private readonly of: Recorded;
  /** Holds that are open, the reader's own and those of actions. */
  private held = false;
  private depth = 0;
  /** The open hold has a step already. */
  private begun = false;
  /** What could be redone before the latest step, in case that it is taken off. */
  private before: readonly Made[] = [];
  /** When the key was pressed that changes come from; null: from no key. */
  private keyAt: number | null = null;
  /** The latest step, where a key made it. */
  private byKey: { readonly keys: readonly string[]; readonly at: number } | null = null;
  /** Where the reader was before the latest undo or redo; null: something was changed since. */
  private cameFrom: number | null = null;
  private files: readonly FileStep[] = [];
  /** Hears which file is open where a step is undone or done again that opened another one. */
  onFile: (file: KeptFile | null) => void = () => {};

  constructor(of: Recorded) {
    this.of = of;
  }

  private get steps(): { past: Made[]; future: Made[] } {
    const { pastStates, futureStates } = this.of.temporal.getState();
    return { past: pastStates as Made[], future: futureStates as Made[] };
  }

  private keep(past: readonly Made[], future: readonly Made[]): void {
    this.of.temporal.setState({ pastStates: past.slice(-MOST_STEPS), futureStates: [...future] });
  }

  /** Steps as they are now, for whoever keeps them. */
  read(): Steps {
    return { ...this.steps, files: this.files };
  }

  get canUndo(): boolean {
    return this.steps.past.length > 0;
  }

  get canRedo(): boolean {
    return this.steps.future.length > 0;
  }

  /** Place of the present state in `states`. */
  get index(): number {
    return this.steps.past.length;
  }

  /** All states from the oldest to the latest that can be redone; the present one among them. */
  get states(): readonly Made[] {
    const { past, future } = this.steps;
    return [...past, madeOf(this.of.getState()), ...future.toReversed()];
  }

  /** Calls back when what can be undone or redone is another. Returns how to stop. */
  subscribe(listener: () => void): () => void {
    return this.of.temporal.subscribe(listener);
  }

  /** Takes a change that was made; `push` makes it a step. */
  onChange(past: Made, now: Made, push: () => void): void {
    this.cameFrom = null;
    const open = this.held || this.depth > 0;
    if (open && this.begun) return;
    const { keyAt } = this;
    const keys = keyAt === null ? [] : differences(past, now);
    const last = this.byKey;
    this.begun = open;
    this.byKey = keyAt === null ? null : { keys, at: keyAt };
    if (keyAt !== null && !this.held && last && keyAt - last.at <= KEY_PAUSE) {
      if (within(keys, last.keys) || within(last.keys, keys)) {
        this.dropNothing();
        return;
      }
    }
    const { past: all, future } = this.steps;
    this.before = future;
    // One more than there may be pushes the oldest out.
    const out = all.length >= MOST_STEPS ? 1 : 0;
    this.files = this.files
      .filter(({ at }) => at <= all.length && at > out)
      .map((step) => ({ ...step, at: step.at - out }));
    push();
  }

  /** The step that was made last opened a file. */
  openedFile(before: KeptFile | null, after: KeptFile | null): void {
    this.files = [...this.files, { at: this.index, before, after }];
  }

  /** All changes until `release` are one step. */
  hold(): void {
    if (!this.held && this.depth === 0) this.begun = false;
    this.held = true;
  }

  release(): void {
    if (!this.held) return;
    this.held = false;
    this.close();
  }

  /** All changes that `act` makes at once are one step. */
  together<T>(act: () => T): T {
    if (!this.held && this.depth === 0) this.begun = false;
    this.depth++;
    try {
      return act();
    } finally {
      this.depth--;
      this.close();
    }
  }

  private close(): void {
    if (this.held || this.depth > 0 || !this.begun) return;
    this.begun = false;
    this.dropNothing();
  }

  /** Takes the latest step off where it ends as it began. */
  private dropNothing(): void {
    const { past } = this.steps;
    const start = past.at(-1);
    if (!start || !sameMade(start, madeOf(this.of.getState()))) return;
    this.byKey = null;
    this.files = this.files.filter(({ at }) => at < past.length);
    this.keep(past.slice(0, -1), this.before);
  }

  /**
   * Changes come from a key that was pressed at `at` milliseconds, until another one is pressed; null: from elsewhere. `held`: it is the
   * same press still, which the keyboard repeats.
   */
  key(at: number | null, held = false): void {
    this.keyAt = at;
    if (held && at !== null && this.byKey) this.byKey = { ...this.byKey, at };
  }

  undo(): boolean {
    return this.goTo(this.index - 1);
  }

  redo(): boolean {
    return this.goTo(this.index + 1);
  }

  /** To the state at a place of `states`; false where there is none, or it is the present one. */
  goTo(index: number): boolean {
    const was = this.index;
    if (index === was || index < 0 || index >= this.states.length) return false;
    // A drag that is back where it began is no step to go over.
    if (this.begun) this.dropNothing();
    this.endHold();
    const from = this.index;
    if (index === from) return true;
    const { undo, redo } = this.of.temporal.getState();
    this.of.quietly(() => (index < from ? undo(from - index) : redo(index - from)));
    const crossed = this.files.filter(({ at }) => at > Math.min(from, index) && at <= Math.max(from, index));
    const [first, last] = [crossed[0], crossed.at(-1)];
    if (first && last) this.onFile(index < from ? first.before : last.after);
    this.cameFrom = from;
    return true;
  }

  private endHold(): void {
    this.held = false;
    this.begun = false;
    this.byKey = null;
  }

  /**
   * Goes back to `shown`, since the tree of the present state does not stand: `failed`: it cannot be grown, and no step may lead to it;
   * else the reader stopped it.
   */
  withdraw(shown: Tree, failed: boolean): void {
    const wish = this.of.getState();
    if (sameTree(wish, shown)) return;
    const { cameFrom, states } = this;
    const there = cameFrom === null ? undefined : states[cameFrom];
    if (!failed && there && sameTree(there, shown)) {
      this.goTo(cameFrom!);
      return;
    }
    const mend = (state: Made): Made => (sameTree(state, wish) ? { ...state, ...shown } : state);
    const { past, future } = this.steps;
    this.endHold();
    this.of.quietly(() => this.of.setState(shown));
    const present = madeOf(this.of.getState());
    // What became alike is one state.
    const lone = (list: readonly Made[]): Made[] =>
      list.map(mend).filter((state, i, all) => !sameMade(state, all[i + 1] ?? present));
    const earlier = lone(past);
    this.files = this.files.filter(({ at }) => at <= earlier.length);
    this.keep(earlier, lone(earlier.length < past.length && future.length === 0 ? this.before : future));
    this.before = [];
  }

  /** Begins anew with these steps. */
  replace({ past, future, files }: Steps): void {
    this.endHold();
    this.before = [];
    this.cameFrom = null;
    this.files = files;
    this.keep(past, future);
  }
}
