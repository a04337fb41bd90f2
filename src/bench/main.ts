import type { Table } from '../../bench/report.ts';
import { oneLine } from '../core/file/one-line.ts';
import { LinkReader } from '../core/link/reader.ts';
import { rendererName } from '../gpu/renderer-name.ts';
import { element, tableElement } from './elements.ts';
import { CLASSES } from './part-classes.ts';
import { COUNT } from './part-count.ts';
import { FAR } from './part-far.ts';
import { HUNDRED } from './part-hundred.ts';
import { ONE } from './part-one.ts';
import { PAPERS } from './part-papers.ts';
import { probe } from './probe.ts';
import { csvOf, markdownOf } from './report-text.ts';
import { type Section, SIZE, StopAsked } from './section.ts';
import { words } from './words.ts';

const SECTIONS: readonly Section[] = [ONE, HUNDRED, FAR, CLASSES, COUNT, PAPERS];

// `?run` starts at once, `&only=one,far` some parts, `&rounds=`, `&ms=`, `&trees=`, `&counts=1,10` smaller ones.
const asked = new LinkReader(new Map(new URLSearchParams(location.search)));
const number = (name: string, otherwise: number, min: number, max: number): number =>
  asked.number(name, { label: name, unit: '', min, max, decimals: 0 }, otherwise);
const sizes = {
  rounds: number('rounds', 5, 1, 100),
  milliseconds: number('ms', 300, 1, 10_000),
  trees: number('trees', 100, 1, 1000),
};
const counts = asked.read('counts', [1, 10, 100, 1000, 10_000], words.countsAllowed, (text) => {
  const numbers = text.split(',').map((each) => (/^\d{1,5}$/.test(each) ? Number(each) : 0));
  return numbers.every((each) => each >= 1 && each <= 20_000) ? numbers : undefined;
});
const ids = SECTIONS.map(({ id }) => id);
const only = asked.read('only', ids, ids.join(', '), (text) => {
  const named = text.split(',');
  return named.every((each) => ids.includes(each)) ? named : undefined;
});

const page = document.querySelector<HTMLElement>('#page')!;
const renderer = probe(rendererName);
const found = new Map<Section, Table>();
let stopping: AbortController | null = null;

const button = (label: string, press: () => void): HTMLButtonElement => {
  const it = element('button', label);
  it.type = 'button';
  it.addEventListener('click', press);
  return it;
};

const runAll = button(words.runAll, () => void run(SECTIONS));
const stop = button(words.stop, () => stopping?.abort());
const csv = button(words.csv, () => save('windgrove-benchmark.csv', 'text/csv', csvOf(tables(), renderer ?? '')));
const markdown = button(words.markdown, () =>
  save('windgrove-benchmark.md', 'text/markdown', markdownOf(tables(), words.renderer(renderer ?? ''))),
);

interface Shown {
  readonly run: HTMLButtonElement;
  readonly state: HTMLElement;
  readonly stage: HTMLElement;
  readonly results: HTMLElement;
}

const shown = new Map(SECTIONS.map((section) => [section, show(section)] as const));

function tables(): Table[] {
  return SECTIONS.flatMap((section) => found.get(section) ?? []);
}

function show(section: Section): Shown {
  const parts: Shown = {
    run: button(words.run, () => void run([section])),
    state: element('p', words.idle, 'state'),
    stage: element('div', '', 'stage'),
    results: element('div', '', 'results'),
  };
  parts.state.setAttribute('role', 'status');
  return parts;
}

function build(): void {
  const head = element('header');
  const tools = element('div', '', 'tools');
  tools.append(runAll, stop, csv, markdown);
  head.append(element('h1', words.title), element('p', words.lead), element('p', words.quiet, 'soft'));
  if (asked.faults.length > 0) {
    const lines = asked.faults.map(({ key, found, allowed }) => words.fault(oneLine(key), oneLine(found, 60), allowed));
    const notice = element('p', [words.linkFaults, ...lines].join(' '), 'fault');
    notice.setAttribute('role', 'alert');
    head.append(notice);
  }
  head.append(element('p', renderer ? words.renderer(renderer) : words.noContext, 'renderer'), tools);
  page.append(head);
  for (const [section, { run: runOne, state, stage, results }] of shown) {
    const part = element('section');
    part.id = section.id;
    const line = element('div', '', 'tools');
    line.append(runOne, state);
    part.append(element('h2', section.title), element('p', section.lead), line, stage, results);
    if (section === PAPERS) {
      const link = element('a', words.papers.table2);
      link.href = './range.html';
      part.append(link);
    }
    page.append(part);
  }
  enable();
}

function enable(): void {
  const busy = stopping !== null;
  for (const each of [runAll, ...[...shown.values()].map(({ run: one }) => one)]) each.disabled = busy || !renderer;
  stop.disabled = !busy;
  csv.disabled = markdown.disabled = found.size === 0;
}

/** Lets the page draw itself and hear a press of Stop. */
const breathe = (): Promise<void> => new Promise((next) => setTimeout(next, 0));

async function runOne(section: Section, signal: AbortSignal): Promise<void> {
  const { state, stage, results } = shown.get(section)!;
  const canvas = element('canvas');
  [canvas.width, canvas.height] = SIZE;
  stage.replaceChildren(canvas);
  const began = performance.now();
  const step = async (text: string): Promise<void> => {
    if (state.textContent !== text) state.textContent = text;
    await breathe();
    if (signal.aborted) throw new StopAsked();
  };
  try {
    const bench = { canvas, signal, step, counts };
    const { table, pictures } = await section.run({ ...bench, ...sizes });
    found.set(section, table);
    const figures = pictures.map(({ name, url }) => {
      const figure = element('figure');
      const image = element('img');
      image.src = url;
      image.alt = words.picture(name);
      figure.append(image, element('figcaption', name));
      return figure;
    });
    const strip = element('div', '', 'pictures');
    strip.append(...figures);
    results.replaceChildren(tableElement(table), strip);
    state.textContent = words.done(((performance.now() - began) / 1000).toFixed(1));
  } catch (error) {
    const stopped = signal.aborted || error instanceof StopAsked;
    state.textContent = stopped ? words.stopped : words.failed(error instanceof Error ? error.message : String(error));
    if (!stopped) console.error(error);
  } finally {
    stage.replaceChildren();
  }
}

async function run(sections: readonly Section[]): Promise<void> {
  if (stopping) return;
  const control = new AbortController();
  stopping = control;
  enable();
  for (const section of sections) shown.get(section)!.state.textContent = words.waiting;
  for (const section of sections) {
    if (control.signal.aborted) shown.get(section)!.state.textContent = words.stopped;
    else await runOne(section, control.signal);
  }
  stopping = null;
  enable();
}

function save(name: string, type: string, text: string): void {
  const url = URL.createObjectURL(new Blob([text], { type }));
  const link = element('a');
  link.href = url;
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(url), 1000);
}

build();
if (asked.has('run') && renderer) {
  const chosen = SECTIONS.filter(({ id }) => only.includes(id));
  await run(chosen);
  const title = chosen.length === 1 ? chosen[0]!.title : words.title;
  const without = chosen.filter((section) => !found.has(section));
  // A part without its table is a run that failed.
  const error = without.map((section) => `${section.title}: ${shown.get(section)!.state.textContent}`).join('\n');
  document.querySelector('#report')!.textContent = JSON.stringify(
    error ? { error } : { title, renderer, tables: tables() },
  );
}
document.body.dataset.ready = 'true';
