/** A lesson: a page of `learn/`. */
export interface Lesson {
  /** Its file is `learn/SLUG.html`, its figures are in `src/learn/SLUG/`. */
  readonly slug: string;
  readonly number: number;
  readonly title: string;
  /** When what it teaches was printed. */
  readonly year: number;
  /** What one learns, in a line. */
  readonly about: string;
  /** What it is read beside. */
  readonly papers: string;
}

/** The lessons in the order in which they are read. */
export const LESSONS: readonly Lesson[] = [
  {
    slug: 'weber-penn',
    number: 1,
    title: 'Growing a tree',
    year: 1995,
    about: 'Eighty numbers, four levels of stems, and a tree that botanists recognise.',
    papers: 'Weber & Penn 1995',
  },
  {
    slug: 'branch-deformer',
    number: 2,
    title: 'The branch deformer',
    year: 2006,
    about: 'A flat grid, rolled up, shaped and bent along a curve, in a vertex shader.',
    papers: 'Skjermo 2006',
  },
  {
    slug: 'sum-of-sines',
    number: 3,
    title: 'Sum of sines',
    year: 2007,
    about: 'Four travelling waves that make a field of wind, and what sharpens them into gusts.',
    papers: 'Skjermo 2007',
  },
  {
    slug: 'ping-pong',
    number: 4,
    title: 'Ping-pong',
    year: 2007,
    about: 'Two textures, one shader, and how a bend travels from the trunk to the twigs.',
    papers: 'Skjermo 2007',
  },
  {
    slug: 'wind-models',
    number: 5,
    title: 'Three ways to answer the wind',
    year: 2007,
    about: 'The same gust on the same tree: bent at once, swaying, or on springs.',
    papers: 'Weber & Penn 1995, Skjermo 2007',
  },
  {
    slug: 'range',
    number: 6,
    title: 'Degradation at range',
    year: 1995,
    about: 'What can be left out of a tree that is far away, and how a hillside becomes cheap.',
    papers: 'Weber & Penn 1995',
  },
  {
    slug: 'how-fast',
    number: 7,
    title: 'How fast',
    year: 2007,
    about: 'The graphs of the papers, drawn again with what your own machine does.',
    papers: 'Skjermo 2006 and 2007',
  },
];

/** The lessons before and after one. Throws where there is no such lesson. */
export function neighbours(slug: string): { before: Lesson | undefined; lesson: Lesson; after: Lesson | undefined } {
  const at = LESSONS.findIndex((each) => each.slug === slug);
  const lesson = LESSONS[at];
  if (!lesson) throw new Error(`src/learn/lessons.ts has no lesson '${slug}'.`);
  return { before: LESSONS[at - 1], lesson, after: LESSONS[at + 1] };
}
