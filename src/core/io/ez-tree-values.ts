import { foundText } from '../file/allowed.ts';
import type { Fault } from '../file/fault.ts';
import { oneLine } from '../file/one-line.ts';
import { fieldsOf } from '../file/read.ts';

/** Metres that a unit of ez-tree becomes: it has none of its own, and its trees stand 20 to 100 units high. */
export const EZ_TREE_UNIT = 0.25;

/** What an import reads of ez-tree's TreeOptions: numbers by level are lists, level 0 the trunk. */
export interface EzTreeValues {
  readonly seed: number;
  readonly type: 'deciduous' | 'evergreen';
  readonly bark: { readonly type: string; readonly tint: number };
  /** Levels of branches above the trunk, 0..3. */
  readonly levels: number;
  /** Degrees against the parent. */
  readonly angle: readonly number[];
  readonly children: readonly number[];
  readonly force: { readonly x: number; readonly y: number; readonly z: number; readonly strength: number };
  /** Radians a section, up and down, of a branch that is one unit thick or more. */
  readonly gnarliness: readonly number[];
  readonly length: readonly number[];
  /** Of the trunk; of other levels a part of the parent's there. */
  readonly radius: readonly number[];
  readonly sections: readonly number[];
  readonly start: readonly number[];
  readonly taper: readonly number[];
  readonly twist: readonly number[];
  readonly leaves: {
    readonly type: string;
    readonly billboard: string;
    readonly angle: number;
    readonly count: number;
    readonly start: number;
    readonly size: number;
    readonly sizeVariance: number;
    readonly tint: number;
  };
  readonly trellis: boolean;
  /** Keys of the file that nothing reads. */
  readonly unread: readonly string[];
}

type Rule = readonly [least: number, most: number, otherwise: number, whole?: true];

/** What ez-tree begins with where a file leaves something out, and what it can grow from, by level. */
const BY_LEVEL = {
  angle: [
    [-360, 360, 0],
    [-360, 360, 70],
    [-360, 360, 60],
    [-360, 360, 60],
  ],
  children: [
    [0, 1000, 7, true],
    [0, 1000, 7, true],
    [0, 1000, 5, true],
    [0, 1000, 0, true],
  ],
  gnarliness: [
    [-10, 10, 0.15],
    [-10, 10, 0.2],
    [-10, 10, 0.3],
    [-10, 10, 0.02],
  ],
  length: [
    [0.01, 1000, 20],
    [0.01, 1000, 20],
    [0.01, 1000, 10],
    [0.01, 1000, 1],
  ],
  radius: [
    [0.001, 100, 1.5],
    [0.001, 100, 0.7],
    [0.001, 100, 0.7],
    [0.001, 100, 0.7],
  ],
  sections: [
    [1, 1000, 12, true],
    [1, 1000, 10, true],
    [1, 1000, 8, true],
    [1, 1000, 6, true],
  ],
  start: [
    [0, 1, 0],
    [0, 1, 0.4],
    [0, 1, 0.3],
    [0, 1, 0.3],
  ],
  taper: [
    [0, 1, 0.7],
    [0, 1, 0.7],
    [0, 1, 0.7],
    [0, 1, 0.7],
  ],
  twist: [
    [-100, 100, 0],
    [-100, 100, 0],
    [-100, 100, 0],
    [-100, 100, 0],
  ],
} as const satisfies Readonly<Record<string, readonly Rule[]>>;

const COLOUR: Rule = [0, 0xffffff, 0xffffff, true];
const ANY: Rule = [-1e6, 1e6, 0];

/** The values of a parsed file; faults go on the list, and what they concern has the default. */
export function readEzTree(value: unknown, faults: Fault[]): EzTreeValues {
  const unread: string[] = [];
  const file = new Part(value, '', faults, unread);
  const bark = file.part('bark');
  const branch = file.part('branch');
  const force = branch.part('force');
  const direction = force.part('direction');
  const leaves = file.part('leaves');
  const trellis = file.part('trellis');
  const seed = file.number('seed', [-Number.MAX_SAFE_INTEGER, Number.MAX_SAFE_INTEGER, 0]);
  const byLevel = (key: keyof typeof BY_LEVEL): number[] => {
    const part = branch.part(key);
    const read = BY_LEVEL[key].map((rule, level) => part.number(String(level), rule));
    part.close();
    return read;
  };
  const read: EzTreeValues = {
    seed,
    type: file.choice('type', ['deciduous', 'evergreen'] as const),
    bark: { type: bark.text('type', 'oak'), tint: bark.number('tint', COLOUR) },
    levels: branch.number('levels', [0, 3, 3, true]),
    angle: byLevel('angle'),
    children: byLevel('children'),
    force: {
      x: direction.number('x', ANY),
      y: direction.number('y', [-1e6, 1e6, 1]),
      z: direction.number('z', ANY),
      strength: force.number('strength', [-100, 100, 0.01]),
    },
    gnarliness: byLevel('gnarliness'),
    length: byLevel('length'),
    radius: byLevel('radius'),
    sections: byLevel('sections'),
    start: byLevel('start'),
    taper: byLevel('taper'),
    twist: byLevel('twist'),
    leaves: {
      type: leaves.text('type', 'oak'),
      billboard: leaves.text('billboard', 'double'),
      angle: leaves.number('angle', [-360, 360, 10]),
      count: leaves.number('count', [0, 1000, 1, true]),
      start: leaves.number('start', [0, 1, 0]),
      size: leaves.number('size', [0.001, 100, 2.5]),
      sizeVariance: leaves.number('sizeVariance', [0, 10, 0.7]),
      tint: leaves.number('tint', COLOUR),
    },
    trellis: trellis.flag('enabled'),
    unread,
  };
  // What only draws is known and left alone.
  branch.part('segments');
  for (const [part, keys] of [
    [bark, ['flatShading', 'textured', 'textureScale']],
    [leaves, ['alphaTest']],
    [branch, ['segments']],
  ] as const)
    part.known(keys);
  for (const part of [direction, force, branch, leaves, bark, file]) part.close();
  return read;
}

/** A part of the file: what is asked of it is noted, so that the rest can be named. */
class Part {
  private readonly asked = new Set<string>();
  private readonly fields: Readonly<Record<string, unknown>>;
  private readonly path: string;
  private readonly faults: Fault[];
  private readonly unread: string[];

  constructor(value: unknown, path: string, faults: Fault[], unread: string[]) {
    this.path = path;
    this.faults = faults;
    this.unread = unread;
    this.fields = (value === undefined ? undefined : fieldsOf(value, path, faults)) ?? {};
  }

  private value(key: string): unknown {
    this.asked.add(key);
    return Object.hasOwn(this.fields, key) ? this.fields[key] : undefined;
  }

  private at(key: string): string {
    return this.path === '' ? key : `${this.path}.${key}`;
  }

  private fault(key: string, found: unknown, allowed: string): void {
    this.faults.push({ path: this.at(key), found: foundText(found), allowed });
  }

  part(key: string): Part {
    return new Part(this.value(key), this.at(key), this.faults, this.unread);
  }

  number(key: string, [least, most, otherwise, whole]: Rule): number {
    const found = this.value(key);
    if (found === undefined) return otherwise;
    if (typeof found === 'number' && found >= least && found <= most) return whole ? Math.round(found) : found;
    this.fault(key, found, `a number from ${least} to ${most}`);
    return otherwise;
  }

  text(key: string, otherwise: string): string {
    const found = this.value(key);
    if (found === undefined) return otherwise;
    if (typeof found === 'string') return found.toLowerCase();
    this.fault(key, found, 'a text');
    return otherwise;
  }

  choice<Choice extends string>(key: string, choices: readonly [Choice, ...Choice[]]): Choice {
    const text = this.text(key, choices[0]);
    const found = choices.find((choice) => choice === text);
    if (found === undefined) this.fault(key, this.fields[key], choices.map((choice) => `"${choice}"`).join(' or '));
    return found ?? choices[0];
  }

  flag(key: string): boolean {
    const found = this.value(key);
    if (found !== undefined && typeof found !== 'boolean') this.fault(key, found, 'true or false');
    return found === true;
  }

  known(keys: readonly string[]): void {
    for (const key of keys) this.asked.add(key);
  }

  /** Puts the keys that nobody asked for on the list. */
  close(): void {
    for (const key of Object.keys(this.fields)) if (!this.asked.has(key)) this.unread.push(this.at(oneLine(key)));
  }
}
