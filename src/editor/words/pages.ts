/** The other pages of Windgrove: what they are called, what one finds there, and their addresses beside this one. */
export const pageWords = {
  heading: 'Other pages',
  open: (name: string): string => `Open ${name}`,
  kind: 'Page',
  pages: [
    { id: 'forest', name: 'the forest', about: 'A hillside of trees to fly through', href: 'forest.html' },
    {
      id: 'range',
      name: 'degradation at range',
      about: 'What is left of a tree from afar (Weber & Penn, Table 2)',
      href: 'range.html',
    },
    { id: 'bench', name: 'the benchmark', about: 'How fast all this is on your machine', href: 'bench.html' },
    {
      id: 'crosscheck',
      name: 'the cross-check',
      about: 'Every shader function beside its twin, on your machine',
      href: 'crosscheck.html',
    },
  ],
} as const;
