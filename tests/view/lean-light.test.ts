import { ShaderChunk } from 'three';
import { describe, expect, it } from 'vitest';
import { oneLook } from '../../src/view/lean-light.ts';

describe('one look at a shadow map', () => {
  it('stands in for five of this three, and leaves the rest of its lookup as it is', () => {
    const { instead } = oneLook('defined(LEAN)');
    const [before, after] = instead!.split(
      /\n#if defined\(LEAN\)\nshadow = texture\(shadowMap, shadowCoord\.xyz\);\n#else\n/,
    );
    const [five, rest] = after!.split('\n#endif\n', 1).concat(after!.slice(after!.indexOf('\n#endif\n') + 8));
    expect(five!.match(/vogelDiskSample/g)).toHaveLength(5);
    expect(`${before}${five}${rest}`).toBe(ShaderChunk.shadowmap_pars_fragment);
  });
});
