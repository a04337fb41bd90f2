/** What the page says by itself: as a message, as a hint, or only spoken. */
export const messageWords = {
  hints: {
    first: 'Drag the wind.',
    still: 'Your system asks for less motion, so time stands still. Press play, or Space, to let it run.',
  },
  slow: 'The wind is slower here than it could be',
  still: 'This is a still picture',
  stillSays:
    'The tree is drawn once for each change. Another browser, or graphics acceleration switched on, shows it in the wind.',
  picture: (name: string, seed: number): string =>
    `${name}, seed ${seed}. Arrow keys walk around it, plus and minus come closer and go away.`,
  link: 'Parts of this link could not be used; the rest applies',
  linkFault: (key: string, found: string, allowed: string): string => `${key}: found “${found}”; allowed: ${allowed}.`,
  more: (count: number): string => `${count} more like these.`,
  noSpecies: 'The list of species could not be read',
  noWind: 'A wind could not be read',
  lists: { species: 'The list of species', winds: 'The list of winds' },
  cannotGrow: (name: string): string => `${name} cannot be grown`,
  cannotBlow: (name: string): string => `${name} cannot blow`,
  notLoaded: (what: string): string => `${what} could not be loaded`,
  connection: 'Is the connection up? Reload the page to try again.',
  server: (path: string, status: string): string => `${path}: the server says ${status}`,
  why: (path: string, reason: string): string => `${path}: ${reason}`,
  notOpened: (name: string): string => `${name} was not opened`,
  tooLong: (bytes: number, most: number): string => `It has ${bytes} bytes; at most ${most} are read.`,
  graphicsLost: 'The graphics card was taken away; the picture comes back with it',
  windAt: (percent: number): string => `Wind at ${percent} per cent`,
} as const;

/** What is spoken, and told, of winds. */
export const windMessages = {
  recordMissing: (file: string): string => `Its measured wind lies in a file beside it, ${file}, which is not here.`,
  blows: (name: string): string => `${name} blows`,
  pasted: 'What was pasted is no wind; yours still blows',
  recordBlows: (name: string): string => `${name} blows in place of the waves`,
  copied: 'The wind is copied as JSON; paste it here, in another tab or into a file',
  notCopied: 'The browser does not let this page copy; download the wind as a file',
  on: 'Wind on',
  off: 'Wind off',
  loops: (seconds: number, open: readonly string[]): string =>
    `The wind comes around every ${seconds} seconds${open.length > 0 ? `; ${open.join(' and ')} do not come around` : ''}`,
  two: 'Two winds, A and B; the mixer changes B',
  swapped: (a: string, b: string): string => `A is now ${a}, B ${b}`,
  gustStarts: (seconds: number): string => `A gust starts at ${seconds.toFixed(1)} seconds`,
  aiming: 'Click the ground to throw a gust; Escape ends it',
  gustRemoved: 'Gust removed',
  gustsRemoved: 'All gusts removed',
  waveAdded: (number: number): string => `Wave ${number} added`,
  waveCopied: (number: number, of: number): string => `Wave ${number} added, a copy of wave ${of}`,
  waveRemoved: (number: number): string => `Wave ${number} removed`,
  waveMoved: (number: number, count: number): string => `Now wave ${number} of ${count}`,
  playing: 'Playing',
  paused: 'Paused',
  slow: 'Slow motion',
  real: 'Real time',
} as const;
