import type { WebGLRenderer } from 'three';
import fragmentShader from '../../shaders/wind/probe.frag';
import vertexShader from '../../shaders/wind/probe.vert';
import { POSE_TARGETS } from '../core/pack/layout.ts';

/**
 * What a context lacks for posing the tree on the GPU, worst first. All but `none` pose it on the CPU
 * (`core/wind/pose.ts`); `no-webgl2` cannot draw at all.
 */
export type Degradation = 'no-webgl2' | 'few-draw-buffers' | 'no-float-targets' | 'wrong-values' | 'none';

/** What was found by trying it. */
export interface Capabilities {
  readonly webgl2: boolean;
  /** Four RGBA32F textures can be drawn into at once and give back what was drawn. */
  readonly floatTargets: boolean;
  /** How many targets one draw may write; 0 without WebGL2. */
  readonly drawBuffers: number;
  readonly degradation: Degradation;
  /** One sentence for the reader, empty where nothing is missing. */
  readonly reason: string;
}

const REASONS: Record<Degradation, string> = {
  'no-webgl2': 'This browser gives no WebGL2 context, so the tree cannot be drawn.',
  'few-draw-buffers': 'This GPU draws into fewer than four textures at once; the wind is computed on the CPU.',
  'no-float-targets': 'This GPU cannot draw into 32-bit float textures; the wind is computed on the CPU.',
  'wrong-values': 'This GPU gave wrong numbers from a 32-bit float texture; the wind is computed on the CPU.',
  none: '',
};

const TARGETS = Object.keys(POSE_TARGETS).length;

/**
 * Whether `gl` can draw into four RGBA32F textures, found by attaching them, drawing and reading back.
 *
 * Leaves GL state changed: a caller that shares the context resets its own afterwards (`capabilitiesOf` does).
 */
export function probe(gl: WebGL2RenderingContext | null): Capabilities {
  if (!gl) return result('no-webgl2', 0);
  const drawBuffers: number = gl.getParameter(gl.MAX_DRAW_BUFFERS);
  const attachments: number = gl.getParameter(gl.MAX_COLOR_ATTACHMENTS);
  if (Math.min(drawBuffers, attachments) < TARGETS) return result('few-draw-buffers', drawBuffers);
  if (!gl.getExtension('EXT_color_buffer_float')) return result('no-float-targets', drawBuffers);

  const framebuffer = gl.createFramebuffer();
  gl.bindFramebuffer(gl.FRAMEBUFFER, framebuffer);
  const textures = Array.from({ length: TARGETS }, (_, i) => {
    const texture = gl.createTexture();
    gl.bindTexture(gl.TEXTURE_2D, texture);
    gl.texStorage2D(gl.TEXTURE_2D, 1, gl.RGBA32F, 2, 1);
    gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0 + i, gl.TEXTURE_2D, texture, 0);
    return texture;
  });
  const program = link(gl);
  const complete = gl.checkFramebufferStatus(gl.FRAMEBUFFER) === gl.FRAMEBUFFER_COMPLETE;
  const right = complete && program !== null && drawsRight(gl, program);

  gl.bindFramebuffer(gl.FRAMEBUFFER, null);
  gl.deleteFramebuffer(framebuffer);
  for (const texture of textures) gl.deleteTexture(texture);
  gl.deleteProgram(program);
  return result(right ? 'none' : complete ? 'wrong-values' : 'no-float-targets', drawBuffers);
}

/** Draws the two texels and compares the last target with what the shader says, bit for bit. */
function drawsRight(gl: WebGL2RenderingContext, program: WebGLProgram): boolean {
  gl.drawBuffers(Array.from({ length: TARGETS }, (_, i) => gl.COLOR_ATTACHMENT0 + i));
  const array = gl.createVertexArray();
  gl.bindVertexArray(array);
  gl.useProgram(program);
  gl.viewport(0, 0, 2, 1);
  for (const cap of [gl.BLEND, gl.DEPTH_TEST, gl.CULL_FACE, gl.SCISSOR_TEST, gl.STENCIL_TEST]) gl.disable(cap);
  gl.colorMask(true, true, true, true);
  gl.drawArrays(gl.TRIANGLES, 0, 3);
  const read = new Float32Array(8);
  gl.readBuffer(gl.COLOR_ATTACHMENT0 + TARGETS - 1);
  gl.readPixels(0, 0, 2, 1, gl.RGBA, gl.FLOAT, read);
  gl.bindVertexArray(null);
  gl.deleteVertexArray(array);
  gl.useProgram(null);
  const fine = 1 + 2 ** -20;
  return [fine, -70000, 0.5, 3, fine, -70000, 1.5, 3].every((value, i) => value === read[i]);
}

function link(gl: WebGL2RenderingContext): WebGLProgram | null {
  const program = gl.createProgram();
  for (const [type, source] of [
    [gl.VERTEX_SHADER, vertexShader],
    [gl.FRAGMENT_SHADER, fragmentShader],
  ] as const) {
    const shader = gl.createShader(type);
    if (!shader) return null; // a lost context
    gl.shaderSource(shader, source);
    gl.compileShader(shader);
    gl.attachShader(program, shader);
    gl.deleteShader(shader);
  }
  gl.linkProgram(program);
  return gl.getProgramParameter(program, gl.LINK_STATUS) ? program : null;
}

function result(degradation: Degradation, drawBuffers: number): Capabilities {
  return {
    webgl2: degradation !== 'no-webgl2',
    floatTargets: degradation === 'none',
    drawBuffers,
    degradation,
    reason: REASONS[degradation],
  };
}

const known = new WeakMap<WebGLRenderer, Capabilities>();

/** The capabilities of a renderer's own context; probed once, its state reset afterwards. */
export function capabilitiesOf(renderer: WebGLRenderer): Capabilities {
  let found = known.get(renderer);
  if (!found) {
    const target = renderer.getRenderTarget();
    found = probe(renderer.getContext() as WebGL2RenderingContext);
    renderer.resetState();
    renderer.setRenderTarget(target);
    known.set(renderer, found);
  }
  return found;
}

/** The capabilities that a fresh context of this page would have: to ask before a renderer is made, which throws without WebGL2. */
export function probePage(): Capabilities {
  const gl = document.createElement('canvas').getContext('webgl2');
  const found = probe(gl);
  gl?.getExtension('WEBGL_lose_context')?.loseContext(); // browsers allow about sixteen contexts at a time
  return found;
}
