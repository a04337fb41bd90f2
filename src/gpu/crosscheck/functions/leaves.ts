import swingFragment from '../../../../shaders/debug/check-leaf-swing.frag';
import { leafSwing, leanTowards, turnAlong } from '../../../core/deform/leaf-swing.ts';
import type { Vec3 } from '../../../core/math/vec3.ts';
import type { CheckProgram } from '../program.ts';
import { between, direction } from '../random.ts';

/** The wind that turns leaves: a leaf of any kind, in any wind, pointing anywhere. */
const swing: CheckProgram = {
  name: 'leaf swing',
  fragment: swingFragment,
  layers: 4,
  edges: [
    // Still air; a leaf that does not flutter; one that points into the wind, and one that points along it.
    [0, 0.3, 0.6, 0.5, 0, 0, 1, 0.2, 1, 0, 0, 0, 1, 2, 3],
    [0.5, 0.3, 0.6, 0, 0, 0, 1, 0.2, 1, 0, 0, 0, 1, 2, 3],
    [0.7, 0.9, 0.1, 0.6, -1, 0, 0, 0.9, 1, 0, 0, 0, 1, 2, 3],
    [0.7, 0.9, 0.1, 0.6, 1, 0, 0, 0.9, 1, 0, 0, 0, 1, 2, 3],
  ],
  inputs: (random) => {
    const [x, y] = direction(random);
    const a = direction(random);
    return [
      between(random, 0, 0.9),
      random(),
      random(),
      between(random, 0, 0.7),
      ...direction(random),
      random(),
      x,
      y,
      0,
      0,
      ...a,
    ];
  },
  twin: (given) => {
    const d: Vec3 = [given[4], given[5], given[6]];
    const { sines, lean } = leafSwing(given[0], given[1], given[2], given[3], given[7]);
    const leant = leanTowards(d, [given[8], given[9]], lean);
    return [...sines, lean, 0, ...leant, 0, ...turnAlong([given[12], given[13], given[14]], d, leant), 0];
  },
  lines: [
    { name: 'leafSwing', parts: [0, 1, 2], tolerance: 2e-5, note: 'sine or tangent' },
    { name: 'leanTowards', parts: [4, 5, 6], tolerance: 2e-5, note: 'of a unit vector' },
    { name: 'turnAlong', parts: [8, 9, 10], tolerance: 4e-5, note: 'of a unit vector' },
  ],
};

export const leafPrograms: readonly CheckProgram[] = [swing];
