/** What a page that is embedded may lack. */
const embedParts = {
  compare: 'the second wind',
  arrows: 'the arrows',
  probe: 'the probe',
} as const;

/** Files, snapshots and what the page keeps by itself. */
export const fileWords = {
  menu: {
    label: 'File',
    labelOf: (name: string, changed: boolean): string =>
      `File: ${name}${changed ? ', changed since it was saved' : ''}`,
    saved: 'Kept in this browser',
    saving: 'Keeping…',
    failed: 'This browser keeps nothing: save a file.',
    noFile: 'In no file yet',
    changedSince: (name: string): string => `Changed since ${name} was saved`,
    inFile: (name: string): string => `Saved in ${name}`,
  },
  untitled: 'tree',
  title: (name: string | null, changed: boolean): string =>
    name === null ? 'Windgrove' : `${changed ? '• ' : ''}${name} · Windgrove`,
  saved: (name: string): string => `Saved in ${name}`,
  downloaded: (name: string): string => `${name} is among your downloads`,
  notSaved: 'The file could not be saved',
  notOpened: (name: string): string => `${name} was not opened`,
  unreadable: (name: string): string => `${name} could not be read`,
  pasted: 'What was pasted',
  opened: (name: string): string => `${name} is open`,
  imported: (name: string): string => `${name} is open; this could not be carried over`,
  /** How the browser calls the files that it offers. */
  kinds: { project: 'Windgrove project', any: 'Trees and winds' },
  newTree: 'A new tree',
  newTreeKept: (name: string): string => `A new tree; the last one is kept as the snapshot “${name}”`,
  beforeNew: 'Before the new tree',
  beforeFile: (name: string): string => `Before ${name}`,
  beforeLink: 'Before the link',
  embedCopied: 'The snippet is copied; paste it into the HTML of your page',
  embedShown: 'The browser does not let this page copy; here is the snippet',
  /** What the viewer leaves out of what is on the screen. */
  embedLacks: (parts: readonly (keyof typeof embedParts)[]): string =>
    `It leaves out ${new Intl.ListFormat('en-GB').format(parts.map((part) => embedParts[part]))}: it shows one tree in one wind.`,
  linkCopied: 'The link to this picture is copied',
  linkShown: 'The browser does not let this page copy; the link is in the address bar',
  notInLink: (name: string): string => `${name} is not in it: a measured wind of your own is too long for a link.`,
  embedTitle: (name: string): string => `${name}, a tree in the wind`,
  back: (when: number): string => {
    const day = new Date(when).toLocaleDateString(undefined, { day: 'numeric', month: 'long' });
    const time = new Date(when).toLocaleTimeString(undefined, { hour: '2-digit', minute: '2-digit' });
    return `Your tree from ${day}, ${time} is back`;
  },
  startFresh: 'Start fresh',
  broken: 'What this browser had kept of your last tree could not be read',
  brokenSteps: 'Your tree is back, but not the steps to undo: they could not be read',
  brokenLines: ['It was kept by another version, or damaged. This is told once.'],
  dropHint: 'Let go to open it: a project, a species, a wind, a measured wind, a tree of Arbaro or ez-tree',
} as const;

/** Named states. */
export const snapshotWords = {
  taken: (name: string): string => `Snapshot “${name}” is kept`,
  most: (most: number): string => `There are ${most} snapshots; delete one first`,
  deleted: (name: string): string => `Snapshot “${name}” is deleted`,
  putBack: 'Put back',
  broken: (name: string): string => `Parts of the snapshot “${name}” could not be used; the rest applies`,
  /** `Quaking Aspen, no. 7` */
  nameOf: (tree: string, seed: number): string => `${tree}, no. ${seed}`,
} as const;
