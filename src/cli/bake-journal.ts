import { appendFileSync, existsSync, mkdirSync, readFileSync, rmSync, statSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { manifestTrees } from './bake-manifest.ts';
import type { Shard } from './bake-plan.ts';
import type { BakedTree } from './bake-tree.ts';
import { Failure } from './failure.ts';
import { cannotWrite } from './write-file.ts';

/**
 * What a shard has finished, a line a tree, kept while it bakes: a tree stands there when all its files are whole.
 *
 * The first line is the hash of the plan. A kill may leave a last line that is cut off, and files without a line: both are made again.
 */
export class BakeJournal {
  private readonly file: string;
  readonly done = new Map<number, BakedTree>();

  constructor(folder: string, shard: Shard, plan: string) {
    this.file = join(folder, `.bake-${shard.part}-of-${shard.of}.jsonl`);
    try {
      mkdirSync(folder, { recursive: true });
    } catch (error) {
      throw cannotWrite(folder, error);
    }
    const finished = existsSync(this.file) ? this.lines(plan) : manifestTrees(folder, shard, plan);
    for (const tree of finished) if (this.isThere(folder, tree)) this.done.set(tree.index, tree);
    if (!existsSync(this.file)) {
      const text = [{ plan }, ...this.done.values()].map((line) => `${JSON.stringify(line)}\n`).join('');
      writeFileSync(this.file, text);
    }
  }

  /** The trees that a journal lists; what a kill cut off is no tree. */
  private lines(plan: string): BakedTree[] {
    const [head = '', ...lines] = readFileSync(this.file, 'utf8').split('\n');
    if ((parsed(head) as { plan?: unknown } | undefined)?.plan !== plan)
      throw new Failure(
        `${this.file}: another bake was begun here, of other species, seeds or options. Go on with that one, choose another --out, or remove this file.`,
      );
    // A line that was cut off must not swallow the next one.
    if (lines.at(-1) !== '') appendFileSync(this.file, '\n');
    return lines.map(parsed).filter((tree): tree is BakedTree => typeof tree === 'object' && tree !== null);
  }

  /** Whether the files of a tree are still what they were, by their size. */
  private isThere(folder: string, { files = [] }: BakedTree): boolean {
    return files.every(({ file, bytes }) => statSync(join(folder, file), { throwIfNoEntry: false })?.size === bytes);
  }

  add(tree: BakedTree): void {
    appendFileSync(this.file, `${JSON.stringify(tree)}\n`);
    this.done.set(tree.index, tree);
  }

  /** The manifest has it all. */
  close(): void {
    rmSync(this.file, { force: true });
  }
}

function parsed(line: string): unknown {
  try {
    return JSON.parse(line);
  } catch {
    return undefined;
  }
}
