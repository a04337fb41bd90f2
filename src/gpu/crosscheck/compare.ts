import { type Check, check } from './report.ts';

/** Which of a sample's 16 results a line of the report is about, and how near they must be. */
export interface Line {
  /** Name of the GLSL function, and what of it. */
  readonly name: string;
  /** Indices 0..15 into the four targets' texels. */
  readonly parts: readonly number[];
  /** `each`: the largest difference of a part; `vector`: the length of the difference of all, an angle for unit vectors. */
  readonly error?: 'each' | 'vector';
  /** Divides the error by `size(input)` of the sample: metres become parts of the branch. */
  readonly bySize?: boolean;
  /** Divides the error by the length of the twin's vector where that is more than 1. */
  readonly relative?: boolean;
  /** The numbers are slopes and compared as angles, atan(value / size): a steep slope of 1e5 or 2e5 makes no other normal. */
  readonly slope?: boolean;
  readonly tolerance: number;
  /** Why this tolerance, and the unit of the error. */
  readonly note: string;
}

/** What the GPU made of a sample and what the twin makes of it, both 16 numbers a sample. */
export interface Results {
  readonly samples: number;
  readonly gpu: Float32Array;
  readonly twin: Float64Array;
  /** Size of each sample's branch, for lines that divide by it. */
  readonly size: Float64Array;
}

/** Numbers a sample: four targets of four. */
export const PARTS = 16;

/** The line's largest error over all samples; what is not a number counts as infinite. */
export function compareLine(line: Line, { samples, gpu, twin, size }: Results): Check {
  let worst = 0;
  for (let i = 0; i < samples; i++) {
    let error = 0;
    let length = 0;
    for (const part of line.parts) {
      const [a, b] = [gpu[i * PARTS + part], twin[i * PARTS + part]];
      const difference = Math.abs(line.slope ? Math.atan(a / size[i]) - Math.atan(b / size[i]) : a - b);
      error = line.error === 'vector' ? Math.hypot(error, difference) : Math.max(error, difference);
      length = Math.hypot(length, b);
      if (Number.isNaN(difference)) error = Infinity;
    }
    if (line.relative) error /= Math.max(1, length);
    worst = Math.max(worst, line.bySize ? error / size[i] : error);
  }
  return check(line.name, samples, worst, line.tolerance, line.note);
}
