import { TEXEL } from '../../core/pack/layout.ts';
import type { PackedTree } from '../../core/pack/packed.ts';
import type { TextureImages, TextureLayer } from './picture.ts';

type Words = Pick<TextureLayer, 'id' | 'label' | 'unit'>;

/** The pose, in the order of POSE_TARGETS, and the state of the springs, in that of STATE_TARGETS. */
const POSE: readonly Words[] = [
  { id: 'P0', label: 'Foot of the branch x, y, z | across x', unit: 'm' },
  { id: 'P1', label: 'Second control point x, y, z | across y', unit: 'm' },
  { id: 'P2', label: 'Third control point x, y, z | across z', unit: 'm' },
  { id: 'P3', label: 'End of the branch x, y, z | how hard its leaves are shaken', unit: 'm' },
];
const STATE: readonly Words[] = [
  { id: 'Q', label: 'Displacement about T, S | its velocity', unit: '1 | 1/s' },
  { id: 'BASE', label: 'Acceleration of the foot x, y, z | force of the wind', unit: 'm/s² | m' },
  { id: 'END', label: 'Acceleration of the end x, y, z', unit: 'm/s²' },
];

/** A pose (laid out as `restPose.data`), and the springs' state where there is one, as images. */
export function textureImages(packed: PackedTree, pose: Float32Array, state: Float32Array | null): TextureImages {
  const { width, height } = packed.restPose;
  const floats = width * height * TEXEL;
  const layers = (words: readonly Words[], data: Float32Array): TextureLayer[] =>
    words.map((word, i) => ({ ...word, data: data.subarray(i * floats, (i + 1) * floats) }));
  return {
    width,
    height,
    pieceCount: packed.pieceCount,
    layers: [...layers(POSE, pose), ...(state ? layers(STATE, state) : [])],
  };
}
