import { parseXml, type XmlElement, XmlError } from '@rgrove/parse-xml';
import { foundText } from '../file/allowed.ts';
import type { Fault } from '../file/fault.ts';
import { oneLine } from '../file/one-line.ts';
import { destinationOf, LEAF_SHAPE_IDS } from './arbaro-names.ts';
import { speciesOf } from './import-values.ts';
import { type Imported, LONGEST_IMPORT } from './imported.ts';

const SOURCE = 'Imported from an Arbaro file; bark, foliage and wind: Windgrove';

/** A number as such a file has it. */
const NUMBER = /^[+-]?(\d+\.?\d*|\.\d+)([eE][+-]?\d+)?$/;

/** More faults than these say nothing that the first do not. */
const MOST_FAULTS = 20;

/**
 * The species of an Arbaro tree file: `<arbaro><species name="..."><param name="..." value="..."/>`, whose parameters are those of
 * Weber & Penn's paper.
 *
 * Parameters that have no counterpart, or stand beyond what Windgrove allows, are named in `notes`. Never throws.
 */
export function parseArbaro(text: string): Imported {
  const fault = (found: string): Imported => ({
    faults: [{ path: '', found, allowed: 'a tree as an XML file of Arbaro' }],
  });
  const input = text.replace(/^[\ufeff\s]+/, '');
  if (input === '') return fault('an empty file');
  if (input.length > LONGEST_IMPORT) return fault(`${input.length} characters`);
  let root: XmlElement | null;
  try {
    root = parseXml(input).root;
  } catch (error) {
    return fault(error instanceof XmlError ? `broken XML at line ${error.line}, column ${error.column}` : 'broken XML');
  }
  if (root?.name !== 'arbaro') return fault(`the element <${oneLine(root?.name ?? '')}>`);
  const trees = elements(root, 'species');
  if (trees.length === 0)
    return { faults: [{ path: 'arbaro', found: 'no <species>', allowed: '<species name="..."> with its parameters' }] };
  return readTree(trees[0]!, trees.length - 1);
}

const elements = (parent: XmlElement, name: string): XmlElement[] =>
  parent.children.filter(
    (child): child is XmlElement => child.type === 'element' && (child as XmlElement).name === name,
  );

/** What the parameters of a tree came to. */
interface Read {
  readonly values: Record<string, number>;
  readonly faults: Fault[];
  readonly unknown: string[];
  readonly left: string[];
  readonly notes: string[];
}

function readTree(tree: XmlElement, others: number): Imported {
  const read: Read = { values: {}, faults: [], unknown: [], left: [], notes: [] };
  const parameters = elements(tree, 'param');
  if (parameters.length === 0)
    return {
      faults: [{ path: 'species', found: 'no <param>', allowed: '<param name="Shape" value="0"/> and others' }],
    };
  for (const parameter of parameters) readParameter(parameter.attributes, read);
  if (read.faults.length > 0) return { faults: read.faults.slice(0, MOST_FAULTS) };
  const { values, notes } = read;
  if (others > 0) notes.push(`The file has ${others} more species; this is its first.`);
  if (read.left.length > 0) notes.push(`Left out, since Windgrove has nothing of the kind: ${listed(read.left)}.`);
  if (read.unknown.length > 0) notes.push(`Left out, since nobody knows them: ${listed(read.unknown)}.`);
  notes.push(
    'Such files say nothing of colours and wood: bark, leaves and the answer to the wind have plain values to start from.',
  );
  // Arbaro's trunks stand where they are told; one is what a file without the count means.
  values['levels.0.branches'] = Math.max(1, values['levels.0.branches'] ?? 1);
  const { species, faults } = speciesOf(tree.attributes.name ?? '', SOURCE, values, notes);
  return faults ? { faults } : { species, notes };
}

function readParameter({ name = '', value = '' }: Readonly<Record<string, string>>, read: Read): void {
  const given = value.trim();
  const path = name === '' ? 'param' : oneLine(name);
  if (name === '') read.faults.push({ path, found: 'no name', allowed: 'the name of a parameter' });
  else if (name === 'Species') return;
  else if (name === 'LeafShape') readLeafShape(given, read);
  else {
    const to = destinationOf(name);
    if (!to) read.unknown.push(path);
    else if (!NUMBER.test(given) || !Number.isFinite(Number(given)))
      read.faults.push({ path, found: foundText(given), allowed: 'a number' });
    else if ('path' in to) read.values[to.path] = Number(given);
    // A parameter that does nothing at its value is not missed.
    else if (Number(given) !== to.idle) read.left.push(`${path} ${Number(given)}`);
  }
}

function readLeafShape(given: string, read: Read): void {
  const id = LEAF_SHAPE_IDS[Object.hasOwn(LEAF_SHAPE_IDS, given.toLowerCase()) ? given.toLowerCase() : ''];
  if (id === undefined) read.notes.push(`Leaves of the shape "${oneLine(given)}" became ovals.`);
  read.values['leaves.shape'] = id ?? 0;
}

/** At most a dozen names, and how many more there are. */
function listed(names: readonly string[]): string {
  const first = names.slice(0, 12).join(', ');
  return names.length > 12 ? `${first} and ${names.length - 12} more` : first;
}
