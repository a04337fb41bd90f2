/** What the element says: on its controls, to screen readers, and where something is wrong. */
export const elementWords = {
  play: 'Let the wind blow',
  pause: 'Hold the wind still',
  show: 'Show the tree',
  progress: 'The tree is growing',
  keys: 'Arrow keys turn the view, plus and minus go nearer and farther, Home shows the whole tree, space holds the wind still.',
  status: {
    loading: 'Growing the tree.',
    /** `lack`: a sentence about what the graphics card cannot do, or nothing. */
    ready: (triangles: number, lack: string): string =>
      `Ready, ${triangles.toLocaleString('en')} triangles. ${lack}`.trim(),
    paused: 'Paused.',
    playing: 'The wind blows.',
    lost: 'The graphics card was taken away. The picture stands until it is back.',
    back: 'The graphics card is back.',
  },
  /** Before the page gave a text of its own. */
  alt: (species: string | null, wind: string | null): string =>
    species === null ? 'A tree' : wind === null ? species : `${species}, ${wind.toLowerCase()}`,
  noWebGl: 'This browser has no WebGL2, which the tree is drawn with.',
  failed: {
    fetch: 'The tree could not be loaded.',
    species: 'There is no such tree, or its file has a mistake.',
    grow: 'This tree could not be grown.',
    capability: 'This browser cannot draw the tree: it has no WebGL2.',
  },
  nothing: 'There is no tree yet.',
} as const;
