/** What stands around the content of every dialog. */
export const dialogWords = {
  headings: {
    gallery: 'Choose a tree',
    help: 'Keys and help',
    palette: 'Find a command',
    history: 'History',
    export: 'Export',
    variety: 'Other trees',
  },
  close: 'Close',
  tourFailed: 'The tour could not be loaded',
  opening: 'Opening…',
  failed: (reason: string) => `This could not be loaded (${reason}).`,
  again: 'Try again',
} as const;
