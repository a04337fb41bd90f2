import { Object3D, PerspectiveCamera, type WebGLRenderer } from 'three';
import { expect, test } from 'vitest';
import { DEFAULT_FOREST } from '../../../src/core/forest/default-forest.ts';
import { type HeightField, levelField } from '../../../src/core/forest/height-field.ts';
import { mapField } from '../../../src/core/forest/terrain.ts';
import { inSeason } from '../../../src/core/species/season.ts';
import { STILL } from '../../../src/core/wind/wind.ts';
import { FOREST_STEPS } from '../../../src/view/forest/budget.ts';
import { ForestGroves } from '../../../src/view/forest/forest-groves.ts';
import { type ForestSetup, setUpForest } from '../../../src/view/forest/forest-setup.ts';
import {
  bequeath,
  handOut,
  type Shape,
  sameShapes,
  shapeFailed,
  shapesOf,
  shownAs,
} from '../../../src/view/forest/tree-shapes.ts';
import { CellView } from '../../../src/view/forest/view-cells.ts';
import { GroveClient } from '../../../src/worker/grove-client.ts';
import { shippedSpecies } from '../../core/pack/shipped-species.ts';

const species = new Map([['quaking-aspen', shippedSpecies('quaking-aspen')]]);

/** `count` trees of one kind in a row. */
function setUp(count: number, field: HeightField = levelField(100), memory = 1e9): ForestSetup {
  const places = {
    count,
    x: Float32Array.from({ length: count }, (_, i) => i),
    y: new Float32Array(count),
    z: new Float32Array(count),
    turn: new Float32Array(count),
    species: new Uint8Array(count),
    variant: Uint32Array.from({ length: count }, (_, i) => i),
  };
  return setUpForest({ ...DEFAULT_FOREST, size: 100, count }, species, field, places, memory, 3);
}

test('ground that is none is refused with what is wrong in it: one sample, too few heights, NaN', () => {
  const grey = (side: number, value: number) => ({ side, values: new Float32Array(side * side).fill(value) });
  expect(() => setUp(1, mapField(grey(1, 0.5), 100, 0, 50))).toThrow('1 samples a side: at least 2');
  expect(() => setUp(1, mapField(grey(3, Number.NaN), 100, 0, 50))).toThrow('Height 0, 0 of a height field is NaN');
  expect(() => setUp(1, { size: 100, side: 3, heights: new Float32Array(4) })).toThrow('has 4 heights, not 9');
  expect(() => setUp(1, levelField(Number.NaN))).toThrow('NaN m a side');
  expect(() => setUp(1, levelField(100), Number.NaN)).toThrow('memory budget of NaN');
  expect(setUp(0).trees).toEqual([0]);
});

test('a shape that cannot be grown is tried again, and then its trees take another of their species; so do those of the next forest', () => {
  const shapes = shapesOf(setUp(7));
  const ranks = (): number[][] => shapes.map((shape) => [...shape.ranks].sort((a, b) => a - b));
  const [first, second, third] = shapes as [Shape, Shape, Shape];
  expect(ranks()).toEqual([
    [0, 3, 6],
    [1, 4],
    [2, 5],
  ]);
  expect([shapeFailed(first), first.state]).toEqual([false, 'waiting']);
  expect([shapeFailed(first), first.state]).toEqual([true, 'broken']);
  expect(bequeath(shapes, first)).toBe(second);
  expect(ranks()).toEqual([[], [0, 1, 3, 4, 6], [2, 5]]);
  handOut(shapes, setUp(5));
  expect(ranks()).toEqual([[], [0, 1, 3, 4], [2]]);
  second.state = 'broken';
  third.state = 'broken';
  expect(bequeath(shapes, second)).toBeNull();
});

test('until its own pictures are taken a tree shows a shape of its species that is there, and none before the first', () => {
  const shapes = shapesOf(setUp(7));
  const [first, second, third] = shapes as [Shape, Shape, Shape];
  const shown = () => shapes.map((shape) => shownAs(shapes, shape));
  expect(shown()).toEqual([null, null, null]);
  second.state = 'there';
  expect(shown()).toEqual([second, second, second]);
  third.state = 'there';
  expect(shown()).toEqual([second, second, third]);
  expect(shownAs(shapes, { ...first, species: 1 })).toBeNull();
});

test('a forest of more trees has the same shapes, one of another seed or season has not', () => {
  const few = setUp(7);
  expect(sameShapes(few, setUp(20))).toBe(true);
  expect(sameShapes(few, setUp(2))).toBe(false); // fewer shapes
  expect(sameShapes(few, { ...few, document: { ...few.document, seed: 2 } })).toBe(false);
  expect(sameShapes(few, { ...few, mix: [inSeason(few.mix[0]!, 'autumn')] })).toBe(false);
});

/** A client whose every grove ends as `grow` says. */
class Client extends GroveClient {
  asked = 0;
  readonly #grow: () => Promise<never>;
  constructor(grow: () => Promise<never>) {
    super(() => {
      throw new Error('no worker');
    });
    this.#grow = grow;
  }
  override grow() {
    this.asked++;
    return { done: this.#grow(), priority: 0, cancel: () => {} };
  }
}

for (const [what, grow] of [
  ['whose worker dies', () => Promise.reject(new Error('died'))],
  ['that the card refuses', () => Promise.resolve({ packed: null } as never)],
] as const) {
  test(`a grove ${what} is asked for once more, then told of, and the forest still comes to rest`, async () => {
    const told: unknown[] = [];
    const client = new Client(grow);
    const groves = new ForestGroves(
      new Object3D(),
      client,
      () => {},
      () => ({}),
      (error) => told.push(error),
    );
    groves.setForest(setUp(1));
    const camera = new PerspectiveCamera(40, 1, 0.1, 500);
    camera.position.set(0, 5, 20);
    camera.updateMatrixWorld();
    const view = new CellView();
    view.take(camera, new Object3D().matrixWorld, 400);
    for (let frame = 0; frame < 6; frame++) {
      groves.update({
        renderer: {} as WebGLRenderer,
        camera,
        time: 0,
        passed: 16,
        view,
        thresholds: { near: 100, middle: 50 },
        step: FOREST_STEPS[0]!,
        memoryBudget: 1e9,
        wind: STILL,
      });
      await Promise.resolve().then(() => {});
    }
    expect([client.asked, told.length, groves.settled]).toEqual([2, 1, true]);
  });
}
