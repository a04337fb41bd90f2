import { DataArrayTexture, FloatType, NearestFilter, RGBAFormat, type WebGLRenderer, WebGLRenderTarget } from 'three';
import { PassState } from '../pass-state.ts';
import { TexelDraw, texelMaterial } from '../texel-draw.ts';
import { compareLine, PARTS, type Results } from './compare.ts';
import type { CheckProgram } from './program.ts';
import { randomStream } from './random.ts';
import type { Check } from './report.ts';

const WIDTH = 64;

/** Runs the GLSL of a program on its inputs, and the twins on the same float32 numbers; 64 * `rows` samples. */
export function runProgram(renderer: WebGLRenderer, program: CheckProgram, rows = 64, seed = 1): Check[] {
  const samples = WIDTH * rows;
  const inputs = makeInputs(program, samples, seed);
  const gpu = runOnGpu(renderer, program, inputs, rows);
  const twin = new Float64Array(samples * PARTS);
  const size = new Float64Array(samples).fill(1);
  for (let i = 0; i < samples; i++) {
    const given = inputsOf(inputs, i, samples, program.layers);
    const results = program.twin(given);
    for (let part = 0; part < results.length; part++) twin[i * PARTS + part] = results[part];
    if (program.size) size[i] = program.size(given);
  }
  const results: Results = { samples, gpu, twin, size };
  return program.lines.map((line) => compareLine(line, results));
}

/** Inputs layer by layer as the texture array holds them: number c of layer l of sample i is at ((l * samples) + i) * 4 + c. */
function makeInputs({ layers, edges, inputs }: CheckProgram, samples: number, seed: number): Float32Array<ArrayBuffer> {
  const random = randomStream(seed);
  const data = new Float32Array(layers * samples * 4);
  for (let i = 0; i < samples; i++) {
    const given = i < edges.length ? edges[i] : inputs(random);
    for (let j = 0; j < given.length; j++) data[((j >> 2) * samples + i) * 4 + (j & 3)] = given[j];
  }
  return data;
}

function inputsOf(data: Float32Array, sample: number, samples: number, layers: number): number[] {
  const given: number[] = [];
  for (let layer = 0; layer < layers; layer++) {
    const at = (layer * samples + sample) * 4;
    given.push(data[at], data[at + 1], data[at + 2], data[at + 3]);
  }
  return given;
}

function runOnGpu(
  renderer: WebGLRenderer,
  { fragment, defines, uniforms, layers }: CheckProgram,
  data: Float32Array<ArrayBuffer>,
  rows: number,
): Float32Array {
  const inputs = new DataArrayTexture(data, WIDTH, rows, layers);
  inputs.format = RGBAFormat;
  inputs.type = FloatType;
  inputs.needsUpdate = true;
  const target = new WebGLRenderTarget(WIDTH, rows, {
    count: 4,
    format: RGBAFormat,
    type: FloatType,
    minFilter: NearestFilter,
    magFilter: NearestFilter,
    depthBuffer: false,
  });
  const material = texelMaterial(fragment, { ...uniforms, inputs: { value: inputs } }, { ...defines });
  const draw = new TexelDraw(WIDTH, rows, [[0, WIDTH * rows]]);
  const state = new PassState();
  state.begin(renderer);
  draw.draw(renderer, target, material, 0);
  state.end(renderer);

  const all = new Float32Array(WIDTH * rows * PARTS);
  const one = new Float32Array(WIDTH * rows * 4);
  for (let i = 0; i < 4; i++) {
    renderer.readRenderTargetPixels(target, 0, 0, WIDTH, rows, one, undefined, i);
    for (let s = 0; s < WIDTH * rows; s++) all.set(one.subarray(4 * s, 4 * s + 4), s * PARTS + 4 * i);
  }
  draw.dispose();
  material.dispose();
  target.dispose();
  inputs.dispose();
  return all;
}
