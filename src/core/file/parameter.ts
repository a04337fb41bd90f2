/** What a parameter of a file says of itself, whatever its kind. */
interface Common {
  /** The part of the file in which it stands. */
  readonly group: string;
  readonly key: string;
  /** What a person reads, short. */
  readonly label: string;
  /** One sentence. */
  readonly help: string;
  /** The paper's name of it, '' where Windgrove added it. */
  readonly symbol: string;
  /** Section or equation of the paper that explains it, '' where Windgrove added it. */
  readonly section: string;
  /** The levels that read it, where not all do; elsewhere it may be left out. */
  readonly levels?: 'trunk' | 'branches';
  /** May be left out: then `default` holds, or it stays absent where that is undefined. */
  readonly optional?: true;
}

export interface NumberParameter extends Common {
  readonly kind: 'number';
  /** As people write it: 'm', 'm/s', 'deg', 'turns', ...; '' for a plain number or fraction. `allowed.ts` has the words. */
  readonly unit: string;
  readonly min: number;
  readonly max: number;
  readonly step: number;
  readonly default: number | null | undefined;
  /** Only whole numbers. */
  readonly integer?: true;
  /** What null means in its place, where that is allowed. */
  readonly orNull?: string;
  /** What the numbers 0, 1, 2, ... stand for, where it is an id. */
  readonly names?: readonly string[];
  /** What a negative value means, where it is a flag of the paper. */
  readonly negative?: string;
}

export interface FlagParameter extends Common {
  readonly kind: 'flag';
  readonly default: boolean;
}

export interface ChoiceParameter extends Common {
  readonly kind: 'choice';
  readonly choices: readonly string[];
  readonly default: string | undefined;
}

/** sRGB, '#rrggbb'. */
export interface ColourParameter extends Common {
  readonly kind: 'colour';
  readonly default: string | undefined;
}

/** A list of up to eight numbers, such as one for each level, the last for all deeper ones. */
export interface NumbersParameter extends Common {
  readonly kind: 'numbers';
  /** Least length of the list; 1 by default. */
  readonly least?: number;
  readonly unit: string;
  readonly min: number;
  readonly max: number;
  readonly step: number;
  readonly default: readonly number[] | undefined;
}

export type Parameter = NumberParameter | FlagParameter | ChoiceParameter | ColourParameter | NumbersParameter;

/** A part of a file and its parameters. */
export interface ParameterTable {
  /** Where in the file: a key, or keys with dots between. */
  readonly group: string;
  readonly title: string;
  readonly help: string;
  readonly parameters: readonly Parameter[];
}

/** What a row of a table says of a number besides its key, label and help. */
type NumberRow = Partial<
  Pick<
    NumberParameter,
    'unit' | 'integer' | 'names' | 'negative' | 'orNull' | 'symbol' | 'section' | 'levels' | 'optional' | 'default'
  >
>;

/** A row of a table: a number from `min` to `max`. */
export const number = <Group extends string>(
  group: Group,
  key: string,
  label: string,
  help: string,
  [min, max, step]: readonly [number, number, number],
  row: NumberRow,
): NumberParameter => ({
  kind: 'number',
  group,
  key,
  label,
  help,
  unit: '',
  symbol: '',
  section: '',
  default: undefined,
  min,
  max,
  step,
  ...row,
});
