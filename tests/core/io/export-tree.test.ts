import { describe, expect, it } from 'vitest';
import { faultText } from '../../../src/core/file/fault.ts';
import {
  DEFAULT_EXPORT,
  EXPORT_FORMATS,
  EXPORT_PARAMETERS,
  exportParametersOf,
  readExportOptions,
} from '../../../src/core/io/export-options.ts';
import { exportTree, fileName } from '../../../src/core/io/export-tree.ts';
import { parseSpecies } from '../../../src/core/species/parse.ts';
import { STILL } from '../../../src/core/wind/wind.ts';
import { SMALL } from '../mesh/small-trees.ts';

describe('the table of the export', () => {
  it('has a row for each option, and each default is one that may be', () => {
    const keys = EXPORT_PARAMETERS.map(({ key }) => key);
    expect(new Set(keys).size).toBe(keys.length);
    expect([...keys, 'link'].sort()).toEqual(Object.keys(DEFAULT_EXPORT).sort());
    expect(readExportOptions({ ...DEFAULT_EXPORT }).options).toEqual(DEFAULT_EXPORT);
  });

  it('shows each format the rows that it reads, never the format itself', () => {
    expect(exportParametersOf('glb').map(({ key }) => key)).toContain('boneLevels');
    expect(exportParametersOf('swc').map(({ key }) => key)).toEqual(['levels']);
    expect(exportParametersOf('species')).toEqual([]);
  });

  it('says of each wrong option what it may be', () => {
    const { faults } = readExportOptions({ format: 'fbx', seconds: 0, clip: 'yes', colour: 1 });
    expect(faults?.map(faultText)).toEqual([
      expect.stringMatching(/^format: found the text "fbx"; allowed: "glb"/),
      expect.stringMatching(/^seconds: found 0; allowed: a number from 1 to 60 seconds/),
      expect.stringMatching(/^clip: .*true or false/),
      expect.stringMatching(/^colour: found 1; allowed: format, detail/),
    ]);
  });
});

describe('an export', () => {
  it('as a species gives a file that is read as the same species', async () => {
    const [file] = await exportTree(SMALL.aspen, 1, STILL, { ...DEFAULT_EXPORT, format: 'species' });
    expect(file.name).toBe('quaking-aspen-1.json');
    expect(parseSpecies(new TextDecoder().decode(file.bytes)).species).toEqual(SMALL.aspen);
  });

  it.each(EXPORT_FORMATS)('as %s tells how far it is, never less than before, to the end', async (format) => {
    const told: number[] = [];
    const options = { ...DEFAULT_EXPORT, format, textures: 'none' } as const;
    const files = await exportTree(SMALL.aspen, 1, STILL, options, (_, done) => told.push(done));
    expect(files.length).toBeGreaterThan(0);
    expect(files.every(({ bytes }) => bytes.length > 0)).toBe(true);
    expect(told).toEqual([...told].sort((a, b) => a - b));
    expect(told.at(-1)).toBe(1);
  });

  it('ends when the one who is told throws', async () => {
    const stop = () => {
      throw new Error('enough');
    };
    await expect(exportTree(SMALL.aspen, 1, STILL, DEFAULT_EXPORT, stop)).rejects.toThrow('enough');
  });

  it.each([
    ['Quaking Aspen', 'quaking-aspen-7'],
    ['Étoile / ../x', 'etoile-x-7'],
    ['  ', 'tree-7'],
    ['柳', '柳-7'],
  ])('names the file of "%s" %s', (name, file) => {
    expect(fileName(name, 7)).toBe(file);
  });
});
