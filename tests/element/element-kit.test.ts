import { ShaderChunk } from 'three';
import { expect, test } from 'vitest';
import { BARK_KINDS } from '../../src/core/species/species.ts';
import { elementKit } from '../../src/element/element-kit.ts';
import { barkDefines } from '../../src/view/bark-look.ts';
import { BRANCH_STANDARD } from '../../src/view/branch-shader.ts';
import { patched } from '../../src/view/inject.ts';
import { shippedSpecies } from '../core/pack/shipped-species.ts';

const knows = (name: string): boolean =>
  patched(ShaderChunk.meshphysical_frag, BRANCH_STANDARD.fragment).includes(`#ifdef ${name}\n#define BARK_OWN`);

test('bark of a kind comes with what its shader has for that kind alone, and no other bark with it', async () => {
  const aspen = shippedSpecies('quaking-aspen');
  const dressed = (kind: (typeof BARK_KINDS)[number]) => ({ ...aspen, bark: { ...aspen.bark, kind } });
  const own = (kind: (typeof BARK_KINDS)[number]): string[] =>
    barkDefines(0, dressed(kind), 'tube').filter((name) => /FOOT|SPINED|BLOOM/.test(name));
  const plain = BARK_KINDS.filter((kind) => own(kind).length === 0);
  expect(plain).toHaveLength(BARK_KINDS.length - 3);
  for (const kind of plain) await elementKit.load(dressed(kind));
  expect(['BARK_FOOT', 'BARK_SPINED', 'BARK_BLOOM'].filter(knows)).toEqual([]);
  for (const kind of BARK_KINDS) {
    await elementKit.load(dressed(kind));
    expect(own(kind).filter((name) => !knows(name))).toEqual([]);
  }
});
