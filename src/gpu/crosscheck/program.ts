import type { IUniform } from 'three';
import type { Line } from './compare.ts';
import type { Random } from './random.ts';

/** Functions of the GLSL library checked by one shader: inputs, the twins' answers, and what is compared. */
export interface CheckProgram {
  readonly name: string;
  /** Fragment shader of shaders/debug. */
  readonly fragment: string;
  readonly defines?: Readonly<Record<string, number>>;
  readonly uniforms?: Readonly<Record<string, IUniform>>;
  /** Layers of input, four numbers each. */
  readonly layers: number;
  /** Inputs that random ones would not hit; they come first. Each has 4 * layers numbers, missing ones are 0. */
  readonly edges: readonly (readonly number[])[];
  /** Random inputs of one sample. */
  readonly inputs: (random: Random) => readonly number[];
  /** What the twins say: 16 numbers, in the order of the shader's targets; the inputs are float32. */
  readonly twin: (given: readonly number[]) => readonly number[];
  /** Size of the sample's branch in metres, for lines that divide by it. */
  readonly size?: (given: readonly number[]) => number;
  readonly lines: readonly Line[];
}
