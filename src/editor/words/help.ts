/** The help beside the table of keys, which has its words in words/commands.ts. */
export const helpWords = {
  how: 'Drag the picture to walk around the tree, scroll or pinch to come closer, drag with the right button or two fingers to move aside. Every number can be typed; double-click a slider to put it back. The address always holds what you see.',
  tour: 'Show me around',
  find: 'Find a command',
  single: 'Single keys act anywhere on the page',
  source: 'Trees after Weber & Penn (1995), moved after Skjermo (2006, 2007).',
} as const;
