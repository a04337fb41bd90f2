import { expect, it } from 'vitest';
import {
  BRANCH_LAYERS,
  LEAF_LAYERS,
  MECHANICS,
  MECHANICS_SIZE,
  PIECE_LAYERS,
  POSE_TARGETS,
  SPRING_LAYERS,
  STATE_TARGETS,
  SWAY_LAYERS,
  TREE_LAYERS,
} from '../../../src/core/pack/layout.ts';
import { layoutGlsl } from '../../../src/core/pack/layout-glsl.ts';

it('states every layer of the tables as a GLSL constant', () => {
  const glsl = layoutGlsl();
  const stated = [...glsl.matchAll(/const int (\w+) = (\d+);/g)].map(([, name, value]) => [name, Number(value)]);
  expect(Object.fromEntries(stated)).toMatchObject({
    PIECE_ATTACH: PIECE_LAYERS.ATTACH,
    PIECE_TIP: PIECE_LAYERS.TIP,
    BRANCH_SPAN: BRANCH_LAYERS.SPAN,
    BRANCH_STEM: BRANCH_LAYERS.STEM,
    BRANCH_JOINT: BRANCH_LAYERS.JOINT,
    LEAF_LEAF: LEAF_LAYERS.LEAF,
    POSE_P3: POSE_TARGETS.P3,
    SPRING_LOAD: SPRING_LAYERS.LOAD,
    STATE_END: STATE_TARGETS.END,
    SWAY_OFFSET: SWAY_LAYERS.OFFSET,
    TREE_TURN: TREE_LAYERS.TURN,
  });
  expect(stated).toHaveLength(5 + 3 + 1 + 4 + 3 + 3 + 2 + 4);
  expect(glsl).toContain('ivec3 texelAt(int index, int log2Width, int layer)');
});

it('numbers the layers of each table from 0 without a gap', () => {
  for (const table of [
    PIECE_LAYERS,
    BRANCH_LAYERS,
    LEAF_LAYERS,
    POSE_TARGETS,
    SPRING_LAYERS,
    STATE_TARGETS,
    SWAY_LAYERS,
    TREE_LAYERS,
    MECHANICS,
  ]) {
    expect(Object.values(table)).toEqual(Object.keys(table).map((_, i) => i));
  }
  expect(Object.keys(MECHANICS)).toHaveLength(MECHANICS_SIZE);
});
