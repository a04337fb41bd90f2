import type { ParameterValue } from '../species/edits.ts';
import { EZ_TREE_UNIT, type EzTreeValues } from './ez-tree-values.ts';

/** What bark and leaves of an ez-tree become. */
export interface EzTreeLook {
  readonly name: string;
  /** Leaves that a card of ez-tree, on which several are painted, becomes. */
  readonly leavesEach: number;
  readonly values: Readonly<Record<string, ParameterValue>>;
}

/** A bark by the name of ez-tree's texture; colours are ours. */
const BARKS: Readonly<Record<string, { kind: string; colour: string; dark: string; grain: number }>> = {
  birch: { kind: 'smooth', colour: '#e4e0d5', dark: '#3a3833', grain: 0.35 },
  oak: { kind: 'furrowed', colour: '#8a7a66', dark: '#3a3128', grain: 0.16 },
  pine: { kind: 'plated', colour: '#9a6f52', dark: '#4a3226', grain: 0.25 },
  willow: { kind: 'furrowed', colour: '#7d7263', dark: '#322c25', grain: 0.16 },
};

interface Leaf {
  readonly name: string;
  readonly shape: number;
  /** Leaves on a card, their length as a part of it, and their width as a part of their length. */
  readonly each: number;
  readonly scale: number;
  readonly scaleX: number;
  readonly colour: string;
  readonly under: string;
  readonly glow: string;
}

const green = { colour: '#5d8a35', under: '#93ab6a', glow: '#b5cf4a' } as const;

/** Leaves by the name of ez-tree's texture. */
const LEAVES: Readonly<Record<string, Leaf>> = {
  ash: { name: 'Ash', shape: 0, each: 6, scale: 0.34, scaleX: 0.4, ...green },
  aspen: {
    name: 'Aspen',
    shape: 0,
    each: 4,
    scale: 0.36,
    scaleX: 0.95,
    colour: '#7fa83f',
    under: '#b9c69a',
    glow: '#c8dc55',
  },
  oak: { name: 'Oak', shape: 2, each: 5, scale: 0.42, scaleX: 0.6, ...green },
  pine: {
    name: 'Pine',
    shape: 0,
    each: 8,
    scale: 0.5,
    scaleX: 0.06,
    colour: '#3f5f38',
    under: '#5d7a52',
    glow: '#7e9a55',
  },
};

/** A colour times a tint, channel by channel, as ez-tree's textures are tinted; both sRGB. */
function tinted(colour: string, tint: number): string {
  const parts = [1, 3, 5].map((at, i) => {
    const light = (tint >> (16 - 8 * i)) & 255;
    return Math.round((Number.parseInt(colour.slice(at, at + 2), 16) * light) / 255);
  });
  return `#${parts.map((part) => part.toString(16).padStart(2, '0')).join('')}`;
}

/** The look of a tree; what it changes beyond that goes on the list of notes. */
export function ezTreeLook({ bark, leaves, type }: EzTreeValues, notes: string[]): EzTreeLook {
  const wood = BARKS[Object.hasOwn(BARKS, bark.type) ? bark.type : 'oak']!;
  const leaf = LEAVES[Object.hasOwn(LEAVES, leaves.type) ? leaves.type : 'oak']!;
  notes.push(
    `Bark and leaves are drawn as Windgrove draws them, in the tints of the file; each card with painted leaves became ${leaf.each} leaves.`,
  );
  return {
    name: `${leaf.name}${type === 'evergreen' && leaf.name !== 'Pine' ? ', evergreen' : ''} from ez-tree`,
    leavesEach: leaf.each * (leaves.billboard === 'double' ? 2 : 1),
    values: {
      'leaves.shape': leaf.shape,
      'leaves.scale': leaves.size * leaf.scale * EZ_TREE_UNIT,
      'leaves.scaleX': leaf.scaleX,
      'bark.kind': wood.kind,
      'bark.colour': tinted(wood.colour, bark.tint),
      'bark.dark': tinted(wood.dark, bark.tint),
      'bark.grain': wood.grain,
      'foliage.colour': tinted(leaf.colour, leaves.tint),
      'foliage.under': tinted(leaf.under, leaves.tint),
      'foliage.glow': tinted(leaf.glow, leaves.tint),
    },
  };
}
