import type { LevelParameters, Species } from '../../core/species/species.ts';

/** What is changed of a species: groups of its parameters, and levels by their number. */
export interface Changes {
  readonly tree?: Partial<Species['tree']>;
  readonly leaves?: Partial<Species['leaves']>;
  readonly pruning?: Partial<Species['pruning']>;
  readonly switches?: Partial<Species['switches']>;
  readonly levels?: Readonly<Record<number, Partial<LevelParameters>>>;
}

/** The species with some of its parameters changed. */
export const changedSpecies = (species: Species, { tree, leaves, pruning, switches, levels }: Changes): Species => ({
  ...species,
  tree: { ...species.tree, ...tree },
  leaves: { ...species.leaves, ...leaves },
  pruning: { ...species.pruning, ...pruning },
  switches: { ...species.switches, ...switches },
  levels: species.levels.map((level, i) => ({ ...level, ...levels?.[i] })),
});

/** What stands behind `#` in the editor's address for a species that ships with these changes. */
export function editorLink(id: string, { tree, leaves, pruning, switches, levels }: Changes = {}, seed = 1): string {
  const pairs: [string, string][] = [
    ['s', id],
    ['seed', String(seed)],
    ['blow', '0'],
  ];
  const group = (name: string, values: object | undefined): void => {
    for (const [key, value] of Object.entries(values ?? {}))
      pairs.push([`${name}.${key}`, typeof value === 'boolean' ? String(Number(value)) : String(value)]);
  };
  group('tree', tree);
  for (const [level, values] of Object.entries(levels ?? {})) group(`levels.${level}`, values);
  group('leaves', leaves);
  group('pruning', pruning);
  group('switches', switches);
  return new URLSearchParams(pairs).toString();
}
