import { PLACES } from '../core/species/edits.ts';
import type { Species } from '../core/species/species.ts';
import type { GrownTree, GrowSettings } from '../view/picture/grow-tree.ts';

/** A tree that grows in so many milliseconds needs no draft. */
const QUICK = 50;
/** What a draft may take: ten trees a second follow a hand. */
const FOLLOWS = 100;
/** What a piece costs in growing, fitting and packing, in leaves. */
const PIECE = 6;
/** Leaves of a thinned crown, as a part of all. */
const THINNED = 0.3;
/** Latest growths that say how fast this machine is: the fastest of them was least disturbed. */
const REMEMBERED = 5;

const WHOLE: GrowSettings = {};

/** Work of growing a tree, in leaves. */
const workOf = (pieces: number, leaves: number): number => PIECE * pieces + leaves;

/** Pieces of the stems below each level: entry n counts levels 0 to n - 1. */
function piecesBelow({ stems }: GrownTree): number[] {
  const counts = new Array<number>(stems.countOfLevel.length + 1).fill(0);
  for (const stem of stems.stemOfPiece) counts[stems.level[stem]! + 1]!++;
  for (let i = 1; i < counts.length; i++) counts[i]! += counts[i - 1]!;
  return counts;
}

/** What a draft must have, since it is what is being changed. */
function needs(changed: readonly string[], { tree, levels }: Species) {
  let least = 1;
  let leaves = false;
  for (const path of changed) {
    const level = PLACES.get(path)?.level;
    // The last level that a file lists is that of all deeper ones, too.
    if (level !== undefined) least = Math.max(least, level >= levels.length - 1 ? tree.levels : level + 1);
    else if (path.startsWith('leaves.') || path.startsWith('foliage.')) leaves = true;
    else if (path === 'tree.levels') least = tree.levels;
  }
  return { least, leaves };
}

/** Chooses what of a tree is grown while a control is dragged, by what trees took lately. */
export class Drafts {
  /** Milliseconds for the work of a leaf, of the latest growths. */
  private rates: number[] = [];
  /** The coarsest that was shown since the hand came down: a tree that jumps between two forms is worse than either. */
  private coarsest = 0;

  /** A tree has grown. */
  learn({ packed, milliseconds }: GrownTree): void {
    const work = workOf(packed.pieceCount, packed.leafCount);
    const rate = (milliseconds.grow + milliseconds.fit + milliseconds.pack) / Math.max(work, 1000);
    this.rates = [...this.rates, rate].slice(-REMEMBERED);
  }

  /** The hand came down, or rests. */
  begin(): void {
    this.coarsest = 0;
  }

  /**
   * What to grow of `species` now; `last` is the tree that was grown whole last, and `changed` the paths that differ from it. Without
   * anything in it: the whole tree.
   */
  settings(species: Species, last: GrownTree, changed: readonly string[]): GrowSettings {
    // A worker's first tree takes twice as long as its second: until then its code is interpreted.
    const rate = Math.min(...this.rates) * (this.rates.length > 1 ? 1 : 0.5);
    const below = piecesBelow(last);
    const { leafCount } = last.packed;
    const all = species.tree.levels;
    const { least, leaves } = needs(changed, species);
    const work = (levels: number, kept: number): number =>
      workOf(below[Math.min(levels, below.length - 1)]!, kept * leafCount);
    // From the whole tree to its limbs.
    const steps = [{ settings: WHOLE, work: work(all, 1) }];
    if (leafCount > 0) steps.push({ settings: { quality: THINNED }, work: work(all, THINNED) });
    if (leafCount > 0 && !leaves) steps.push({ settings: { leaves: false }, work: work(all, 0) });
    for (let levels = all - 1; levels >= Math.max(least, 2) && !leaves; levels--)
      steps.push({ settings: { levels, leaves: false }, work: work(levels, 0) });
    const fits = steps.findIndex((step, i) => step.work * rate <= (i === 0 ? QUICK : FOLLOWS));
    this.coarsest = Math.min(Math.max(this.coarsest, fits < 0 ? steps.length - 1 : fits), steps.length - 1);
    return steps[this.coarsest]!.settings;
  }
}
