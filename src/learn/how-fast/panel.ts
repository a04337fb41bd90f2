import { capabilitiesOf } from '../../gpu/capabilities.ts';
import { rendererName } from '../../gpu/renderer-name.ts';
import type { Measured } from './measured.ts';
import { cellsOf, csvOf } from './rows-text.ts';
import { runAll } from './run-all.ts';
import { newSeries } from './series.ts';
import { words } from './words.ts';

const button = (text: string, act: () => void): HTMLButtonElement => {
  const made = document.createElement('button');
  made.type = 'button';
  made.textContent = text;
  made.addEventListener('click', act);
  return made;
};

/** The part of the page that measures: buttons, what goes on, and the table. Nothing runs before it is asked for. */
export class Panel {
  readonly #measured: Measured;
  readonly #start = button(words.start, () => void this.#run());
  readonly #stop = button(words.stop, () => this.#stopping?.abort());
  readonly #csv = button(words.csv, () => this.#save());
  readonly #state = document.createElement('p');
  readonly #machine = document.createElement('p');
  readonly #body: HTMLTableSectionElement;
  readonly #scroll = document.createElement('div');
  #stopping: AbortController | null = null;
  #renderer = '';

  constructor(place: HTMLElement, measured: Measured) {
    this.#measured = measured;
    const buttons = document.createElement('div');
    buttons.className = 'buttons';
    buttons.append(this.#start, this.#stop, this.#csv);
    this.#state.setAttribute('role', 'status');
    this.#state.textContent = words.idle;
    this.#machine.className = 'soft';
    this.#machine.hidden = true;
    this.#scroll.className = 'scroll';
    this.#scroll.hidden = true;
    this.#scroll.tabIndex = 0;
    this.#scroll.setAttribute('role', 'region');
    this.#scroll.setAttribute('aria-label', words.table);
    const table = document.createElement('table');
    table.className = 'measured';
    const head = table.createTHead().insertRow();
    for (const name of words.columns) {
      const cell = document.createElement('th');
      cell.scope = 'col';
      cell.textContent = name;
      head.append(cell);
    }
    this.#body = table.createTBody();
    this.#scroll.append(table);
    place.replaceChildren(buttons, this.#state, this.#machine, this.#scroll);
    measured.watch(() => this.#show());
    this.#enable();
  }

  #enable(): void {
    const running = this.#stopping !== null;
    this.#start.disabled = running;
    this.#stop.disabled = !running;
    this.#csv.disabled = running || this.#measured.rows.length === 0;
    this.#start.textContent = this.#measured.rows.length > 0 ? words.again : words.start;
  }

  #show(): void {
    const { rows } = this.#measured;
    this.#scroll.hidden = rows.length === 0;
    this.#body.replaceChildren(
      ...rows.map((row) => {
        const line = document.createElement('tr');
        const [name = '', ...cells] = cellsOf(row, rows);
        const head = document.createElement('th');
        head.scope = 'row';
        head.textContent = name;
        line.append(head);
        for (const text of cells) line.insertCell().textContent = text;
        const told = line.cells[2];
        if (row.milliseconds === null && told) told.colSpan = words.columns.length - 2;
        return line;
      }),
    );
  }

  async #run(): Promise<void> {
    const stopping = new AbortController();
    this.#stopping = stopping;
    this.#measured.clear();
    this.#enable();
    const began = performance.now();
    let made: ReturnType<typeof newSeries> | null = null;
    try {
      made = this.#open();
      await runAll(
        made.series,
        {
          doing: (kind, size) => {
            this.#state.textContent = words.doing(kind, size);
          },
          found: (row) => this.#measured.add(row),
        },
        stopping.signal,
      );
      this.#state.textContent = words.done((performance.now() - began) / 1000);
    } catch (error) {
      const why = error instanceof Error ? error.message : String(error);
      this.#state.textContent = stopping.signal.aborted ? words.stopped : words.failed(why);
    } finally {
      made?.dispose();
      this.#stopping = null;
      this.#enable();
    }
  }

  /** A context to measure in. Throws, in words for the reader, where there is none or the wind cannot run. */
  #open(): ReturnType<typeof newSeries> {
    let made: ReturnType<typeof newSeries>;
    try {
      made = newSeries();
    } catch {
      throw new Error(words.noContext);
    }
    this.#renderer = rendererName(made.renderer);
    const { floatTargets } = capabilitiesOf(made.renderer);
    this.#machine.textContent = `${words.renderer(this.#renderer)}${floatTargets ? '' : `. ${words.noTargets}`}`;
    this.#machine.hidden = false;
    if (floatTargets) return made;
    return { ...made, series: made.series.filter(({ kind }) => kind !== 'steps') };
  }

  #save(): void {
    const url = URL.createObjectURL(new Blob([csvOf(this.#measured.rows, this.#renderer)], { type: 'text/csv' }));
    const link = document.createElement('a');
    link.href = url;
    link.download = 'windgrove-how-fast.csv';
    link.click();
    setTimeout(() => URL.revokeObjectURL(url), 1000);
  }
}
