/** A page of the site. */
export interface SitePage {
  readonly id: string;
  /** As a heading says it. */
  readonly name: string;
  /** The same where all of them stand in a row; `name` where it is short enough. */
  readonly short?: string;
  /** What one finds there, in a line. */
  readonly about: string;
  /** Its address, seen from the top of the site. */
  readonly href: string;
}

/** The pages that one can go to from anywhere, in the order in which they are offered. */
export const SITE_PAGES: readonly SitePage[] = [
  { id: 'editor', name: 'Editor', about: 'Grow a tree and blow wind through it', href: 'index.html' },
  { id: 'forest', name: 'Forest', about: 'A hillside of trees to fly through', href: 'forest.html' },
  { id: 'learn', name: 'Lessons', about: 'The papers as living pages', href: 'learn/index.html' },
  {
    id: 'reference',
    name: 'Reference',
    about: 'Every parameter, attribute and function',
    href: 'reference/index.html',
  },
  {
    id: 'range',
    name: 'Degradation at range',
    short: 'At range',
    about: 'What is left of a tree from afar (Weber & Penn, Table 2)',
    href: 'range.html',
  },
  { id: 'bench', name: 'Benchmark', about: 'How fast all this is on your machine', href: 'bench.html' },
  {
    id: 'crosscheck',
    name: 'Cross-check',
    about: 'Every shader function beside its twin, on your machine',
    href: 'crosscheck.html',
  },
];
