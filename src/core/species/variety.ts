import { combine, hashUnit } from '../math/hash.ts';
import { type ParameterPlace, type ParameterValue, PLACES, type SpeciesEdits, sameValue, valueAt } from './edits.ts';
import { colourOf, oklabOf } from './oklab.ts';
import { clampTo } from './round-number.ts';
import type { Species } from './species.ts';
import { COLOUR_WIDTH, COLOURS, SIGN_IS_A_FLAG, WIDTHS } from './widths.ts';

/** How many there are to choose from. */
export const VARIANTS = 12;

/** Most that the stems and leaves of a variant may be more than those of its species: a tree near the budget stays near it. */
const MOST_GROWTH = 1.2;

/** A draw of -1..1 for what has this name. */
type Draws = (name: string) => number;

/** Parameters by which the number of stems and leaves is multiplied. */
const COUNTS: ReadonlySet<string> = new Set(['levels.branches', 'leaves.count']);

const ANGLES_OF_LEAVES: ReadonlySet<string> = new Set(['downAngle', 'downAngleV', 'rotate', 'rotateV']);

const NONE: ReadonlySet<string> = new Set();

const nameHash = (name: string): number => {
  let hash = 0;
  for (let i = 0; i < name.length; i++) hash = combine(hash, name.charCodeAt(i));
  return hash;
};

const keyOf = ({ parameter }: ParameterPlace): string => `${parameter.group}.${parameter.key}`;

/** Whether anything of the tree reads the parameter there: stems of that level, or leaves that stand as the level after the last says. */
function isRead(species: Species, { level, parameter }: ParameterPlace): boolean {
  if (level === undefined) return true;
  if (level < species.tree.levels) return true;
  return level === species.tree.levels && ANGLES_OF_LEAVES.has(parameter.key);
}

/**
 * Changes that make another tree of the same kind: each parameter moves by at most `amount` (0..1) times its own variation, or by a few per cent
 * where it has none (`widths.ts`).
 *
 * The same species, seed and amount give the same changes. Whole numbers stay whole, every value is one that the table allows, paths of `locks`
 * stay as they are, and what the species does not have (0) it does not get. An amount of 0 gives none.
 */
export function randomise(species: Species, seed: number, amount: number, locks = NONE): SpeciesEdits {
  const unit = (name: string, more: number): number => hashUnit(combine(combine(seed >>> 0, nameHash(name)), more));
  // The sum of two draws: most trees are near the middle of their kind.
  return changes(species, amount, locks, (name) => unit(name, 1) + unit(name, 2) - 1);
}

/**
 * VARIANTS changes around the present species, spread evenly: of each parameter every variant takes another twelfth of its width, so that twelve
 * show what there is. `amount`, `locks` as `randomise`.
 */
export function moreLikeThis(species: Species, seed: number, amount = 0.6, locks = NONE): SpeciesEdits[] {
  const places = new Map<string, number[]>();
  const order = (name: string): number[] => {
    let found = places.get(name);
    if (!found) {
      const stream = combine(seed >>> 0, nameHash(name));
      found = Array.from({ length: VARIANTS }, (_, i) => i);
      const key = (i: number): number => combine(stream, i);
      found.sort((a, b) => key(a) - key(b) || a - b);
      places.set(name, found);
    }
    return found;
  };
  return Array.from({ length: VARIANTS }, (_, i) =>
    changes(species, amount, locks, (name) => {
      const within = hashUnit(combine(combine(seed >>> 0, nameHash(name)), VARIANTS + i));
      return (2 * (order(name)[i]! + within)) / VARIANTS - 1;
    }),
  );
}

function changes(species: Species, amount: number, locks: ReadonlySet<string>, draws: Draws): SpeciesEdits {
  if (!(amount > 0)) return {};
  const found = [...PLACES.values()].filter((p) => !locks.has(p.path) && isRead(species, p) && isListed(species, p));
  const calm = growthLimit(species, found, amount, draws);
  const edits: Record<string, ParameterValue> = {};
  for (const place of found) {
    const now = valueAt(species, place.path);
    const next = moved(species, place, now, amount, draws, calm);
    if (!sameValue(now, next)) edits[place.path] = next;
  }
  return edits;
}

/** Deeper levels than the file lists are copies of the last: a change of them would add a level to the file. */
const isListed = (species: Species, { level }: ParameterPlace): boolean =>
  level === undefined || level < species.levels.length;

/** The factor on every count that keeps the whole tree from growing by more than MOST_GROWTH; 1 where it does not. */
function growthLimit(species: Species, places: readonly ParameterPlace[], amount: number, draws: Draws): number {
  const counts = places.filter((p) => COUNTS.has(keyOf(p)));
  const growth = counts.reduce((product, place) => {
    const now = valueAt(species, place.path);
    const next = moved(species, place, now, amount, draws, 1);
    return typeof now === 'number' && now !== 0 && typeof next === 'number' ? (product * next) / now : product;
  }, 1);
  return growth > MOST_GROWTH ? (MOST_GROWTH / growth) ** (1 / counts.length) : 1;
}

function moved(
  species: Species,
  place: ParameterPlace,
  now: ParameterValue,
  amount: number,
  draws: Draws,
  calm: number,
): ParameterValue {
  const { path, parameter } = place;
  if (parameter.kind === 'colour' && COLOURS.includes(path))
    return tinted(now as string, parameter.group, amount, draws);
  const width = WIDTHS[keyOf(place)];
  if (!width) return now;
  if (parameter.kind === 'numbers') {
    const list = now as readonly number[];
    return list.map((value, i) => clampTo(parameter, value * (1 + amount * width.part! * draws(`${path}.${i}`))));
  }
  // An id, and what is absent, is what the species is.
  if (parameter.kind !== 'number' || typeof now !== 'number' || parameter.names) return now;
  const variation = width.by ? valueAt(species, path.replace(/[^.]+$/, width.by)) : null;
  // Below 0 a variation is a rule along the parent, not a width.
  const own = typeof variation === 'number' && variation > 0 ? variation * (width.share ?? 1) : 0;
  const most = own > 0 ? own : Math.abs(now) * (width.part ?? 0);
  if (most === 0) return now;
  const key = keyOf(place);
  const factor = COUNTS.has(key) ? calm : 1;
  const next = clampTo(parameter, (now + amount * most * draws(path)) * factor);
  // What the species has it keeps, on its side of 0: a last branch is not taken away.
  if ((SIGN_IS_A_FLAG.has(key) || own === 0) && Math.sign(next) !== Math.sign(now)) return now;
  return next;
}

/** The colour, a little lighter or darker and of another hue; the colours of one group move together. */
function tinted(colour: string, group: string, amount: number, draws: Draws): string {
  const [L, a, b] = oklabOf(colour);
  const { lightness, hue } = COLOUR_WIDTH;
  return colourOf([
    L + amount * lightness * draws(`${group}:lightness`),
    a + amount * hue * draws(`${group}:a`),
    b + amount * hue * draws(`${group}:b`),
  ]);
}
