import { foundText } from '../file/allowed.ts';
import { type Fault, readJson } from '../file/fault.ts';
import type { ParameterValue } from '../species/edits.ts';
import { ezTreeLook } from './ez-tree-look.ts';
import { EZ_TREE_UNIT, type EzTreeValues, readEzTree } from './ez-tree-values.ts';
import { speciesOf } from './import-values.ts';
import { type Imported, LONGEST_IMPORT } from './imported.ts';

const SOURCE = 'Imported from an ez-tree file, whose rules are others; wind: Windgrove';
const DEGREES = 180 / Math.PI;

/**
 * The species that looks most like a tree of ez-tree (`TreeOptions` as JSON, what its application saves), as Weber & Penn's rules allow.
 *
 * ez-tree's branches go on from their tips as branches of the next level; here a stem is as long as such a chain, and has one child
 * more. What could not be carried over is named in `notes`. Never throws.
 */
export function parseEzTree(text: string): Imported {
  const { value, fault } = readJson(text, 'a tree of ez-tree', LONGEST_IMPORT);
  if (fault) return { faults: [fault] };
  if (typeof value !== 'object' || value === null || Array.isArray(value) || !('branch' in value))
    return { faults: [{ path: 'branch', found: foundText(undefined), allowed: 'the branches of a tree of ez-tree' }] };
  const faults: Fault[] = [];
  const tree = readEzTree(value, faults);
  if (faults.length > 0) return { faults: faults.slice(0, 20) };
  const notes = [`ez-tree has no unit of length: 1 of its units became ${EZ_TREE_UNIT} m.`, ...notesOf(tree)];
  const look = ezTreeLook(tree, notes);
  const { species, faults: wrong } = speciesOf(
    look.name,
    SOURCE,
    { ...valuesOf(tree, look.leavesEach), ...look.values },
    notes,
  );
  if (wrong) return { faults: wrong };
  const seed = Math.abs(Math.round(tree.seed)) % 2 ** 32;
  return { species, notes, seed };
}

/** Part of its length by which a branch that goes on leads further: it wanders, and children near the tip reach beyond it. */
const GOES_ON = 0.6;

/** Lengths in units that the chain of branches from each level on has: a deciduous branch goes on as one of the next level. */
function chains({ type, levels, length }: EzTreeValues): number[] {
  return Array.from({ length: levels + 1 }, (_, level) => {
    const own = length.slice(level, levels + 1);
    return type === 'evergreen' ? own[0]! : own.reduce((a, b) => a + GOES_ON * b);
  });
}

function valuesOf(tree: EzTreeValues, leavesEach: number): Record<string, ParameterValue> {
  const { levels, angle, start, taper, type, children } = tree;
  const evergreen = type === 'evergreen';
  const chain = chains(tree);
  const trunk = chain[0]!;
  // Where a chain has grown out of the level its name says, its children are those of the levels that go on.
  const values: Record<string, ParameterValue> = {
    'tree.levels': levels + 1,
    // The length of main branches over the crown: all that is left of the trunk, or from a whole chain at the base to half of it.
    'tree.shape': evergreen ? 9 : 4,
    'tree.baseSize': levels > 0 ? (start[1]! * tree.length[0]!) / trunk : 0,
    'tree.scale': trunk * EZ_TREE_UNIT,
    'tree.scaleV': 0,
    'tree.ratio': tree.radius[0]! / trunk,
    'tree.ratioPower': ratioPower(tree, chain),
    'tree.flare': 0.3,
    'tree.attractionUp': 0,
    'levels.0.length': 1,
    'levels.0.branches': 1,
    'levels.0.taper': levels === 0 ? taper[0]! : 1,
    'switches.branchesAboveBase': true,
  };
  // Of a parent's length, what the rules leave of it on average where its children stand.
  let parent = trunk;
  for (let level = 0; level < 4; level++) {
    const at = `levels.${level}`;
    const used = Math.min(level, levels);
    values[`${at}.curveRes`] = Math.min(tree.sections[used]!, 40);
    const wander = wandering(tree, used);
    values[`${at}.curveV`] = wander;
    values[`${at}.curveSideV`] = wander;
    if (level === 0) continue;
    values[`${at}.downAngle`] = angle[level]!;
    values[`${at}.rotate`] = 137.5;
    values[`${at}.rotateV`] = 30;
    if (level > levels) continue;
    values[`${at}.taper`] = 1;
    const mean = level === 1 ? (evergreen ? 0.5 : 0.75) : 0.7;
    const own = evergreen ? chain[level]! * (level === 1 ? 1 - start[1]! : (1 - start[level]!) / 2) : chain[level]!;
    values[`${at}.length`] = level === 1 ? own / trunk : own / (parent * mean);
    parent = level === 1 ? own * mean : own;
    const bearing = children[level - 1]! + (evergreen ? 0 : 1);
    const share = level === 1 ? 1 : level === 2 ? 0.2 + 0.8 * (evergreen ? 0.5 : 0.75) : 0.75;
    values[`${at}.branches`] = bearing / share;
  }
  Object.assign(values, pull(tree));
  const cards = tree.leaves.count + (evergreen ? 0 : 1);
  values['leaves.count'] = (cards * leavesEach) / (levels === 0 ? 1 : 0.75);
  values['leaves.downAngle'] = tree.leaves.angle;
  values['leaves.downAngleV'] = 10;
  values['leaves.rotate'] = 137.5;
  values['leaves.rotateV'] = 30;
  return values;
}

/** Mean radius in units of the branches of each level at their base. */
function radii({ radius, taper, start, levels, type }: EzTreeValues): number[] {
  const list = [radius[0]!];
  for (let level = 1; level <= levels; level++) {
    const fall = type === 'evergreen' ? 1 : taper[level - 1]!;
    list.push(list[level - 1]! * radius[level]! * Math.max(0.02, 1 - (fall * (1 + start[level]!)) / 2));
  }
  return list;
}

/** The power by which radii fall as lengths do: as it comes out between the trunk and its branches. */
function ratioPower(tree: EzTreeValues, chain: readonly number[]): number {
  if (tree.levels === 0) return 1.2;
  const [thick, thin] = radii(tree);
  const shorter = chain[1]! / chain[0]!;
  const thinner = thin! / thick!;
  if (shorter > 0.9 || thinner >= 1) return 1;
  return Math.round(Math.min(Math.max(Math.log(thinner) / Math.log(shorter), 0.5), 3) * 100) / 100;
}

/** Degrees by which the sections of a level turn at random, all together: thin branches turn further. */
function wandering(tree: EzTreeValues, level: number): number {
  const radius = radii(tree)[level]!;
  const each = Math.abs(tree.gnarliness[level]!) * Math.max(1, 1 / Math.sqrt(radius)) * DEGREES;
  return Math.min(each * tree.sections[level]!, 360);
}

/** What the force along the vertical makes of the branches: the bend of the main ones, and the attraction of the others. */
function pull(tree: EzTreeValues): Record<string, ParameterValue> {
  const { force, levels, sections, angle } = tree;
  const size = Math.sqrt(force.x * force.x + force.y * force.y + force.z * force.z);
  const up = size > 0 ? (force.strength * force.y) / size : 0;
  if (levels === 0 || up === 0) return {};
  const radius = radii(tree);
  // Degrees in all; a branch gets thinner along its way, and then turns faster.
  const turn = (level: number): number => ((up * sections[level]! * DEGREES) / radius[level]!) * 1.5;
  const most = (level: number): number => (up > 0 ? Math.abs(angle[level]!) : 180 - Math.abs(angle[level]!));
  const bend = (level: number): number => Math.min(Math.max(turn(level), -most(level)), most(level));
  const values: Record<string, ParameterValue> = { 'levels.1.curve': -bend(1) };
  if (levels >= 2) values['tree.attractionUp'] = bend(2) / Math.max(60, most(2));
  return values;
}

/** What of the file has no counterpart. */
function notesOf(tree: EzTreeValues): string[] {
  const notes: string[] = [];
  const { force, levels, start, twist } = tree;
  if (force.strength !== 0 && (force.x !== 0 || force.z !== 0))
    notes.push('The force pulls up or down only here: its part to the side (branch.force.direction) was left out.');
  if (levels >= 2 && start.slice(2, levels + 1).some((from) => from > 0))
    notes.push(
      'Branches of branches start at the base of their parent here: branch.start beyond level 1 was left out.',
    );
  if (tree.leaves.start > 0) notes.push('Leaves start at the base of their stem here: leaves.start was left out.');
  if (twist.slice(0, levels + 1).some((turn) => turn !== 0))
    notes.push('Twist (branch.twist) was left out: here it would move no branch, only where children stand around it.');
  if (tree.trellis) notes.push('The trellis was left out: stems here bend to the light, not to a frame.');
  if (tree.leaves.sizeVariance > 0)
    notes.push('All leaves of a tree are of one size here: leaves.sizeVariance was left out.');
  if (tree.unread.length > 0)
    notes.push(
      `Left out, since nobody knows them: ${tree.unread.slice(0, 12).join(', ')}${tree.unread.length > 12 ? ` and ${tree.unread.length - 12} more` : ''}.`,
    );
  return notes;
}
