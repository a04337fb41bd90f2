import { readFileSync } from 'node:fs';
import { describe, expect, it } from 'vitest';
import { PARAMETER_PICTURES, pictureIndex, placeOf } from '../../../docs/parameter-pictures.ts';
import { growPacked } from '../../../src/core/pack/grow-packed.ts';
import { hashPacked } from '../../../src/core/pack/hash-packed.ts';
import {
  editSpecies,
  mayBe,
  type ParameterValue,
  PLACES,
  type SpeciesEdits,
  sameValue,
  valueAt,
} from '../../../src/core/species/edits.ts';
import type { NumberParameter } from '../../../src/core/species/parameter.ts';
import { parseSpecies } from '../../../src/core/species/parse.ts';
import { changedBy } from '../../../src/editor/stem-handles.ts';
import { sliderRange } from '../../../src/editor/ui/tree/comfort.ts';
import { curveOfShape } from '../../../src/editor/ui/tree/crown-editor.ts';
import { envelopeOutline, powerThrough } from '../../../src/editor/ui/tree/envelope-editor.ts';
import { pictureName } from '../../../src/editor/ui/tree/help-pictures.ts';
import { noEffect } from '../../../src/editor/ui/tree/no-effect.ts';
import { allowedText, sourceText } from '../../../src/editor/ui/tree/popover-text.ts';
import { findPlaces, isFound } from '../../../src/editor/ui/tree/search.ts';
import {
  LEVEL_ROWS,
  pathsOfRow,
  pathsOfSection,
  SECTIONS,
  sectionOfPath,
} from '../../../src/editor/ui/tree/sections.ts';
import { grownSize, silhouette } from '../../../src/editor/ui/tree/silhouette.ts';
import { standIn } from '../../../src/editor/ui/tree/stand-in.ts';
import { valueText } from '../../../src/editor/ui/tree/value-text.ts';

const shippedSpecies = (id: string) => parseSpecies(readFileSync(`public/species/${id}.json`, 'utf8')).species!;

const aspen = shippedSpecies('quaking-aspen');
const small: SpeciesEdits = { 'levels.1.branches': 8, 'levels.2.branches': 5, 'leaves.count': 4 };

describe('sections', () => {
  it('hold every place of the table once', () => {
    expect(SECTIONS.flatMap(pathsOfSection).toSorted()).toEqual([...PLACES.keys()].toSorted());
  });

  it('stand in the order in which one builds a tree, a variation beside its value', () => {
    expect(SECTIONS.slice(0, 7).map((s) => s.id)).toEqual([
      'tree',
      'level-0',
      'level-1',
      'level-2',
      'level-3',
      'leaves',
      'pruning',
    ]);
    const rows = SECTIONS.flatMap((s) => s.groups.flatMap((g) => g.rows));
    expect(rows).toContainEqual({ path: 'levels.1.downAngle', variation: 'levels.1.downAngleV' });
    expect(rows).toContainEqual({ path: 'levels.1.curveSideV' });
    expect(sectionOfPath('tree.lobes').id).toBe('level-0');
    const groups = (id: string) => SECTIONS.find((s) => s.id === id)!.groups.map((g) => g.group);
    expect(groups('level-0')).toEqual(['children', 'place', 'curve', 'splits', 'thickness', 'ridges', 'foot']);
    expect(groups('level-2')).toEqual(['children', 'place', 'curve', 'splits', 'thickness', 'ridges']);
  });

  it('side by side: each place of the levels once, in the column of its level', () => {
    const cells = LEVEL_ROWS.flatMap((row) => row.cells.flatMap((cell) => (cell ? pathsOfRow(cell) : [])));
    expect(cells.toSorted()).toEqual(
      SECTIONS.filter((s) => s.level !== undefined)
        .flatMap(pathsOfSection)
        .toSorted(),
    );
    for (const { cells } of LEVEL_ROWS)
      for (const [level, cell] of cells.entries()) if (cell) expect(PLACES.get(cell.path)!.level ?? 0).toBe(level);
  });
});

describe('search', () => {
  it.each([
    ['down angle', 'levels.1.downAngle'],
    ['nDownAngle', 'levels.2.downAngle'],
    ['2downangle', 'levels.2.downAngle'],
    ['limbs down', 'levels.1.downAngle'],
    ['leaves grow on the last', 'tree.levels'],
    ['bark.colour', 'bark.colour'],
    ['maple', 'leaves.shape'],
  ])('%s finds %s', (query, path) => {
    expect(findPlaces(query)).toContain(path);
  });

  it('finds nothing by what stands nowhere, and all by nothing', () => {
    expect(findPlaces('xylophone')).toEqual([]);
    expect(findPlaces(' ')).toHaveLength(PLACES.size);
    expect(isFound('levels.2.downAngle', '1downangle')).toBe(false);
  });

  it('puts those first whose name begins so', () => {
    expect(findPlaces('flare')[0]).toBe('tree.flare');
  });
});

/** Another value that the parameter may have. */
function other(path: string, value: ParameterValue): ParameterValue {
  const { parameter } = PLACES.get(path)!;
  if (parameter.kind === 'flag') return !value;
  if (parameter.kind === 'choice') return parameter.choices.find((c) => c !== value)!;
  if (parameter.kind === 'colour') return value === '#112233' ? '#445566' : '#112233';
  if (parameter.kind === 'numbers') return [0.5, 0.25, 0.75];
  const { min, max, step } = parameter;
  const near = typeof value === 'number' ? value : 0;
  const next = near + 7 * step <= max ? near + 7 * step : near - 7 * step;
  return next >= min && next <= max ? Number(next.toFixed(6)) : near === min ? max : min;
}

const hash = (edits: SpeciesEdits): string =>
  hashPacked(growPacked(editSpecies(aspen, { ...small, ...edits }), 3).packed);

describe('what does nothing', () => {
  const cases: Record<string, SpeciesEdits> = {
    'as it ships': {},
    'without limbs': { 'levels.1.branches': 0 },
    'without leaves': { 'leaves.count': 0 },
    'two levels': { 'tree.levels': 2 },
    'a trunk alone': { 'tree.levels': 1 },
    'with a crown curve': { 'tree.crown': [0.2, 0.6, 0.4] },
    'a helix': { 'levels.1.curveV': -30 },
    'fans of limbs and leaves': { 'levels.1.branches': -5, 'leaves.count': -6 },
    'pruned, split, as printed': { 'pruning.ratio': 1, 'levels.1.segSplits': 0.4, 'switches.paper': true },
    'straight limbs': { 'levels.1.curveRes': 1, 'levels.1.segSplits': 0.5 },
  };
  // What the drawing alone reads is packed all the same, or is not packed at all.
  const drawn = (path: string): boolean =>
    /^(bark|foliage|organ|spring|autumn|winter|wind)\./.test(path) ||
    /\.(lobes|lobeDepth|bulges|bulgeDepth)$/.test(path) ||
    path === 'leaves.shape';

  it.each(Object.entries(cases))('%s: what is said to do nothing leaves the tree as it is', (_name, edits) => {
    const species = editSpecies(aspen, { ...small, ...edits });
    const before = hash(edits);
    const idle = [...PLACES.keys()].filter((path) => !drawn(path) && noEffect(path, species) !== undefined);
    expect(idle.length).toBeGreaterThan(0);
    for (const path of idle) {
      // A level that is not there may be changed only where the file has it.
      expect(hash({ ...edits, [path]: other(path, valueAt(species, path)) }), path).toBe(before);
    }
  });

  it('what is not said to do nothing changes the tree that ships', () => {
    const species = editSpecies(aspen, small);
    const before = hash({});
    const silent = [...PLACES.keys()].filter(
      (path) =>
        !drawn(path) &&
        noEffect(path, species) === undefined &&
        hash({ [path]: other(path, valueAt(species, path)) }) === before,
    );
    // The aspen's own: its flare is drawn, and its level of twigs is there for the leaves' angles alone.
    expect(silent).toEqual([]);
  });

  it('knows that springs alone have a mass', () => {
    expect(noEffect('wind.modulus', aspen, 'direct')).toBe('springsOnly');
    expect(noEffect('wind.modulus', aspen, 'spring')).toBeUndefined();
    expect(noEffect('tree.lobeDepth', editSpecies(aspen, { 'tree.lobes': 0 }))).toBe('noLobes');
    expect(noEffect('foliage.colour', editSpecies(aspen, { 'leaves.count': 0 }))).toBe('noLeaves');
  });
});

describe('what does nothing to the look', () => {
  const bare = { 'organ.kind': 'none', 'spring.organ': null } as const;
  it.each<[string, SpeciesEdits, string | undefined]>([
    ['organ.share', { ...bare, 'autumn.organ': null, 'winter.organ': null }, 'noOrgan'],
    ['organ.share', { ...bare, 'spring.organ': 'blossom' }, undefined],
    ['spring.organSize', bare, 'noOrgan'],
    ['spring.organSize', { 'organ.kind': 'fruit', 'spring.organ': null, 'spring.organSize': 0.5 }, undefined],
    ['spring.organSize', { 'organ.kind': 'fruit', 'spring.organ': 'none' }, 'noOrgan'],
    ['autumn.colour', { 'autumn.cover': 0 }, 'noCover'],
    ['autumn.colour', { 'autumn.cover': 1, 'autumn.colour': '#102030', 'foliage.colour': '#102030' }, 'asSummer'],
    ['autumn.colour', { 'autumn.cover': 1, 'autumn.colour': null }, undefined],
    ['autumn.secondShare', { 'autumn.cover': 1, 'autumn.second': null, 'foliage.second': null }, 'noSecond'],
    ['leaves.shape', { 'foliage.margin': [0, 1, 0] }, 'ownMargin'],
    ['foliage.outline', { 'foliage.margin': [0, 1, 0] }, 'ownMargin'],
    ['levels.1.lobeDepth', { 'levels.1.lobes': 0 }, 'noLobes'],
    ['bark.mossColour', { 'bark.moss': 0 }, 'noMoss'],
    ['bark.mossColour', { 'bark.moss': 0.2 }, undefined],
  ])('%s with %j: %s', (path, edits, why) => {
    expect(noEffect(path, editSpecies(aspen, edits))).toBe(why);
  });

  it('is what stands in for it where it is absent', () => {
    const species = editSpecies(aspen, { 'foliage.cover': 0.7, 'organ.kind': 'cone', 'foliage.second': null });
    expect(standIn(species, 'winter.cover')).toBe(0.7);
    expect(standIn(species, 'winter.organ')).toBe('cone');
    expect(standIn(species, 'winter.second')).toBe(null);
    expect(standIn(species, 'leaves.downAngle')).toBe(species.levels[3]!.downAngle);
    expect([valueText('winter.cover', null), valueText('bark.young', null)]).toEqual(['as in summer', 'none']);
  });
});

describe('sliders', () => {
  const parameter = (path: string) => PLACES.get(path)!.parameter as NumberParameter;

  it('reach what the species has, and never beyond what is allowed', () => {
    for (const id of ['quaking-aspen', 'black-tupelo', 'california-black-oak', 'weeping-willow']) {
      const species = shippedSpecies(id);
      for (const [path, { parameter: p }] of PLACES) {
        const value = valueAt(species, path);
        if (p.kind !== 'number' || typeof value !== 'number') continue;
        const { min, max } = sliderRange(p, [value]);
        expect(min, path).toBeLessThanOrEqual(value);
        expect(max, path).toBeGreaterThanOrEqual(value);
        expect(min, path).toBeGreaterThanOrEqual(p.min);
        expect(max, path).toBeLessThanOrEqual(p.max);
      }
    }
    expect(sliderRange(parameter('levels.3.branches'), [300]).max).toBe(300);
    expect(sliderRange(parameter('levels.1.downAngle'), [-35]).min).toBe(-40);
    expect(sliderRange(parameter('levels.1.downAngle'), [60])).toEqual({ min: 0, max: 150 });
  });

  it('follow a handle of a stem in steps, within what is allowed', () => {
    expect(changedBy(parameter('levels.1.length'), 0.3, { ratio: 1.5 })).toBe(0.45);
    expect(changedBy(parameter('levels.1.downAngle'), 60, { degrees: 12.4 })).toBe(72);
    expect(changedBy(parameter('levels.1.downAngle'), 350, { degrees: 90 })).toBe(360);
  });
});

describe('words', () => {
  it('name values, sources and ranges', () => {
    expect(valueText('levels.1.downAngle', 60)).toBe('60°');
    expect(valueText('tree.scale', 13)).toBe('13.0 m');
    expect(valueText('tree.shape', 0)).toBe('conical');
    expect(valueText('tree.crown', null)).toBe('none');
    expect(sourceText('levels.1.downAngle')).toBe('1DownAngle, Weber & Penn 1995, 4.3');
    expect(allowedText('levels.1.segSplits')).toBe('Allowed: a number from 0 to 8.');
    expect(allowedText('tree.shape')).toMatch(/conical, spherical/);
  });
});

describe('curves', () => {
  it('begin as the crown shape, five lengths from the base to the top', () => {
    expect(curveOfShape(editSpecies(aspen, { 'tree.shape': 0 }))).toEqual([1, 0.8, 0.6, 0.4, 0.2]);
    expect(curveOfShape(editSpecies(aspen, { 'tree.shape': 6 }))).toEqual([0.2, 0.4, 0.6, 0.8, 1]);
  });

  it('the envelope goes through its points', () => {
    const pruning = { ratio: 1, width: 0.4, widthPeak: 0.6, powerLow: 0.5, powerHigh: 2 };
    const outline = envelopeOutline(pruning, 0.2);
    expect(outline[0]![1]).toBeCloseTo(0.2);
    expect(outline.at(-1)![1]).toBeCloseTo(1);
    expect(Math.max(...outline.map(([r]) => r))).toBeLessThanOrEqual(0.4);
    expect(powerThrough(0.5)).toBe(1);
    expect(powerThrough(Math.SQRT1_2)).toBe(0.5);
    expect(powerThrough(0)).toBe(10);
  });

  it('stand over the tree as it was grown', () => {
    const species = editSpecies(aspen, small);
    const grown = growPacked(species, 3);
    expect(grownSize(species, 3).scale).toBeCloseTo(grown.tree.scale, 10);
    const drawn = silhouette(grown.stems, species, 3);
    expect(drawn.top).toBeCloseTo(grown.stats.height / grown.tree.scale, 1);
    expect(drawn.lines.length / 4).toBe(grown.stems.count);
    expect(Math.max(...drawn.reach)).toBeCloseTo(drawn.radius, 5);
  });
});

describe('pictures of parameters', () => {
  it('show two allowed values that do something, one entry a parameter', () => {
    expect(new Set(PARAMETER_PICTURES.map((p) => p.path)).size).toBe(PARAMETER_PICTURES.length);
    for (const picture of PARAMETER_PICTURES) {
      const path = placeOf(picture);
      const species = editSpecies(shippedSpecies(picture.species), picture.edits ?? {});
      for (const value of [picture.low, picture.high]) expect(mayBe(path, value), path).toBe(true);
      for (const [edit, value] of Object.entries(picture.edits ?? {}))
        expect(mayBe(edit, value), `${path}: ${edit}`).toBe(true);
      expect(sameValue(picture.low, picture.high), path).toBe(false);
      const seen = [picture.low, picture.high].some(
        (value) => noEffect(path, editSpecies(species, { [path]: value })) === undefined,
      );
      expect(seen, path).toBe(true);
    }
  });

  it('there are ones of all that can be seen', () => {
    const shown = new Set(PARAMETER_PICTURES.map((p) => p.path));
    const without = [...new Set([...PLACES.keys()].map(pictureName))].filter(
      (path) => !shown.has(path) && !/^(wind|switches)\.|V$/.test(path),
    );
    expect(without).toEqual(['tree.disc']);
    expect(Object.keys(pictureIndex((path) => path === 'tree.flare'))).toEqual(['tree.flare']);
  });
});
