import { describe, expect, it } from 'vitest';
import { insideEnvelope } from '../../../src/core/grow/pruning.ts';
import { treeSize } from '../../../src/core/grow/tree-size.ts';
import { growPacked } from '../../../src/core/pack/grow-packed.ts';
import { envelopeProfile } from '../../../src/view/overlay/envelope.ts';
import { stemEnds } from '../../../src/view/overlay/stem-ends.ts';
import { shippedSpecies } from '../../core/pack/shipped-species.ts';

const willow = shippedSpecies('weeping-willow');
const grown = growPacked(willow, 5, { leaves: false });
const { stems, pieces, packed, tree } = grown;

describe('the places of the handles', () => {
  it('are the first piece, the last, and the one past the middle of each stem', () => {
    for (let stem = 0; stem < stems.count; stem += 37) {
      const { base, middle, tip, parent, down, level } = stemEnds(packed, stems, stem);
      expect(level).toBe(stems.level[stem]);
      expect([base.piece, tip.piece, middle.piece].map((piece) => stems.stemOfPiece[piece])).toEqual([
        stem,
        stem,
        stem,
      ]);
      expect(pieces.next[tip.piece]).toBe(-1);
      const from = tree.stems.zStart[stem]!;
      const z = pieces.span[2 * middle.piece]! * (1 - middle.v) + pieces.span[2 * middle.piece + 1]! * middle.v;
      expect((z - from) / (1 - from)).toBeCloseTo(0.55, 4);
      expect(parent?.piece ?? -1).toBe(pieces.parent[base.piece]);
      expect(down).toBe(stems.clone[stem] === 0);
    }
  });
});

describe('the envelope', () => {
  it('is the one that stems are pruned to, for the size of this very tree', () => {
    const size = treeSize(willow, 5);
    expect(size.scale).toBe(tree.scale);
    const profile = envelopeProfile(willow.pruning, size, 40);
    const shape = { ...willow.pruning, ...size, pruneBase: false };
    let widest = 0;
    for (let i = 1; i < 40; i++) {
      const [radius, height] = [profile[2 * i]!, profile[2 * i + 1]! / size.stretch];
      expect(insideEnvelope(radius * 0.995, 0, height, shape)).toBe(true);
      expect(insideEnvelope(radius * 1.005, 0, height, shape)).toBe(false);
      widest = Math.max(widest, radius);
    }
    expect([profile[1], profile[81]]).toEqual([
      Math.fround(size.stretch * size.scale * size.baseSize),
      Math.fround(size.stretch * size.scale),
    ]);
    expect(widest).toBeCloseTo(willow.pruning.width * size.scale, 1);
  });
});
