import { isAllowed } from '../../core/file/allowed.ts';
import { type ChoiceParameter, type FlagParameter, type NumberParameter, number } from '../../core/file/parameter.ts';
import { exportWords } from '../words/export.ts';

const words = exportWords.pictures;

/** What is taken of the picture. */
export type PictureKind = 'picture' | 'sequence' | 'video';

/** A row of the tables of pictures and films, as the export's own rows are. */
export type PictureParameter = (NumberParameter | FlagParameter | ChoiceParameter) & {
  readonly kinds: readonly PictureKind[];
};

/** What pictures and films are asked for. */
export interface PictureOptions {
  /** Pixels. */
  readonly width: number;
  readonly height: number;
  readonly transparent: boolean;
  /** Frames a second, and seconds. */
  readonly rate: number;
  readonly seconds: number;
  readonly loop: boolean;
  readonly container: 'auto' | 'mp4' | 'webm';
  readonly quality: 'medium' | 'high' | 'very-high';
}

const ALL: readonly PictureKind[] = ['picture', 'sequence', 'video'];
const FILMS: readonly PictureKind[] = ['sequence', 'video'];

const common = { group: 'picture', symbol: '', section: '' } as const;

/** The table of the pictures; the dialog draws it as it draws the export's own. */
export const PICTURE_PARAMETERS: readonly PictureParameter[] = [
  {
    ...number('picture', 'width', words.width.label, words.width.help, [16, 16_384, 2], {
      integer: true,
      unit: 'px',
      default: 1920,
    }),
    kinds: ALL,
  },
  {
    ...number('picture', 'height', words.height.label, words.height.help, [16, 16_384, 2], {
      integer: true,
      unit: 'px',
      default: 1080,
    }),
    kinds: ALL,
  },
  {
    ...common,
    kind: 'flag',
    key: 'transparent',
    ...words.transparent,
    default: false,
    kinds: ['picture', 'sequence'],
  },
  {
    ...number('picture', 'rate', words.rate.label, words.rate.help, [1, 120, 1], {
      integer: true,
      default: 30,
    }),
    kinds: FILMS,
  },
  {
    ...number('picture', 'seconds', words.seconds.label, words.seconds.help, [0.1, 120, 0.1], {
      unit: 's',
      default: 6,
    }),
    kinds: FILMS,
  },
  {
    ...common,
    kind: 'flag',
    key: 'loop',
    ...words.loop,
    default: true,
    kinds: FILMS,
  },
  {
    ...common,
    kind: 'choice',
    key: 'container',
    ...words.container,
    choices: ['auto', 'mp4', 'webm'],
    default: 'auto',
    kinds: ['video'],
  },
  {
    ...common,
    kind: 'choice',
    key: 'quality',
    ...words.quality,
    choices: ['medium', 'high', 'very-high'],
    default: 'high',
    kinds: ['video'],
  },
];

/** What is remembered of the choices, where it is still allowed; defaults for the rest. */
export function readPictureOptions(given: Readonly<Record<string, unknown>>): PictureOptions {
  return Object.fromEntries(
    PICTURE_PARAMETERS.map((row) => [row.key, isAllowed(row, given[row.key]) ? given[row.key] : row.default]),
  ) as unknown as PictureOptions;
}
