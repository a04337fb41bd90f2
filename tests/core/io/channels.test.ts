import { WebIO } from '@gltf-transform/core';
import { ALL_EXTENSIONS } from '@gltf-transform/extensions';
import { decode } from 'fast-png';
import { describe, expect, test } from 'vitest';
import {
  channelColour,
  hueColour,
  stemChannels,
  swayAt,
  WIND_CHANNELS,
  windAttributes,
} from '../../../src/core/io/channels.ts';
import { DEFAULT_EXPORT, type ExportOptions } from '../../../src/core/io/export-options.ts';
import { exportTree } from '../../../src/core/io/export-tree.ts';
import { halfValue } from '../../../src/core/io/half.ts';
import { INDEX_BIAS, MOST_DEPTH, pivotElements, pivotTexture, pivotUv } from '../../../src/core/io/pivot-painter.ts';
import { growPacked } from '../../../src/core/pack/grow-packed.ts';
import { STILL } from '../../../src/core/wind/wind.ts';
import { shippedSpecies } from '../pack/shipped-species.ts';

const aspen = shippedSpecies('quaking-aspen');
const grown = growPacked(aspen, 1);
const { stems } = grown;
const channels = stemChannels(stems, aspen.wind.stiffness);

/** A tree whose trunk and branches split, so that it has clones of clones. */
const split = growPacked(shippedSpecies('california-black-oak'), 2, { levels: 3 });

const SMALL: ExportOptions = { ...DEFAULT_EXPORT, format: 'channels', detail: 'low', levels: 3, textures: 'none' };

async function exported(engine: ExportOptions['engine']) {
  const files = await exportTree(aspen, 1, STILL, { ...SMALL, mostLeaves: 300, engine }, undefined, { grown });
  const of = (ending: string): Uint8Array<ArrayBuffer> => {
    const file = files.find(({ name }) => name.endsWith(ending));
    if (!file) throw new Error(`${ending} is not among ${files.map(({ name }) => name).join(', ')}`);
    return file.bytes;
  };
  const document = await new WebIO().registerExtensions(ALL_EXTENSIONS).readBinary(of('.glb'));
  const primitives = document
    .getRoot()
    .listMeshes()
    .flatMap((mesh) => mesh.listPrimitives());
  return { files, of, primitives, text: new TextDecoder().decode(of('.channels.txt')) };
}

describe('channels of a stem', () => {
  test('sway from nothing at the foot of the trunk to 1 at the tip that sways most', () => {
    let most = 0;
    for (let i = 0; i < stems.count; i++) most = Math.max(most, swayAt(channels, i, 1));
    expect(swayAt(channels, 0, 0)).toBe(0);
    expect(most).toBeCloseTo(1, 6);
  });

  test('never tear: a stem begins as its parent sways there, clones too', () => {
    const { count, parent, parentZ, clone } = split.stems;
    const table = stemChannels(split.stems, split.tree.species.wind.stiffness);
    let clones = 0;
    for (let i = 0; i < count; i++) {
      const p = parent[i]!;
      if (p < 0) continue;
      clones += clone[i]!;
      const z = clone[i] ? parentZ[i]! : 0;
      expect(swayAt(table, i, z)).toBeCloseTo(swayAt(table, p, parentZ[i]!), 6);
      if (clone[i]) expect(table.phase[i]).toBe(table.phase[p]);
    }
    expect(clones).toBeGreaterThan(10);
  });

  test('sway more towards the tip, and less where the species is stiffer', () => {
    for (let i = 0; i < stems.count; i += 13)
      for (let z = 0.1; z <= 1; z += 0.1) expect(swayAt(channels, i, z)).toBeGreaterThan(swayAt(channels, i, z - 0.1));
    const stiff = stemChannels(stems, [1000, ...aspen.wind.stiffness.slice(1)]);
    expect(swayAt(stiff, 0, 1)).toBeLessThan(0.1 * swayAt(channels, 0, 1));
  });

  test('are colours of 0 to 1 in a preview, which tell neighbours apart', () => {
    const { bounds } = grown.packed;
    for (const channel of WIND_CHANNELS)
      for (let i = 0; i < stems.count; i += 7)
        for (const part of channelColour(channels, channel, i, 0.4, bounds)) {
          expect(part).toBeGreaterThanOrEqual(0);
          expect(part).toBeLessThanOrEqual(1);
        }
    expect([0, 1 / 3, 2 / 3].map((hue) => hueColour(hue).map(Math.round))).toEqual([
      [1, 0, 0],
      [0, 1, 0],
      [0, 0, 1],
    ]);
    const [a, b] = [0, 1].map((i) => channelColour(channels, 'branch', i, 0, bounds));
    expect(Math.max(...a!.map((part, k) => Math.abs(part - b![k]!)))).toBeGreaterThan(0.3);
  });
});

describe('files for an engine', () => {
  test('attributes of our own stand on every vertex of a GLB, and a table has the stems', async () => {
    const { primitives, of, text } = await exported('attributes');
    expect(primitives.length).toBe(3);
    const table = new TextDecoder()
      .decode(of('.stems.csv'))
      .trim()
      .split('\n')
      .slice(1)
      .map((line) => line.split(',').map(Number));
    expect(table).toHaveLength(stems.count);
    for (const primitive of primitives) {
      const [branch, s, phase, pivot, position] = ['_WT_BRANCH', '_WT_S', '_WT_PHASE', '_WT_PIVOT', 'POSITION'].map(
        (name) => {
          const accessor = primitive.getAttribute(name);
          if (!accessor) throw new Error(`${name} is missing`);
          return { count: accessor.getCount(), at: (i: number) => accessor.getElement(i, [] as number[]) };
        },
      );
      expect(new Set([branch, s, phase, pivot].map((each) => each!.count))).toEqual(new Set([position!.count]));
      const leaves = primitive.getMaterial()?.getName() === 'leaves';
      for (let i = 0; i < position!.count; i += 5) {
        const stem = branch!.at(i)[0]!;
        const [, parent, , level, , x, y, z, length] = table[stem]!;
        expect(Number.isInteger(stem) && level! < 3 && parent! < stem).toBe(true);
        expect(s!.at(i)[0]).toBeGreaterThanOrEqual(0);
        expect(s!.at(i)[0]).toBeLessThanOrEqual(1);
        expect(phase!.at(i)[0]).toBeGreaterThanOrEqual(0);
        expect(phase!.at(i)[0]).toBeLessThan(1);
        const own = pivot!.at(i);
        if (!leaves) for (const [k, part] of [x!, y!, z!].entries()) expect(own[k]).toBeCloseTo(part, 3);
        // Nothing is farther from its pivot than the stem is long, bends and thickness aside; a leaf is near its stalk.
        const away = Math.hypot(...position!.at(i).map((part, k) => part - own[k]!));
        expect(away).toBeLessThan(leaves ? 2 : 1.05 * length! + 0.6);
      }
    }
    for (const name of ['_WT_BRANCH', '_WT_S', '_WT_PHASE', '_WT_PIVOT', '.stems.csv', 'quaking-aspen-1.glb'])
      expect(text).toContain(name);
  });

  test('colours for Godot rise with height, and are the sway of the place', async () => {
    const { primitives, text } = await exported('godot');
    const bark = primitives[0]!;
    const [colour, position] = [bark.getAttribute('COLOR_0')!, bark.getAttribute('POSITION')!];
    let high = 0;
    for (let i = 0; i < colour.getCount(); i++) {
      const [r, g, b, a] = colour.getElement(i, [] as number[]);
      for (const part of [r, g, b]) expect(part! >= 0 && part! <= 1).toBe(true);
      expect(a).toBe(1);
      const y = position.getElement(i, [] as number[])[1]!;
      if (y < 1) expect(r).toBeLessThan(0.02);
      if (y > 10) high = Math.max(high, r!);
    }
    expect(high).toBeGreaterThan(0.3);
    expect(text).toContain('COLOR.r');
  });

  test("Unreal's textures lead every vertex to its stem and up to the root", async () => {
    const { primitives, of, text } = await exported('unreal');
    const elements = pivotElements(stems, SMALL.levels);
    const axes = decode(of('-axis.png'));
    expect([axes.width, axes.height, axes.channels, axes.depth]).toEqual([elements.width, elements.height, 4, 8]);
    const pivots = pivotTexture(elements, stems);
    for (const primitive of primitives) {
      const uv = primitive.getAttribute('TEXCOORD_1')!;
      for (let i = 0; i < uv.getCount(); i += 11) {
        const [u, v] = uv.getElement(i, [] as number[]);
        const [x, y] = [u! * elements.width, v! * elements.height];
        expect([x % 1, y % 1]).toEqual([0.5, 0.5]);
        let element = Math.floor(y) * elements.width + Math.floor(x);
        expect(element).toBeLessThan(elements.count);
        let steps = 0;
        for (let p = pivots[4 * element + 3]! - INDEX_BIAS; p !== element; p = pivots[4 * element + 3]! - INDEX_BIAS) {
          element = p;
          steps += 1;
          expect(steps).toBeLessThanOrEqual(MOST_DEPTH);
        }
        expect(stems.parent[elements.stem[element]!]).toBe(-1);
      }
    }
    expect(text).toContain('index + 1024');
  });
});

describe('elements of Pivot Painter', () => {
  test('have their pivots in centimetres and left-handed, and directions and lengths that lead to their tips', () => {
    const elements = pivotElements(stems, 8);
    const pivots = pivotTexture(elements, stems);
    for (let i = 0; i < elements.count; i += 17) {
      const stem = elements.stem[i]!;
      const [x, y, z] = [0, 1, 2].map((k) => stems.base[3 * stem + k]!);
      for (const [k, part] of [100 * x!, -100 * y!, 100 * z!].entries()) {
        const most = Math.max(0.001, Math.abs(part) / 2000);
        expect(Math.abs(halfValue(pivots[4 * i + k]!) - part)).toBeLessThanOrEqual(most);
      }
      const [u, v] = pivotUv(elements, i);
      expect([Math.floor(u * elements.width), Math.floor(v * elements.height)]).toEqual([
        i % elements.width,
        Math.floor(i / elements.width),
      ]);
    }
  });

  test('an index is bits of a half that no hardware takes for nothing or for infinity', () => {
    for (const index of [0, 1, 1023, 1024, 29_999]) {
      const value = halfValue(index + INDEX_BIAS);
      expect(Number.isFinite(value) && Math.abs(value) >= 2 ** -14).toBe(true);
    }
  });

  test('are at most three below a root, with clones of clones; what is more rides on its parent', () => {
    const { count, parent } = split.stems;
    const elements = pivotElements(split.stems, 8);
    expect(elements.count).toBeLessThan(count);
    for (let i = 0; i < count; i++) {
      const element = elements.ofStem[i]!;
      const own = elements.stem[element] === i;
      if (!own) expect(element).toBe(elements.ofStem[parent[i]!]);
      let depth = 0;
      for (let e = element; elements.parent[e] !== e; e = elements.parent[e]!) depth += 1;
      expect(depth).toBeLessThanOrEqual(MOST_DEPTH);
    }
  });

  test('stay below 30 000: deeper levels ride where there are more', () => {
    const twigs = 50_000;
    const table = {
      count: twigs + 2,
      level: Uint8Array.from({ length: twigs + 2 }, (_, i) => Math.min(i, 2)),
      parent: Int32Array.from({ length: twigs + 2 }, (_, i) => Math.min(i, 2) - 1),
    };
    const { count, ofStem, width, height } = pivotElements(table, 8);
    expect([count, ofStem.at(-1), width * height]).toEqual([2, 1, 2]);
  });
});

test('attributes of a mesh without leaves need none', () => {
  const attributes = windAttributes({ vertexCount: 1, piece: [0], v: [0.5] }, grown);
  expect(attributes.map(({ semantic, size }) => [semantic, size])).toEqual([
    ['_WT_BRANCH', 1],
    ['_WT_S', 1],
    ['_WT_PHASE', 1],
    ['_WT_PIVOT', 3],
  ]);
});
