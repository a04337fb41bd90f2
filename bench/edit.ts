// How long after a slider's event does the tree stand? In the editor itself, in a frame of this page.
import type { Editor } from '../src/editor/editor.ts';
import type { BenchReport } from './report.ts';

const query = new URLSearchParams(location.search);
const TIMES = Number(query.get('times') ?? 15);
/** Edits before the measured ones: until then the worker's code is interpreted. */
const WARM = 6;
/** Steps of a drag and the milliseconds between them. */
const STEPS = 90;
const STEP = 16;

const frame = document.createElement('iframe');
frame.width = '1280';
frame.height = '600';
document.body.append(frame);

const median = (values: readonly number[]): number =>
  values.toSorted((a, b) => a - b)[values.length >> 1] ?? Number.NaN;
const pause = (milliseconds = 0): Promise<void> => new Promise((done) => setTimeout(done, milliseconds));

async function until(holds: () => boolean): Promise<void> {
  while (!holds()) await pause(2);
}

/** The editor with a link, once its tree is drawn. */
async function open(link: string): Promise<{ editor: Editor; page: Document }> {
  await new Promise((done) => {
    frame.addEventListener('load', done, { once: true });
    frame.src = 'about:blank';
  });
  frame.src = `/index.html#${link}`;
  await until(() => frame.contentDocument?.documentElement?.dataset.ready === 'true');
  const page = frame.contentDocument!;
  await until(() => sliderOf(page) !== null);
  return { page, editor: (page.querySelector('wg-app') as unknown as { editor: Editor }).editor };
}

/** What one edit took, milliseconds. */
interface Edit {
  /** From the event to the tree being the picture's. */
  readonly all: number;
  /** Of which growing, fitting and packing in the worker. */
  readonly grow: number;
  /** Of which the picture's taking it. */
  readonly set: number;
  /** The first drawing of it, which comes after. */
  readonly draw: number;
}

/** Notes when trees come to the picture and when they are drawn. */
function watchPicture({ picture }: Editor) {
  const seen = { trees: 0, at: 0, set: 0, drawn: false, draw: 0, scales: [] as { at: number; value: number }[] };
  const { setTree, draw } = picture;
  picture.setTree = (...given) => {
    const start = performance.now();
    setTree.apply(picture, given);
    seen.at = performance.now();
    seen.set = seen.at - start;
    seen.trees++;
    seen.drawn = false;
    seen.scales.push({ at: seen.at, value: given[1].tree.scale });
  };
  picture.draw = (...given) => {
    const start = performance.now();
    const figures = draw.apply(picture, given);
    // The first drawing of a tree is the one that sends it.
    if (!seen.drawn) seen.draw = performance.now() - start;
    seen.drawn = true;
    return figures;
  };
  return seen;
}

const sliderOf = (page: Document) =>
  page.querySelector<HTMLInputElement>('[data-path="tree.scale"] input[type="range"]');

function slide(slider: HTMLInputElement, value: number): void {
  slider.value = String(value);
  slider.dispatchEvent(new Event('input', { bubbles: true }));
}

const values = (base: number, i: number): number => base * (0.8 + 0.01 * ((i * 7) % 40));

/** One edit after the other, each whole and drawn before the next. */
async function single({ editor, page }: Awaited<ReturnType<typeof open>>, times: number): Promise<Edit[]> {
  const seen = watchPicture(editor);
  const edits: Edit[] = [];
  const base = editor.session.getState().tree!.base.tree.scale;
  for (let i = 0; i < WARM + times; i++) {
    const { trees } = seen;
    const start = performance.now();
    slide(sliderOf(page)!, values(base, i));
    await until(() => seen.trees > trees);
    const all = seen.at - start;
    const { set } = seen;
    await until(() => seen.drawn && page.documentElement.dataset.ready === 'true');
    if (i >= WARM) edits.push({ all, set, draw: seen.draw, grow: editor.session.getState().tree!.figures.grow });
    await pause(30);
  }
  return edits;
}

/** A drag: how often a tree came, how late behind the hand, and when the whole one stood after the hand rested. */
async function drag({ editor, page }: Awaited<ReturnType<typeof open>>) {
  const seen = watchPicture(editor);
  const slider = sliderOf(page)!;
  const base = editor.session.getState().tree!.base.tree.scale;
  const told = new Map<number, number>();
  slider.dispatchEvent(new PointerEvent('pointerdown', { bubbles: true }));
  for (let i = 0; i < STEPS; i++) {
    slide(slider, base * (0.8 + 0.004 * i));
    told.set(editor.document.getState().edits['tree.scale'] as number, performance.now());
    await pause(STEP);
  }
  const shown = seen.scales.slice(1);
  const rest = performance.now();
  const draft = editor.session.getState().tree!.draft === true;
  frame.contentWindow!.dispatchEvent(new PointerEvent('pointerup'));
  await until(() => page.documentElement.dataset.ready === 'true' && !editor.session.getState().editing);
  return {
    draft: draft ? 'twigs or leaves left out' : 'whole',
    between: median(shown.slice(1).map(({ at }, i) => at - shown[i]!.at)),
    late: median(shown.map(({ at, value }) => at - (told.get(value) ?? at))),
    whole: seen.at - rest,
  };
}

const SUBJECTS = [
  { name: 'Quaking Aspen', id: 'quaking-aspen', aim: 50, times: TIMES },
  { name: 'Black Tupelo', id: 'black-tupelo', aim: '', times: TIMES },
  { name: 'Weeping Willow', id: 'weeping-willow', aim: 1000, times: Math.min(TIMES, 7) },
] as const;

// A view of the trunk and limbs alone, and time that stands: what is measured is not the drawing.
const view = 'seed=3&t=0&paused=1&levels=2&leaves=0&blow=0';
const rows: (string | number)[][] = [];
const drags: (string | number)[][] = [];
for (const { name, id, aim, times } of SUBJECTS) {
  const edits = await single(await open(`s=${id}&${view}`), times);
  const of = (key: keyof Edit): number => median(edits.map((edit) => edit[key]));
  rows.push([name, of('all'), aim, of('grow'), of('set'), of('all') - of('grow') - of('set'), of('draw')]);
  console.log(`${name}: ${of('all').toFixed(1)} ms`);
  const { draft, between, late, whole } = await drag(await open(`s=${id}&${view}`));
  drags.push([name, draft, between, late, whole]);
  console.log(`${name} dragged: a tree each ${between.toFixed(1)} ms, ${draft}`);
}
frame.remove();

const report: BenchReport = {
  title: 'From a slider to the tree',
  tables: [
    {
      caption: `Milliseconds from the event of a slider of the editor to the whole tree being the picture's, medians of ${TIMES} (willow ${Math.min(TIMES, 7)}); the drawing of it comes after`,
      columns: [
        'tree',
        'event to tree',
        'aim',
        'growing, fitting, packing',
        'textures and meshes',
        'all between',
        'drawing',
      ],
      rows,
    },
    {
      caption: `A drag: ${STEPS} events, one each ${STEP} ms`,
      columns: [
        'tree',
        'grown while it lasts',
        'ms from tree to tree',
        'ms behind the hand',
        'ms from its rest to the whole tree',
      ],
      rows: drags,
    },
  ],
  notes: [
    'The size of the tree is what is dragged. The page draws trunk and limbs without wind, since software drawing on the same cores would be measured else; textures are sent when it draws.',
  ],
};
document.querySelector('#report')!.textContent = JSON.stringify(report);
document.querySelector('#state')!.textContent = 'Done.';
