/** What the viewer's script says; the rest stands in viewer.html. */
export const words = {
  failed: (why: string): string => `The tree of this link could not be shown: ${why}`,
} as const;
