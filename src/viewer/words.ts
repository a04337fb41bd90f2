/** What the viewer's script says; the rest stands in viewer.html. */
export const words = {
  leftOut: (what: readonly string[]): string =>
    `The viewer shows one tree in one wind; of this link it leaves out: ${what.join(', ')}. "Windgrove" in the corner opens all of it.`,
  parts: {
    compare: 'the second wind',
    arrows: 'the arrows of the wind',
    probe: 'the probe',
  },
  failed: (why: string): string => `The tree of this link could not be shown: ${why}`,
} as const;
