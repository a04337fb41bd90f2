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
  /** What search engines and cards are told of it. */
  readonly description: string;
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
    description:
      "Weber and Penn's model of trees as living figures: levels, curve, splits, children, shapes, radius, leaves, pruning and attraction, with what is printed wrong and how to tell.",
    papers: 'Weber & Penn 1995',
  },
  {
    slug: 'branch-deformer',
    number: 2,
    title: 'The branch deformer',
    year: 2006,
    about: 'A flat grid, rolled up, shaped and bent along a curve, in a vertex shader.',
    description:
      "How a sheet of graph paper and four points become a branch on the GPU: Skjermo's branch deformer of 2006, taken apart.",
    papers: 'Skjermo 2006',
  },
  {
    slug: 'sum-of-sines',
    number: 3,
    title: 'Sum of sines',
    year: 2007,
    about: 'Four travelling waves that make a field of wind, and what sharpens them into gusts.',
    description:
      "Wind as a sum of travelling waves: Skjermo's equations 11 to 14 as living figures, with what is printed wrong and how to tell.",
    papers: 'Skjermo 2007',
  },
  {
    slug: 'ping-pong',
    number: 4,
    title: 'Ping-pong',
    year: 2007,
    about: 'Two textures, one shader, and how a bend travels from the trunk to the twigs.',
    description:
      'How a tree moves on the graphics card: branches as texels, two sets of textures, the lag between levels, attachment and bending.',
    papers: 'Skjermo 2007',
  },
  {
    slug: 'wind-models',
    number: 5,
    title: 'Three ways to answer the wind',
    year: 2007,
    about: 'The same gust on the same tree: bent at once, swaying, or on springs.',
    description:
      'The same gust on the same tree, bent at once, swaying by two sines, or swinging as damped springs: three wind models side by side.',
    papers: 'Weber & Penn 1995, Skjermo 2007',
  },
  {
    slug: 'range',
    number: 6,
    title: 'Degradation at range',
    year: 1995,
    about: 'What can be left out of a tree that is far away, and how a hillside becomes cheap.',
    description:
      'Degradation at range: how Weber and Penn drew far trees with a hundredth of the work, their Table 2 beside what the formulas give, and what a forest costs.',
    papers: 'Weber & Penn 1995',
  },
  {
    slug: 'how-fast',
    number: 7,
    title: 'How fast',
    year: 2007,
    about: 'The graphs of the papers, drawn again with what your own machine does.',
    description:
      "The graphs of Skjermo's papers, drawn again with what your own machine does, and how to time a graphics card without fooling yourself.",
    papers: 'Skjermo 2006 and 2007',
  },
];

/** What the page of all lessons says of itself. */
export const INDEX_PAGE = {
  title: 'Lessons · Windgrove',
  description:
    'Seven lessons on trees and wind in computer graphics: the papers of Weber, Penn and Skjermo as living pages, with figures to drag, the code that implements each equation, and what is printed wrong.',
} as const;

/** The lessons before and after one. Throws where there is no such lesson. */
export function neighbours(slug: string): { before: Lesson | undefined; lesson: Lesson; after: Lesson | undefined } {
  const at = LESSONS.findIndex((each) => each.slug === slug);
  const lesson = LESSONS[at];
  if (!lesson) throw new Error(`src/learn/lessons.ts has no lesson '${slug}'.`);
  return { before: LESSONS[at - 1], lesson, after: LESSONS[at + 1] };
}
