import { readdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { describe, expect, test } from 'vitest';
import { parseSpecies } from '../../../src/core/species/parse.ts';
import { folder, names, shipped } from '../grow/species.ts';

/** The appendix of Weber & Penn 1995, line by line; the columns are aspen, tupelo, willow, oak. */
const PRINTED: readonly [paths: string, ...columns: number[][]][] = [
  ['tree.shape', [7], [4], [3], [2]],
  ['tree.baseSize', [0.4], [0.2], [0.05], [0.05]],
  ['tree.scale tree.scaleV tree.zScale tree.zScaleV', [13, 3, 1, 0], [23, 5, 1, 0], [15, 5, 1, 0], [10, 10, 1, 0]],
  ['tree.levels', [3], [4], [4], [3]],
  ['tree.ratio tree.ratioPower', [0.015, 1.2], [0.015, 1.3], [0.03, 2], [0.018, 1.3]],
  ['tree.lobes tree.lobeDepth', [5, 0.07], [3, 0.1], [9, 0.03], [5, 0.1]],
  ['tree.flare', [0.6], [1], [0.75], [1.2]],
  ['0.scale 0.scaleV', [1, 0], [1, 0], [1, 0], [1, 0]],
  ['0.length 0.lengthV 0.taper', [1, 0, 1], [1, 0, 1.1], [0.8, 0, 1], [1, 0, 0.95]],
  ['0.baseSplits', [0], [0], [2], [2]],
  ['0.segSplits 0.splitAngle 0.splitAngleV', [0, 0, 0], [0, 0, 0], [0.1, 3, 0], [0.4, 10, 0]],
  ['0.curveRes 0.curve 0.curveBack 0.curveV', [3, 0, 0, 20], [10, 0, 0, 40], [8, 0, 20, 120], [8, 0, 0, 90]],
  ['1.downAngle 1.downAngleV', [60, -50], [60, -40], [20, 10], [30, -30]],
  ['1.rotate 1.rotateV 1.branches', [140, 0, 50], [140, 0, 50], [-120, 30, 25], [80, 0, 40]],
  ['1.length 1.lengthV 1.taper', [0.3, 0, 1], [0.3, 0.05, 1], [0.5, 0.1, 1], [0.8, 0.1, 1]],
  ['1.segSplits 1.splitAngle 1.splitAngleV', [0, 0, 0], [0, 0, 0], [0.2, 30, 10], [0.2, 10, 10]],
  ['1.curveRes 1.curve 1.curveBack 1.curveV', [5, -40, 0, 50], [10, 0, 0, 90], [16, 40, 80, 90], [10, 40, -70, 150]],
  ['2.downAngle 2.downAngleV', [45, 10], [30, 10], [30, 10], [45, 10]],
  ['2.rotate 2.rotateV 2.branches', [140, 0, 30], [140, 0, 25], [-120, 30, 10], [140, 0, 120]],
  ['2.length 2.lengthV 2.taper', [0.6, 0, 1], [0.6, 0.1, 1], [1.5, 0, 1], [0.2, 0.05, 1]],
  ['2.segSplits 2.splitAngle 2.splitAngleV', [0, 0, 0], [0, 0, 0], [0.2, 45, 20], [0.1, 10, 10]],
  ['2.curveRes 2.curve 2.curveBack 2.curveV', [3, -40, 0, 75], [10, -10, 0, 150], [12, 0, 0, 0], [3, 0, 0, -30]],
  ['3.downAngle 3.downAngleV', [45, 10], [45, 10], [20, 10], [45, 10]],
  ['3.rotate 3.rotateV 3.branches', [77, 0, 10], [140, 0, 12], [140, 0, 300], [140, 0, 0]],
  ['3.length 3.lengthV 3.taper', [0, 0, 1], [0.4, 0, 1], [0.1, 0, 1], [0.4, 0, 1]],
  ['3.segSplits 3.splitAngle 3.splitAngleV', [0, 0, 0], [0, 0, 0], [0, 0, 0], [0, 0, 0]],
  ['3.curveRes 3.curve 3.curveBack 3.curveV', [1, 0, 0, 0], [1, 0, 0, 0], [1, 0, 0, 0], [1, 0, 0, 0]],
  ['leaves.count leaves.shape', [25, 0], [6, 0], [15, 0], [25, 0]],
  ['leaves.scale leaves.scaleX', [0.17, 1], [0.3, 0.5], [0.12, 0.2], [0.12, 0.66]],
  ['tree.attractionUp', [0.5], [0.5], [-3], [0.8]],
  ['pruning.ratio', [0], [0], [1], [0]],
  ['pruning.width pruning.widthPeak', [0.5, 0.5], [0.5, 0.5], [0.4, 0.6], [0.5, 0.5]],
  ['pruning.powerLow pruning.powerHigh', [0.5, 0.5], [0.5, 0.5], [0.001, 0.5], [0.5, 0.5]],
];

describe.each(names.map((name, column) => ({ name, column })))('$name', ({ name, column }) => {
  test('has exactly the printed values', () => {
    const species = shipped(name);
    for (const [paths, ...columns] of PRINTED) {
      const found = paths.split(' ').map((path) => {
        const [group, key] = path.split('.');
        const part = /^\d$/.test(group) ? species.levels[Number(group)] : species[group as 'tree'];
        return (part as unknown as Record<string, number>)[key];
      });
      expect(found, paths).toEqual(columns[column]);
    }
  });
});

test('the index lists every shipped species with the names in its file', () => {
  const index = JSON.parse(readFileSync(join(folder, 'index.json'), 'utf8'));
  const files = readdirSync(folder).filter((file) => /^(?!index|species\.schema).*\.json$/.test(file));
  expect(index.map((entry: { file: string }) => entry.file).sort()).toEqual(files.sort());
  expect(index.slice(0, names.length).map(({ id }: { id: string }) => id)).toEqual(names);
  for (const { id, name, latin, file } of index) {
    expect(file).toBe(`${id}.json`);
    expect(parseSpecies(readFileSync(join(folder, file), 'utf8')).species).toMatchObject({ name, latin });
  }
});
