import type { Table } from '../../bench/report.ts';
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
const asked = new URLSearchParams(location.search);
const number = (name: string, otherwise: number): number => Number(asked.get(name) ?? otherwise);
const counts = (asked.get('counts') ?? '1,10,100,1000,10000').split(',').map(Number);
const only = asked.get('only')?.split(',');

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
    const sizes = { rounds: number('rounds', 5), milliseconds: number('ms', 300), trees: number('trees', 100) };
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
  await run(SECTIONS.filter(({ id }) => !only || only.includes(id)));
  const report = { title: words.title, renderer, tables: tables() };
  const failed = tables().length === 0;
  document.querySelector('#report')!.textContent = JSON.stringify(failed ? { error: page.innerText } : report);
}
document.body.dataset.ready = 'true';
