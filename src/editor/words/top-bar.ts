/** The bar at the top of the window. */
export const topWords = {
  app: 'Windgrove',
  seed: (seed: number): string => `no. ${seed}`,
  tools: 'Tree and view',
  undo: (what: string): string => (what === '' ? 'Undo' : `Undo: ${what}`),
  redo: (what: string): string => (what === '' ? 'Redo' : `Redo: ${what}`),
  nothingToUndo: 'Nothing to undo',
  nothingToRedo: 'Nothing to redo',
  share: 'Share',
  shareTitle: 'A link to exactly this, or a snippet for a page of yours',
  shareHelp: 'The link holds the tree, its wind and what you see. Whoever opens it needs nothing else.',
  export: 'Export…',
  exportTitle: 'Take the tree to other programs, or make a picture or a film of it',
  variety: 'Other trees',
  varietyTitle: 'See more trees like this one and choose',
  scene: 'Season, stage and light',
  theme: 'Theme',
  more: 'More',
  play: 'Play',
  pause: 'Pause',
} as const;

/** How it is shown. */
export const viewWords = {
  legend: 'View',
  shaded: ['Shaded', 'As it looks'],
  wireframe: ['Wireframe', 'The triangles that are drawn'],
  control: ['Curves', 'Control polygons of the pieces, with their frames'],
  levels: ['Levels', 'Each level of stems in its colour'],
  themes: { auto: 'Colours of your system', light: 'Light colours', dark: 'Dark colours' },
  whole: 'Whole tree',
  wholeTitle: 'The whole tree in the window',
} as const;
