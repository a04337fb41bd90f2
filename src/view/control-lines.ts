import {
  type Box3,
  BufferAttribute,
  Color,
  GLSL3,
  InstancedBufferGeometry,
  LineSegments,
  ShaderMaterial,
  Sphere,
} from 'three';
import fragmentShader from '../../shaders/branch/control.frag';
import vertexShader from '../../shaders/branch/control.vert';
import { layoutGlsl } from '../core/pack/layout-glsl.ts';
import { LEVEL_COLOURS } from './level-colours.ts';
import type { SharedUniforms } from './uniforms.ts';

/** Places along a piece at which its section frame is drawn. */
const FRAMES = [0, 0.5, 1];

/** The control polygon and the section frames of one piece: kind | parameter | end; 3 a vertex. */
function controlSegments(): Float32Array {
  const out: number[] = [];
  // kind 0: corner `parameter` of the polygon. kind 1, 2: T^ and S^ at `parameter`, from the curve (0) to the arrow's end (1).
  for (let edge = 0; edge < 3; edge++) out.push(0, edge, 0, 0, edge + 1, 0);
  for (const v of FRAMES) for (const kind of [1, 2]) out.push(kind, v, 0, kind, v, 1);
  return new Float32Array(out);
}

/** Lines that show what the GPU moves: every piece's control polygon, and its frame at three places, as posed now. */
export function controlLines(shared: SharedUniforms): LineSegments<InstancedBufferGeometry, ShaderMaterial> {
  const geometry = new InstancedBufferGeometry();
  geometry.setAttribute('position', new BufferAttribute(controlSegments(), 3));
  const material = new ShaderMaterial({
    glslVersion: GLSL3,
    vertexShader: `${layoutGlsl()}\n${vertexShader}`,
    fragmentShader,
    transparent: true,
    depthWrite: false,
    uniforms: {
      poseEven: shared.poseEven,
      poseOdd: shared.poseOdd,
      poseLog2Width: shared.poseLog2Width,
      branches: shared.branches,
      branchLog2Width: shared.branchLog2Width,
      levelEnd: { value: [0, 0, 0, 0] },
      levelColours: { value: LEVEL_COLOURS.map((colour) => new Color(colour)) },
      frameSize: { value: 0.1 },
    },
  });
  return new LineSegments(geometry, material);
}

/** Shows the first `count` places of the draw order; `ends` is the last place of each of four levels. */
export function setControlLines(
  lines: LineSegments<InstancedBufferGeometry, ShaderMaterial>,
  count: number,
  ends: readonly number[],
  box: Box3,
): void {
  lines.geometry.instanceCount = count;
  lines.geometry.boundingBox = box.clone();
  lines.geometry.boundingSphere = box.getBoundingSphere(new Sphere());
  const { levelEnd, frameSize } = lines.material.uniforms;
  if (levelEnd) levelEnd.value = [0, 1, 2, 3].map((level) => ends[level] ?? count);
  if (frameSize) frameSize.value = (box.max.z - box.min.z) * 0.007;
}
