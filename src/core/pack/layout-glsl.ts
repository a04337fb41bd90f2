import {
  BRANCH_LAYERS,
  LEAF_LAYERS,
  PIECE_LAYERS,
  POSE_TARGETS,
  SPRING_LAYERS,
  STATE_TARGETS,
  SWAY_LAYERS,
  TREE_LAYERS,
} from './layout.ts';

const TABLES = {
  PIECE: PIECE_LAYERS,
  BRANCH: BRANCH_LAYERS,
  LEAF: LEAF_LAYERS,
  POSE: POSE_TARGETS,
  SPRING: SPRING_LAYERS,
  STATE: STATE_TARGETS,
  SWAY: SWAY_LAYERS,
  TREE: TREE_LAYERS,
};

/**
 * The layouts as GLSL: `const int PIECE_ATTACH = 0;` and so on for every layer and pose target, and `texelAt`, the texel of
 * a thing in a layer of a texture array whose width is 2^log2Width. Goes in front of any shader that reads a tree; GLSL ES 3.00.
 */
export function layoutGlsl(): string {
  const constants = Object.entries(TABLES).flatMap(([table, layers]) =>
    Object.entries(layers).map(([layer, index]) => `const int ${table}_${layer} = ${index};`),
  );
  return [
    '#ifndef WINDGROVE_LAYOUT',
    '#define WINDGROVE_LAYOUT',
    ...constants,
    'ivec3 texelAt(int index, int log2Width, int layer) {',
    '  return ivec3(index & ((1 << log2Width) - 1), index >> log2Width, layer);',
    '}',
    '#endif',
    '',
  ].join('\n');
}
