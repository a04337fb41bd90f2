/** How much a tree may take. It is checked while growing: a species can ask for a billion stems by one digit too many. */
export interface GrowthBudget {
  /** Stems, clones among them. */
  readonly stems: number;
  readonly leaves: number;
  /** Bytes of the tree's arrays. */
  readonly bytes: number;
}

export const DEFAULT_BUDGET: GrowthBudget = { stems: 400_000, leaves: 2_500_000, bytes: 384 * 1024 * 1024 };

/** Bytes that one entry of a tree takes in all its arrays together. */
export const BYTES = { stem: 50, node: 52, leaf: 32 } as const;

/** A number with thin spaces between thousands, as messages show it. */
const grouped = (n: number): string =>
  n < 1e15 ? String(Math.round(n)).replace(/\B(?=(\d{3})+$)/g, '\u2009') : n.toExponential(1);

/** The species asks for more than the budget allows; the message says how much, the limit, and what to lower. */
export class GrowthBudgetError extends Error {
  override readonly name = 'GrowthBudgetError';
  readonly what: keyof GrowthBudget;
  /** What has been grown when this was noticed. */
  readonly count: number;
  /** What the species asks for at least. */
  readonly asked: number;
  readonly limit: number;
  /** The parameter to lower, as a path in the species file. */
  readonly path: string;

  constructor(what: keyof GrowthBudget, count: number, asked: number, limit: number, path: string, value: number) {
    super(
      `This species asks for at least ${grouped(asked)} ${what}; the limit is ${grouped(limit)} ` +
        `(${grouped(count)} so far). Lower ${path}, which is ${value}.`,
    );
    this.what = what;
    this.count = count;
    this.asked = asked;
    this.limit = limit;
    this.path = path;
  }
}

/** The caller asked to stop. */
export class GrowthCancelled extends Error {
  override readonly name = 'GrowthCancelled';
  constructor() {
    super('Growing was cancelled.');
  }
}
