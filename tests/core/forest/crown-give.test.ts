import { expect, test } from 'vitest';
import { crownGive } from '../../../src/core/forest/crown-give.ts';
import { leafPoints } from '../../../src/core/look/leaf-points.ts';
import { growPacked } from '../../../src/core/pack/grow-packed.ts';
import { windStateAt } from '../../../src/core/wind/fade.ts';
import { poseTreePlainly } from '../../../src/core/wind/pose-plainly.ts';
import { DEFAULT_WAVE, STILL } from '../../../src/core/wind/wind.ts';
import { shippedSpecies } from '../pack/shipped-species.ts';

test('a far crown goes where the leaves of its tree go in a steady wind, and a bare one where its branches do', () => {
  const { packed } = growPacked(shippedSpecies('quaking-aspen'), 3);
  const force = 0.5;
  const steady = {
    ...DEFAULT_WAVE,
    amplitude: force,
    direction: 0,
    wavelength: 1e4,
    speed: 0,
    sharpness: 1,
    phase: 0.75,
  };
  const data = poseTreePlainly(packed, windStateAt({ ...STILL, model: 'direct', waves: [steady] }, 0), 'exact');
  const [rest, moved] = [packed, { ...packed, restPose: { ...packed.restPose, data } }].map((tree) =>
    leafPoints(tree, 400),
  );
  const height = packed.bounds[5]!;
  const give = crownGive(packed, height);
  let [gone, expected] = [0, 0];
  for (let i = 0; i < rest!.length; i += 3) {
    gone += moved![i]! - rest![i]!;
    expected += force * give * (rest![i + 2]! / height) ** 2;
  }
  expect(gone).toBeGreaterThan(100);
  expect(Math.abs(expected / gone - 1)).toBeLessThan(0.15);

  expect(crownGive({ ...packed, leafCount: 0 }, height)).toBeGreaterThan(0.5 * give);
});
