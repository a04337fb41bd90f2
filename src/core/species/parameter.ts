/** Where in a species file a parameter stands. `levels` is a list, one entry a level. */
export type ParameterGroup = 'tree' | 'levels' | 'leaves' | 'pruning' | 'switches' | 'bark' | 'foliage' | 'wind';

interface Common {
  readonly group: ParameterGroup;
  readonly key: string;
  /** What a person reads, short. */
  readonly label: string;
  /** One sentence. */
  readonly help: string;
  /** The paper's name of it, '' where Windgrove added it. */
  readonly symbol: string;
  /** Section of Weber & Penn 1995 that explains it, '' where Windgrove added it. */
  readonly section: string;
  /** The levels that read it, where not all do; elsewhere it may be left out. */
  readonly levels?: 'trunk' | 'branches';
  /** May be left out: then `default` holds, or it stays absent where that is undefined. The paper's own are never optional. */
  readonly optional?: true;
}

export interface NumberParameter extends Common {
  readonly kind: 'number';
  /** 'm', 'deg', 'Hz', 'turns', or '' for a plain number or fraction. */
  readonly unit: string;
  readonly min: number;
  readonly max: number;
  readonly step: number;
  readonly default: number | undefined;
  /** Only whole numbers. */
  readonly integer?: true;
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
  readonly default: string;
}

/** sRGB, '#rrggbb'. */
export interface ColourParameter extends Common {
  readonly kind: 'colour';
  readonly default: string;
}

/** A number for each level, the last for all deeper ones. */
export interface NumbersParameter extends Common {
  readonly kind: 'numbers';
  readonly unit: string;
  readonly min: number;
  readonly max: number;
  readonly step: number;
  readonly default: readonly number[];
}

export type Parameter = NumberParameter | FlagParameter | ChoiceParameter | ColourParameter | NumbersParameter;

/** What a row of the table says of a number besides its key, label and help. */
type NumberRow = Partial<
  Pick<
    NumberParameter,
    'unit' | 'integer' | 'names' | 'negative' | 'symbol' | 'section' | 'levels' | 'optional' | 'default'
  >
>;

/** A row of the table: a number from `min` to `max`. */
export const number = (
  group: ParameterGroup,
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
