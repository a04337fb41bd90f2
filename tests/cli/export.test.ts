import { existsSync, readdirSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { describe, expect, test } from 'vitest';
import { EXPORT_PARAMETERS } from '../../src/core/io/export-options.ts';
import { parseSpecies } from '../../src/core/species/parse.ts';
import { call, scratchFolder } from './call.ts';

const folder = scratchFolder();

/** What makes a small file of each format. */
const SMALL: Readonly<Record<string, string[]>> = {
  glb: ['--levels', '2', '--detail', 'low', '--textures', 'none', '--most-leaves', '100'],
  obj: ['--levels', '2', '--detail', 'low', '--textures', '128', '--most-leaves', '100'],
  swc: ['--levels', '2'],
  species: [],
  channels: ['--levels', '2', '--detail', 'low', '--most-leaves', '100', '--engine', 'unreal'],
};

describe('export', () => {
  test.each([
    ['glb', ['tree-5.glb']],
    ['obj', ['tree-5-bark-colour.png', 'tree-5-bark-normal.png', 'tree-5.mtl', 'tree-5.obj']],
    ['swc', ['tree-5.swc']],
    ['species', ['tree-5.json']],
    ['channels', ['tree-5-axis.png', 'tree-5-pivot.exr', 'tree-5.channels.txt', 'tree-5.glb']],
  ])('writes %s under the name that was asked for, and what it needs beside it', async (format, names) => {
    const out = join(folder, format);
    const ending = { species: 'json', channels: 'glb' }[format] ?? format;
    const args = ['export', 'quaking-aspen', '--seed', '5', '--format', format, '--out', join(out, `tree-5.${ending}`)];
    const { status, out: said, err } = await call(...args, ...(SMALL[format] ?? []));
    expect([status, err]).toEqual([0, '']);
    expect(readdirSync(out).sort()).toEqual(names);
    expect(
      said
        .split('\n')
        .map((line) => line.replace(/: \d+ bytes$/, ''))
        .sort(),
    ).toEqual(names.map((name) => join(out, name)));
  });

  test('takes the format of the ending, and names of its own in a folder', async () => {
    const out = join(folder, 'endings');
    expect((await call('export', 'quaking-aspen', '--out', join(out, 'a.swc'), '--levels', '1')).status).toBe(0);
    expect(readFileSync(join(out, 'a.swc'), 'utf8')).toContain('# Quaking Aspen, seed 1');
    await call('export', 'quaking-aspen', '--seed', '2', '--format', 'swc', '--levels', '1', '--out', `${out}/`);
    expect(readdirSync(out).sort()).toEqual(['a.swc', 'quaking-aspen-2.swc']);
    expect((await call('export', 'quaking-aspen', '--out', join(out, 'b.json'))).status).toBe(0);
    expect(parseSpecies(readFileSync(join(out, 'b.json'), 'utf8')).species?.name).toBe('Quaking Aspen');
  });

  test('writes the same bytes each time', async () => {
    const [a, b] = [join(folder, 'once.glb'), join(folder, 'twice.glb')];
    for (const out of [a, b]) await call('export', 'quaking-aspen', '--out', out, ...SMALL.glb!);
    expect(readFileSync(a).equals(readFileSync(b))).toBe(true);
  });

  test('bakes the wind that it is told', async () => {
    const args = ['--bake', '--bones-to', '1', '--seconds', '1', '--fps', '5', ...SMALL.glb!];
    const files = ['still', 'gale'].map((wind) => join(folder, `${wind}.glb`));
    for (const [i, wind] of ['still', 'gale'].entries())
      expect(await call('export', 'quaking-aspen', '--wind', wind, '--out', files[i]!, ...args)).toMatchObject({
        status: 0,
      });
    expect(readFileSync(files[0]!).equals(readFileSync(files[1]!))).toBe(false);
  });

  test('reads trees of other programs and says what it left out; so do stats and validate', async () => {
    const file = join(folder, 'mine.xml');
    writeFileSync(
      file,
      `<arbaro><species name="Mine"><param name="Levels" value="2"/><param name="Scale" value="4"/>
       <param name="1Branches" value="10"/><param name="1Length" value="0.3"/><param name="Smooth" value="0.5"/></species></arbaro>`,
    );
    const out = join(folder, 'mine.json');
    const exported = await call('export', file, '--out', out);
    expect(exported.err).toContain('Smooth 0.5');
    expect(parseSpecies(readFileSync(out, 'utf8')).species?.name).toBe('Mine');
    const checked = await call('validate', file);
    expect(checked).toMatchObject({ status: 0, err: '' });
    expect(checked.out).toContain(`${file}: a valid tree of Arbaro`);
    expect((await call('stats', file, '--json')).out).toContain('"species": "Mine"');
    writeFileSync(file, '<arbaro><species name="Mine"><param name="Scale" value="tall"/></species></arbaro>');
    for (const command of ['validate', 'stats', 'export'])
      expect(await call(command, file)).toEqual({
        status: 1,
        out: '',
        err: `${file}: Scale: found the text "tall"; allowed: a number.`,
      });
  });

  test.each([
    [[], 'export takes one SPECIES'],
    [
      ['quaking-aspen', '--format', 'fbx'],
      '--format: found the text "fbx"; allowed: glb, obj, swc, species, channels.',
    ],
    [['quaking-aspen', '--detail', 'best'], '--detail: found the text "best"; allowed: "low", "medium", "high".'],
    [
      ['quaking-aspen', '--most-leaves', 'all'],
      '--most-leaves: found the text "all"; allowed: a whole number from 100',
    ],
    [['quaking-aspen', '--format', 'swc', '--bake'], '--bake says nothing for swc: it is read by glb.'],
    [['quaking-aspen', '--fps', '0'], '--fps: found 0; allowed: a whole number from 5 to 60 hertz.'],
    [['quaking-aspen', '--jobs', '2'], 'export takes no --jobs'],
  ])('%j is a wrong call', async (args, message) => {
    const { status, out, err } = await call('export', ...args);
    expect([status, out]).toEqual([2, '']);
    expect(err).toContain(message);
  });

  test('a wind that is not there, and a place that cannot be written, end with a message', async () => {
    expect((await call('export', 'quaking-aspen', '--wind', 'breze')).err).toContain('Did you mean breeze?');
    writeFileSync(join(folder, 'file'), '');
    const { status, err } = await call('export', 'quaking-aspen', '--out', join(folder, 'file', 'a.json'));
    expect([status, err]).toEqual([1, expect.stringMatching(/a\.json: cannot be written \(E[A-Z]+\)\.$/)]);
    expect(existsSync(join(folder, 'file', 'a.json'))).toBe(false);
  });

  test('the help names every option of the table', async () => {
    const { out } = await call('--help');
    for (const { help } of EXPORT_PARAMETERS) expect(out.includes(help) || help.startsWith('What the tree')).toBe(true);
  });
});
