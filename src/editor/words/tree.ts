import type { Why } from '../ui/tree/no-effect.ts';
import type { GroupId, SectionId } from '../ui/tree/sections.ts';

const sections: Readonly<Record<SectionId, string>> = {
  tree: 'Whole tree',
  'level-0': 'Trunk',
  'level-1': 'Limbs',
  'level-2': 'Branches',
  'level-3': 'Twigs',
  leaves: 'Leaves',
  pruning: 'Pruning',
  bark: 'Bark',
  foliage: 'Look of the leaves',
  organ: 'Blossom and fruit',
  spring: 'In spring',
  autumn: 'In autumn',
  winter: 'In winter',
  wind: 'Answer to the wind',
  switches: 'Readings of the paper',
};

const groups: Readonly<Record<GroupId, string>> = {
  size: 'How large',
  crown: 'Crown',
  thickness: 'Thickness',
  bulges: 'Bulges',
  trunks: 'Several trunks',
  children: 'How many, how long',
  place: 'Place on the parent',
  curve: 'Curve',
  splits: 'Splits',
  ridges: 'Ridges',
  foot: 'Foot',
  amount: 'How many',
  blade: 'Blade',
  stance: 'How they stand',
  envelope: 'Envelope',
  all: '',
};

const why: Readonly<Record<Why, string>> = {
  noLevel: 'The tree has no stems of this level',
  noStems: 'No such stems grow',
  noLimbs: 'The trunk bears no limbs',
  noDeep: 'It acts on branches and twigs, and there are none',
  crownDrawn: 'The crown curve takes its place',
  noLobes: 'There are no lobes',
  noLobeDepth: 'The lobes have no depth',
  noBulges: 'There are no bulges',
  noBulgeDepth: 'The bulges have no depth',
  oneTrunk: 'The tree has one trunk',
  oneSegment: 'The stem is one straight segment',
  noSplits: 'Nothing splits',
  helix: 'The stem is a helix (curve varies by less than 0)',
  noHelix: 'The stem is no helix (curve varies by 0 or more)',
  fan: 'They stand in a fan',
  noLeaves: 'The tree has no leaves',
  noTwigs: 'There are no stems that could bear leaves',
  ownOutline: 'Another outline is drawn',
  noPruning: 'Nothing is pruned',
  asPrinted: 'All readings are as printed',
  noAttraction: 'Nothing is attracted',
  noFlutter: 'The leaves do not flutter',
  noMoss: 'There is no moss',
  noLichen: 'There is no lichen',
  ownMargin: 'A free outline is drawn',
  noSecond: 'There is no second colour',
  noneTurned: 'No leaves have turned',
  noCover: 'There are no leaves then',
  noOrgan: 'Twigs bear nothing',
  asSummer: 'It is so in summer, too',
  springsOnly: 'It acts where branches answer as springs',
};

/** Words of the panels that edit the tree. */
export const treeWords = {
  levels: ['Trunk', 'Limbs', 'Branches', 'Twigs'] as readonly string[],
  sections,
  groups,
  why,
  title: 'Shape it',
  name: 'Name of this tree',
  nameLabel: 'Call it',
  search: 'Find a parameter',
  searchHint: 'Find a parameter',
  found: (count: number) => (count === 0 ? 'None found' : count === 1 ? '1 parameter' : `${count} parameters`),
  noneFound: 'No parameter is called so. Try "angle", "length" or the paper\'s name.',
  noneChanged: 'Nothing is changed: this is the species as it ships.',
  changedOnly: 'Changed only',
  changes: (count: number) => (count === 0 ? 'As the species' : count === 1 ? '1 change' : `${count} changes`),
  changesIn: (count: number) => (count === 1 ? '1 changed' : `${count} changed`),
  locked: (count: number) => (count === 1 ? '1 locked' : `${count} locked`),
  unlockAll: 'Unlock all',
  resetAll: 'Reset all',
  resetAllHint: 'Back to the species; what is locked stays',
  resetSection: (section: string) => `Reset ${section.toLowerCase()}`,
  peek: 'Before',
  peekHint: 'Hold to see the species without your changes (\\)',
  peeking: 'Without your changes',
  stems: 'Stems, level by level',
  levelsLegend: 'Stems of level',
  layout: 'Levels',
  oneByOne: 'One at a time',
  sideBySide: 'Side by side',
  tableCaption: 'Stems, level by level',
  parameter: 'Parameter',
  numberOf: 'Number of them',
  empty: 'none',
  deeper: 'and all deeper levels',

  /** Names that say more here than those of the table do. */
  labels: {
    'levels.1.branches': 'Number of limbs',
    'levels.2.branches': 'Number of branches',
    'levels.3.branches': 'Number of twigs',
  } as Readonly<Record<string, string>>,

  /** Name of a control: the level in front of it, where it has one. */
  control: (label: string, level?: string) => (level ? `${level}: ${label}` : label),
  about: (label: string) => `About ${label}`,
  changed: (from: string) => `changed from ${from}`,
  lockedMark: 'locked',
  reset: (label: string, to: string) => `Reset ${label} to ${to}`,
  resetTo: (to: string) => `Reset to ${to}`,
  lock: 'Lock',
  unlock: 'Unlock',
  lockHint: 'A locked value stays when you change the species or try other trees',
  variation: (label: string) => `${label}, variation`,
  plusMinus: '±',
  inherited: (level: string) => `As the level "${level}"; type a value for the leaves alone`,
  asSummerSays: 'As in summer',
  unsaid: 'Not set',
  addColour: (name: string) => `Add a colour: ${name}`,
  takeOut: (name: string) => `Take the colour out: ${name}`,
  seen: (season: string) => `Seen in ${season} alone.`,
  showSeason: (season: string) => `Show ${season}`,
  hex: 'as #rrggbb',
  ofLevel: (label: string, level: string) => `${label}, ${level.toLowerCase()}`,

  /** The popover that explains a parameter. */
  help: {
    source: (symbol: string, section: string) =>
      section === 'appendix'
        ? `${symbol}, Weber & Penn 1995, appendix`
        : symbol
          ? `${symbol}, Weber & Penn 1995, ${section}`
          : `Weber & Penn 1995, ${section}`,
    ours: "Windgrove's own",
    allowed: (words: string) => `Allowed: ${words}.`,
    species: (value: string) => `The species has ${value}.`,
    variation: 'Variation',
    picture: (label: string, value: string) => `${label} ${value}`,
    close: 'Close',
  },

  shapes: 'Crown shape',
  crown: {
    title: 'Crown curve',
    draw: 'Draw the crown as a curve',
    back: 'Back to the crown shape',
    note: 'Drag the points: how long limbs are, from the base of the crown to its top.',
    point: (index: number, count: number) =>
      index === 0
        ? 'Length of limbs at the base of the crown'
        : index === count - 1
          ? 'Length of limbs at the top'
          : `Length of limbs at ${Math.round((100 * index) / (count - 1))} per cent of the crown`,
    value: (value: number) => `${Math.round(100 * value)} per cent`,
    picture: 'The crown curve over the outline of the tree',
  },
  margin: {
    draw: 'Draw the outline as a curve',
    back: 'Back to the leaf shape',
    note: 'Drag the points: half the width of the blade, from its base to its tip.',
    point: (index: number, count: number) =>
      index === 0
        ? 'Half width at the base'
        : index === count - 1
          ? 'Half width at the tip'
          : `Half width at ${Math.round((100 * index) / (count - 1))} per cent of the blade`,
    value: (value: number) => `${Math.round(100 * value)} per cent`,
    picture: 'The outline of the blade',
  },
  envelope: {
    note: 'Drag the points: what is outside of the line is shortened.',
    picture: 'The pruning envelope over the outline of the tree',
    width: 'Widest place of the envelope',
    widthValue: (width: number, peak: number) =>
      `radius ${Math.round(100 * width)} per cent of the size, ${Math.round(100 * peak)} per cent up the envelope`,
    low: 'Curve of the envelope below its widest place',
    high: 'Curve of the envelope above its widest place',
    power: (power: number) =>
      power === 1 ? 'straight' : power < 1 ? `full, power ${power.toFixed(2)}` : `hollow, power ${power.toFixed(2)}`,
    start: 'Prune the tree to an envelope',
  },
} as const;
