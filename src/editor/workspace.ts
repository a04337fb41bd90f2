import type { LinkDocument } from '../core/link/link.ts';
import { documentFields, readDocument } from '../core/project/project-document.ts';
import { STILL, type Wind } from '../core/wind/wind.ts';
import type { FileStep, Steps } from './history.ts';
import type { KeptFile } from './kept-file.ts';
import type { Made } from './made.ts';
import type { Snapshot } from './session.ts';

/** What the page keeps by itself of one tab: all that a crash or a closed tab would take. */
export interface Workspace extends Steps {
  readonly version: 1;
  /** Milliseconds since 1970. */
  readonly when: number;
  readonly document: LinkDocument;
  readonly snapshots: readonly Snapshot[];
  /** Paths of locked parameters. */
  readonly locks: readonly string[];
  readonly file: KeptFile | null;
}

const isObject = (value: unknown): value is Readonly<Record<string, unknown>> =>
  typeof value === 'object' && value !== null && !Array.isArray(value);

const isText = (value: unknown): value is string => typeof value === 'string';

const listOf = <T>(value: unknown, is: (entry: unknown) => entry is T): T[] | null =>
  Array.isArray(value) && value.every(is) ? value : null;

/** Tells which stored documents are whole; winds that many of them share are looked at once. */
class Checks {
  private readonly keys: readonly string[];
  private readonly sound = new WeakSet<object>();

  /** `like` has every key that a document must have. */
  constructor(like: object) {
    this.keys = Object.keys(like);
  }

  /** A document, or what is kept of one as a step, whose numbers and words are all allowed. */
  isMade = (value: unknown): value is Made => {
    if (!isObject(value)) return false;
    const looked = ['time', 'paused', 'rate', 'camera', 'theme'];
    if (this.keys.some((key) => value[key] === undefined && !looked.includes(key))) return false;
    const { species, ownSpecies, wind, compare } = value as unknown as Made;
    if (!isText(species) || !(ownSpecies === null || isText(ownSpecies))) return false;
    try {
      const document = {
        ...(value as unknown as LinkDocument),
        wind: this.unseen(wind),
        compare: compare && { ...compare, wind: this.unseen(compare.wind) },
      };
      const faults: unknown[] = [];
      readDocument(documentFields(document), faults as Parameters<typeof readDocument>[1]);
      if (faults.length > 0) return false;
    } catch {
      // Parts that are no objects at all.
      return false;
    }
    this.sound.add(wind);
    if (compare) this.sound.add(compare.wind);
    return true;
  };

  isDocument = (value: unknown): value is LinkDocument =>
    this.isMade(value) && this.keys.every((key) => (value as unknown as Record<string, unknown>)[key] !== undefined);

  isSnapshot = (value: unknown): value is Snapshot => {
    if (!isObject(value)) return false;
    const { id, name, when, link, document, thumbnail } = value;
    return (
      [id, name, link].every(isText) &&
      Number.isFinite(when) &&
      (document === null || this.isDocument(document)) &&
      (thumbnail === null || (isText(thumbnail) && thumbnail.startsWith('data:image/')))
    );
  };

  isFile = (value: unknown): value is KeptFile | null =>
    value === null || (isObject(value) && isText(value.name) && isText(value.snapshots) && this.isMade(value.made));

  isFileStep = (value: unknown): value is FileStep =>
    isObject(value) && Number.isInteger(value.at) && this.isFile(value.before) && this.isFile(value.after);

  private unseen(wind: Wind): Wind {
    return this.sound.has(wind) ? STILL : wind;
  }
}

/**
 * What was kept, as far as it can be used: null where the document itself is broken or of another version; `cut` where the steps were.
 *
 * `like` is a whole document. Never throws.
 */
export function readWorkspace(value: unknown, like: LinkDocument): { workspace: Workspace; cut: boolean } | null {
  if (!isObject(value) || value.version !== 1 || !Number.isFinite(value.when)) return null;
  const checks = new Checks(like);
  if (!checks.isDocument(value.document)) return null;
  const past = listOf(value.past, checks.isMade);
  const future = listOf(value.future, checks.isMade);
  const files = listOf(value.files, checks.isFileStep);
  const snapshots = listOf(value.snapshots, checks.isSnapshot);
  const locks = listOf(value.locks, isText);
  const file = checks.isFile(value.file) ? value.file : undefined;
  const steps = past && future && files ? { past, future, files } : { past: [], future: [], files: [] };
  return {
    workspace: {
      ...steps,
      version: 1,
      when: value.when as number,
      document: value.document,
      snapshots: snapshots ?? (Array.isArray(value.snapshots) ? value.snapshots.filter(checks.isSnapshot) : []),
      locks: locks ?? [],
      file: file ?? null,
    },
    cut: steps.past !== past || !snapshots || !locks || file === undefined,
  };
}
