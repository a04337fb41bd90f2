import { describe, expect, test } from 'vitest';
import { newFrame, turnX, turnZ } from '../../src/core/grow/frame.ts';
import { grow } from '../../src/core/grow/grow.ts';
import { leafBend } from '../../src/core/grow/leaf-bend.ts';
import { treeStats } from '../../src/core/grow/stats.ts';
import { decodeLink } from '../../src/core/link/decode.ts';
import { leafPrefixes, STEM_FORM } from '../../src/core/lod/draw-counts.ts';
import { fractions } from '../../src/core/lod/fractions.ts';
import { parseSpecies } from '../../src/core/species/parse.ts';
import { STILL } from '../../src/core/wind/wind.ts';
import { firstDocument } from '../../src/editor/first-document.ts';
import { changedSpecies, editorLink } from '../../src/learn/weber-penn/changed-species.ts';
import { printedDeltas, printedEnvelope, printedLeafBend } from '../../src/learn/weber-penn/printed.ts';
import { textOf } from '../house/tree-files.ts';

const defaults = firstDocument('auto', false, { ...STILL, name: 'Breeze' });
const shipped = (JSON.parse(textOf('public/species/index.json')) as { id: string }[]).map(({ id }) => id);
const read = (link: string) => decodeLink(link, { defaults, species: shipped, winds: {} });

const speciesOf = (id: string) => parseSpecies(textOf(`public/species/${id}.json`)).species!;

describe('lesson: growing a tree', () => {
  const html = textOf('learn/weber-penn.html');

  test('the measured numbers of the aspen are those that grow', () => {
    const still = changedSpecies(speciesOf('quaking-aspen'), {
      tree: { scaleV: 0 },
      levels: { 0: { curveV: 0 }, 1: { curveV: 0 }, 2: { curveV: 0, downAngleV: 0 } },
    });
    const rows = Array.from({ length: 20 }, (_, i) => {
      const { levels, leaves } = treeStats(grow(still, i + 1));
      const [trunk, main, twigs] = levels as [(typeof levels)[0], (typeof levels)[0], (typeof levels)[0]];
      return {
        main: main.stems,
        twigs: twigs.stems,
        leaves,
        length: main.length.mean / trunk.length.mean,
        radius: main.baseRadius.mean / trunk.baseRadius.mean,
        down: main.declinationDeg.mean,
        perBranch: twigs.stems / main.stems,
        perTwig: leaves / twigs.stems,
      };
    });
    const said = [...html.matchAll(/data-measure="(\w+)">([\d.]+)</g)];
    expect(said).toHaveLength(8);
    for (const [, name, text] of said) {
      const mean = rows.reduce((all, row) => all + row[name as keyof typeof row], 0) / rows.length;
      const digits = text!.split('.')[1]?.length ?? 0;
      expect(mean.toFixed(digits), name).toBe(text);
    }
  });

  test('the table of the four trees says what their files say', () => {
    const cells = [...html.matchAll(/data-of="([\w-]+)" data-path="([\w.]+)">([-\d.]+)</g)];
    expect(cells.length).toBeGreaterThan(20);
    for (const [, id, path, text] of cells) {
      const value = path!.split('.').reduce<unknown>((at, key) => (at as Record<string, unknown>)[key], speciesOf(id!));
      expect(Number(text), `${id} ${path}`).toBe(value);
    }
  });

  test('the printed forms fail as the text says: 106.7 degrees, a ledge, blades that do not lie flat', () => {
    expect(printedDeltas(40, 80, 3).reduce((a, b) => a + b)).toBeCloseTo(106.667, 3);
    expect(printedEnvelope(0.4, { widthPeak: 0.6, powerLow: 0.5, powerHigh: 0.5 })).toBeCloseTo(1.2247, 4);
    const bent = (form: typeof leafBend): number => {
      const f = newFrame();
      turnZ(f, 0.7);
      turnX(f, 1.1);
      form(f, 0.4, -0.3, 1);
      return f[5]!;
    };
    expect(bent(leafBend)).toBeCloseTo(1, 9);
    expect(bent(printedLeafBend)).toBeLessThan(0.99);
  });

  test('"Open in editor" is a link that the editor reads without a fault', () => {
    const link = editorLink('quaking-aspen', { tree: { baseSize: 0.2 }, levels: { 1: { downAngle: 25 } } });
    const { document, faults } = read(link);
    expect(faults).toEqual([]);
    expect(document.species).toBe('quaking-aspen');
    expect(document.edits).toEqual({ 'tree.baseSize': 0.2, 'levels.1.downAngle': 25 });
  });

  test('the links in its text are read likewise', () => {
    const links = [...html.matchAll(/href="\.\.\/index\.html#([^"]+)"/g)].map(([, hash]) =>
      hash!.replaceAll('&amp;', '&'),
    );
    expect(links.length).toBeGreaterThan(4);
    for (const link of links) expect(read(link).faults, link).toEqual([]);
  });
});

describe('lesson: degradation at range', () => {
  test('the measured numbers are those of the formulas', () => {
    const html = textOf('learn/range.html');
    const said = [...html.matchAll(/data-row="(\w+)" data-range="(\d+)">(\d+)</g)];
    expect(said.length).toBeGreaterThan(8);
    for (const [, row, range, text] of said) {
      const f = fractions(Number(range));
      const leaves = leafPrefixes(13_312, f);
      const value = {
        trunkTriangles: 2 * STEM_FORM.trunk.bands * STEM_FORM.trunk.sectors * f.trunk.polygons,
        mainLines: 30 * STEM_FORM.main.lines * f.main.thin,
        otherLines: 739 * STEM_FORM.other.lines * f.other.thin,
        leafTriangles: 4 * leaves.polygons,
        leafPoints: leaves.points,
      }[row!];
      expect(value?.toFixed(0), `${row} at ${range}`).toBe(text);
    }
  });
});
