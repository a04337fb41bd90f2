import { type ForestSetup, variantOf } from './forest-setup.ts';

/** A shape of a species: a layer of the atlas. */
export interface Shape {
  readonly species: number;
  readonly variant: number;
  readonly layer: number;
  /** Ranks of the trees that have it. */
  readonly ranks: number[];
  state: 'waiting' | 'growing' | 'baking' | 'there' | 'broken';
  /** Part of its trees that has faded in, 0..1. */
  come: number;
  /** How often growing it came to nothing. */
  failures: number;
}

/** How often a shape, or a grove, is asked for: a worker that died may have been short of memory for once. */
export const TRIES = 2;

/** All shapes of a forest with their trees, in the order in which they are grown: one of every species first, so that the whole forest stands soon. */
export function shapesOf(setup: ForestSetup): readonly Shape[] {
  const { variants } = setup;
  const first: number[] = [];
  let layers = 0;
  for (const count of variants) {
    first.push(layers);
    layers += count;
  }
  const byLayer = variants.flatMap((count, species) =>
    Array.from({ length: count }, (_, variant): Shape => {
      const layer = (first[species] as number) + variant;
      return { species, variant, layer, ranks: [], state: 'waiting', come: 0, failures: 0 };
    }),
  );
  const shapes = byLayer.sort((a, b) => a.variant - b.variant || a.species - b.species);
  handOut(shapes, setup);
  return shapes;
}

/** Gives each tree of a forest its shape; those of a shape that is broken take another one. */
export function handOut(shapes: readonly Shape[], setup: ForestSetup): void {
  const { places, mix } = setup;
  const of: Shape[][] = mix.map(() => []);
  for (const shape of shapes) {
    shape.ranks.length = 0;
    (of[shape.species] as Shape[])[shape.variant] = shape;
  }
  for (let i = 0; i < places.count; i++) of[places.species[i] as number]?.[variantOf(setup, i)]?.ranks.push(i);
  for (const shape of shapes) if (shape.state === 'broken') bequeath(shapes, shape);
}

/** Are the shapes of two forests the same? */
export const sameShapes = (a: ForestSetup, b: ForestSetup): boolean =>
  a.document.seed === b.document.seed &&
  a.variants.join() === b.variants.join() &&
  JSON.stringify(a.mix) === JSON.stringify(b.mix);

/** Growing a shape came to nothing: whether it is given up, or else waited for again. */
export function shapeFailed(shape: Shape): boolean {
  shape.failures++;
  shape.state = shape.failures < TRIES ? 'waiting' : 'broken';
  return shape.state === 'broken';
}

/** The trees of a shape take another one of their species, which is returned: null where there is none, so that they are missing. */
export function bequeath(shapes: readonly Shape[], shape: Shape): Shape | null {
  const heir = shapes.find(({ species, state }) => species === shape.species && state !== 'broken');
  if (!heir) return null;
  for (const i of shape.ranks) heir.ranks.push(i);
  shape.ranks.length = 0;
  return heir;
}

/** What the trees of a shape are drawn as: until their own pictures are taken, as the first shape of their species that is there; null: not at all. */
export const shownAs = (shapes: readonly Shape[], shape: Shape): Shape | null =>
  shape.state === 'there'
    ? shape
    : (shapes.find(({ species, state }) => species === shape.species && state === 'there') ?? null);
