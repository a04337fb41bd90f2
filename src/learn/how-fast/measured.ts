/** What is measured: frames of so many vertices, or steps of the wind over so many branches. */
export type Kind = 'frames' | 'steps';

/** One line of the table. */
export interface Row {
  readonly kind: Kind;
  readonly size: number;
  /** Milliseconds of one, median; null where it was left out. */
  readonly milliseconds: number | null;
  /** Median over the least: how quiet the machine was. */
  readonly unrest: number | null;
}

/** What has been measured on this machine, for the figures and the table of the page. */
export class Measured {
  #rows: readonly Row[] = [];
  readonly #watchers = new Set<() => void>();

  get rows(): readonly Row[] {
    return this.#rows;
  }

  /** The measured rates of a kind, small sizes first. */
  rates(kind: Kind): { size: number; perSecond: number }[] {
    return this.#rows
      .flatMap((row) =>
        row.kind === kind && row.milliseconds !== null ? [{ size: row.size, perSecond: 1000 / row.milliseconds }] : [],
      )
      .sort((a, b) => a.size - b.size);
  }

  add(row: Row): void {
    this.#rows = [...this.#rows, row];
    this.#tell();
  }

  clear(): void {
    this.#rows = [];
    this.#tell();
  }

  watch(changed: () => void): void {
    this.#watchers.add(changed);
  }

  #tell(): void {
    for (const changed of this.#watchers) changed();
  }
}
