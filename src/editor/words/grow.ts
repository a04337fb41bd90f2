/** The head of the left panel: species, seed, and how much of the tree is drawn. */
export const growWords = {
  species: 'Species',
  ownSpecies: 'Your species',
  ownFile: 'your file',
  all: 'All species…',
  open: 'Open a file…',
  seed: 'Seed',
  seedHint: 'Same species, same seed: the same tree, everywhere',
  another: 'Another',
  anotherHint: 'Another tree (D)',
  draw: 'Draw as far as',
  level: (level: number) => `Level ${level}`,
  drawHint: (level: number) => (level === 0 ? 'Draw the trunk alone (1)' : `Draw level 0 to ${level} (${level + 1})`),
  leaves: 'Leaves',
  leavesWithAll: 'Leaves: with all levels',
  leavesHint: 'Draw the leaves (L)',
} as const;
