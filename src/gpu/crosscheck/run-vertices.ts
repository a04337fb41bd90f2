import {
  BufferAttribute,
  BufferGeometry,
  Camera,
  FloatType,
  GLSL3,
  type IUniform,
  NearestFilter,
  NoBlending,
  Points,
  RawShaderMaterial,
  RGBAFormat,
  Sphere,
  type WebGLRenderer,
  WebGLRenderTarget,
} from 'three';
import fragmentShader from '../../../shaders/debug/check-vertex.frag';
import { PassState } from '../pass-state.ts';
import { treeShader } from '../tree-shader.ts';
import { PARTS } from './compare.ts';

/** A vertex shader and the vertices to run it on. */
export interface VertexRun {
  /** Reads the attributes and puts each vertex at its `slot`. */
  readonly vertexShader: string;
  readonly uniforms: Record<string, IUniform>;
  readonly defines?: Record<string, number>;
  /** Numbers a vertex of each attribute, `position` among them. */
  readonly attributes: Readonly<Record<string, { readonly data: Float32Array; readonly size: number }>>;
}

const WIDTH = 128;

/** Runs a vertex shader of the deformer on single vertices and reads back what it made: 16 numbers a vertex. */
export function runVertices(renderer: WebGLRenderer, run: VertexRun): Float32Array {
  const count = run.attributes.position.data.length / run.attributes.position.size;
  const height = Math.ceil(count / WIDTH);
  const target = new WebGLRenderTarget(WIDTH, height, {
    count: 4,
    format: RGBAFormat,
    type: FloatType,
    minFilter: NearestFilter,
    magFilter: NearestFilter,
    depthBuffer: false,
  });
  const geometry = new BufferGeometry();
  for (const [name, { data, size }] of Object.entries(run.attributes)) {
    geometry.setAttribute(name, new BufferAttribute(data, size));
  }
  geometry.setAttribute('slot', new BufferAttribute(slots(count, height), 2));
  geometry.boundingSphere = new Sphere();
  const material = new RawShaderMaterial({
    glslVersion: GLSL3,
    vertexShader: treeShader(run.vertexShader),
    fragmentShader,
    uniforms: run.uniforms,
    defines: run.defines ?? {},
    blending: NoBlending,
    depthTest: false,
    depthWrite: false,
    toneMapped: false,
  });
  const points = new Points(geometry, material);
  points.frustumCulled = false;
  const state = new PassState();
  state.begin(renderer);
  renderer.setRenderTarget(target);
  renderer.render(points, new Camera());
  state.end(renderer);

  const all = new Float32Array(count * PARTS);
  const one = new Float32Array(WIDTH * height * 4);
  for (let i = 0; i < 4; i++) {
    renderer.readRenderTargetPixels(target, 0, 0, WIDTH, height, one, undefined, i);
    for (let s = 0; s < count; s++) all.set(one.subarray(4 * s, 4 * s + 4), s * PARTS + 4 * i);
  }
  geometry.dispose();
  material.dispose();
  target.dispose();
  return all;
}

/** The middle of each vertex's texel in clip space. */
function slots(count: number, height: number): Float32Array {
  const data = new Float32Array(2 * count);
  for (let i = 0; i < count; i++) {
    data[2 * i] = (2 * ((i % WIDTH) + 0.5)) / WIDTH - 1;
    data[2 * i + 1] = (2 * (Math.floor(i / WIDTH) + 0.5)) / height - 1;
  }
  return data;
}
