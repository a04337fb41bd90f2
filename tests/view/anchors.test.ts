import { createRequire } from 'node:module';
import * as newest from 'three';
import { describe, expect, it } from 'vitest';
import { BRANCH_DEPTH, BRANCH_STANDARD } from '../../src/view/branch-shader.ts';
import { FOREST_GRASS_INJECTION } from '../../src/view/forest/forest-meadow.ts';
import { TERRAIN_INJECTION } from '../../src/view/forest/terrain.ts';
import { GROUND_INJECTION } from '../../src/view/ground.ts';
import { type Injection, patched } from '../../src/view/inject.ts';
import { LEAF_DEPTH, LEAF_STANDARD } from '../../src/view/leaf-shader.ts';
import { GRASS_INJECTION } from '../../src/view/meadow.ts';

// The deformer lives in three's own shaders, at lines that three is free to move: this test says so the day it does.
const CASES: readonly [string, keyof typeof newest.ShaderLib, Injection][] = [
  ['branches in the standard material', 'standard', BRANCH_STANDARD],
  ['branches in the physical material', 'physical', BRANCH_STANDARD],
  ['branches in the depth material', 'depth', BRANCH_DEPTH],
  ['branches in the distance material', 'distance', BRANCH_DEPTH],
  ['leaves in the standard material', 'standard', LEAF_STANDARD],
  ['leaves in the depth material', 'depth', LEAF_DEPTH],
  ['leaves in the distance material', 'distance', LEAF_DEPTH],
  ['the ground', 'lambert', GROUND_INJECTION],
  ['the grass', 'lambert', GRASS_INJECTION],
  ["a forest's ground", 'lambert', TERRAIN_INJECTION],
  ["a forest's grass", 'lambert', FOREST_GRASS_INJECTION],
];

const oldest = createRequire(import.meta.url)('three-oldest') as typeof newest;
/** What three called a shader before r182. */
const FORMER: Readonly<Record<string, string>> = { distance: 'distanceRGBA' };

const VERSIONS = [
  ['newest', newest],
  ['oldest', oldest],
] as const;

describe.each(VERSIONS)('anchors in the %s three that is supported', (_, { ShaderChunk, ShaderLib }) => {
  it.each(CASES)('%s', (_, name, { vertex, fragment }) => {
    const shader = ShaderLib[name] ?? (ShaderLib as Record<string, newest.ShaderLibShader>)[FORMER[name] ?? name]!;
    const made = { vertex: patched(shader.vertexShader, vertex), fragment: patched(shader.fragmentShader, fragment) };
    for (const { after, before, instead } of vertex) {
      for (const text of [after, before, instead]) if (text) expect(made.vertex).toContain(text);
    }
    for (const { after } of fragment) if (after) expect(made.fragment).toContain(after);
  });

  it('has the equations of light that the leaves put theirs in place of', () => {
    const chunk = ShaderChunk.lights_physical_pars_fragment;
    for (const name of ['RE_Direct', 'RE_IndirectDiffuse', 'RE_IndirectSpecular'])
      expect(chunk).toMatch(new RegExp(`#define ${name}\\s+${name}_Physical`));
    expect(chunk).toContain('BRDF_GGX( const in vec3 lightDir');
  });
});

describe('anchors', () => {
  it('are two versions, the oldest being the least that the package asks for', () => {
    const { peerDependencies } = createRequire(import.meta.url)(
      '../../package.json',
    ) as typeof import('../../package.json');
    expect(peerDependencies.three).toBe(`>=0.${oldest.REVISION} <1`);
    expect(Number(newest.REVISION)).toBeGreaterThan(Number(oldest.REVISION));
  });

  it('names an anchor that is missing', () => {
    expect(() => patched('void main() {}', [{ anchor: '#include <begin_vertex>' }])).toThrow(
      /<begin_vertex> found 0 times/,
    );
  });
});
