import type { Camera, Object3D, WebGLRenderer } from 'three';
import { Vector3, Vector4 } from 'three';
import type { GroveClient, GroveTicket } from '../../worker/grove-client.ts';
import { isAborted } from '../../worker/grove-client.ts';
import type { ForceField } from '../force-field.ts';
import { ClumpPictures } from './card-bake.ts';
import { variantSeed } from './forest-plan.ts';
import type { ForestSetup } from './forest-setup.ts';
import type { ShadeTree } from './ground-shade.ts';
import { type AtlasOptions, ImpostorAtlas } from './impostor-atlas.ts';
import { ImpostorBaker } from './impostor-bake.ts';
import { Impostors } from './impostors.ts';
import { bequeath, handOut, type Shape, sameShapes, shapeFailed, shapesOf, shownAs } from './tree-shapes.ts';

/** Seconds in which trees come whose pictures have just been taken. */
const FADE = 0.5;
/** Shapes that are asked of the worker ahead of the one whose pictures are taken. */
const AHEAD = 2;

/** All trees of a forest as pictures of themselves: grown, photographed and shown before anything else, and there for good. */
export class FarTrees {
  readonly fade = {
    forestEye: { value: new Vector3() },
    forestScale: { value: 1 },
    forestFade: { value: new Vector4(-1, 0, 1e9, 2e9) },
  };
  /** Mean force of the wind, metres. */
  readonly meanForce = { value: 1 };
  readonly #parent: Object3D;
  readonly #client: GroveClient;
  readonly #field: ForceField;
  readonly #pictures: Omit<AtlasOptions, 'layers'>;
  readonly #failed: (error: unknown) => void;
  #setup: ForestSetup | null = null;
  #baker: ImpostorBaker | null = null;
  #impostors: Impostors | null = null;
  #clumps: ClumpPictures | null = null;
  #shapes: readonly Shape[] = [];
  /** Species whose clumps are asked for. */
  readonly #clumped = new Set<number>();
  #tickets = new Set<GroveTicket>();
  /** Of each tree: part that has come, and part that a finer class has. */
  #own = new Float32Array(0);
  #nearer = new Float32Array(0);

  /** `parent`: an object in forest space (z up); `field`: the wind there; `failed` is told why a shape cannot be grown. */
  constructor(
    parent: Object3D,
    client: GroveClient,
    field: ForceField,
    pictures: Omit<AtlasOptions, 'layers'>,
    failed: (error: unknown) => void,
  ) {
    this.#parent = parent;
    this.#client = client;
    this.#field = field;
    this.#pictures = pictures;
    this.#failed = failed;
  }

  /** Takes another forest. One of the same shapes, however many trees have them and wherever those stand, shows what is there already. */
  setForest(setup: ForestSetup | null): void {
    if (setup && setup.places.count > 0 && this.#setup && sameShapes(setup, this.#setup)) {
      this.#replant(setup);
      return;
    }
    this.clear();
    this.#setup = setup;
    if (!setup || setup.places.count === 0) return;
    const { places, variants } = setup;
    this.#shapes = shapesOf(setup);
    const layers = this.#shapes.length;
    this.#baker = new ImpostorBaker(new ImpostorAtlas({ ...this.#pictures, layers }));
    this.#clumps = new ClumpPictures(variants.length);
    this.#own = new Float32Array(places.count);
    this.#nearer = new Float32Array(places.count);
    this.#impostors = new Impostors(this.#baker.atlas, this.#field, this.fade, this.meanForce);
    this.#parent.add(this.#impostors);
    this.#place();
  }

  /** Sets other trees out in the shapes that there are. */
  #replant(setup: ForestSetup): void {
    this.#setup = setup;
    handOut(this.#shapes, setup);
    this.#own = new Float32Array(setup.places.count);
    this.#nearer = new Float32Array(setup.places.count);
    this.#place();
  }

  /** Goes on with what is not there yet, for about `ms` milliseconds; `passed`: milliseconds since the last time. */
  update(renderer: WebGLRenderer, camera: Camera, passed: number, ms: number): void {
    const baker = this.#baker;
    const impostors = this.#impostors;
    if (!baker || !impostors) return;
    this.#ask();
    if (!baker.idle) {
      baker.bakeSome(renderer, ms);
      for (const shape of this.#shapes) {
        if (shape.state === 'baking' && baker.ready(shape.layer)) this.#arrive(shape);
      }
      // Now it is known how large they are.
      if (baker.idle && this.grown) this.#place();
    } else this.#clumps?.bakeSome(renderer, ms);
    for (const shape of this.#shapes) {
      if (shape.state !== 'there' || shape.come >= 1) continue;
      shape.come = Math.min(1, shape.come + passed / (1000 * FADE));
      for (const other of this.#shapes) if (shownAs(this.#shapes, other) === shape) this.#show(other);
    }
    impostors.update(camera);
  }

  /** Says how much of trees a finer class has. */
  readonly taken = (ranks: readonly number[], taken: number): void => {
    for (const i of ranks) {
      if (this.#nearer[i] === taken) continue;
      this.#nearer[i] = taken;
      this.#impostors?.setThere(i, this.#own[i] as number, taken);
    }
  };

  /** Pictures of a species' clumps, for the cards of middle trees; null until they are taken. Layer: its index in the mix. */
  clumps(species: number): ClumpPictures | null {
    return this.#clumps?.ready(species) ? this.#clumps : null;
  }

  /** Part of the shapes that are there, 0..1. */
  get progress(): number {
    const all = this.#shapes.length;
    return all === 0 ? 1 : this.#shapes.filter(({ state }) => state === 'there' || state === 'broken').length / all;
  }

  /** Has every shape been grown? Not all need be photographed yet. */
  get grown(): boolean {
    return this.#shapes.every(({ state }) => state !== 'waiting' && state !== 'growing');
  }

  get settled(): boolean {
    const shown = this.#shapes.every(({ state, come }) => state === 'broken' || (state === 'there' && come >= 1));
    return shown && (this.#clumps?.idle ?? true);
  }

  get drawn(): number {
    return this.#impostors?.visible ? this.#impostors.drawn : 0;
  }

  get bytes(): number {
    return (this.#baker?.atlas.bytes ?? 0) + (this.#clumps?.atlas.bytes ?? 0) + (this.#impostors?.bytes ?? 0);
  }

  /** The crowns of all trees whose shapes are known. */
  crowns(): ShadeTree[] {
    const setup = this.#setup;
    const atlas = this.#baker?.atlas;
    if (!setup || !atlas) return [];
    const { places, feet, mix } = setup;
    const crowns: ShadeTree[] = [];
    for (const shape of this.#shapes) {
      const { species, ranks } = shape;
      const shown = shownAs(this.#shapes, shape);
      const crown = shown && atlas.facts(shown.layer)?.crown;
      if (!crown) continue;
      const [cx, cy, cz, rx, ry, rz] = Array.from(crown) as [number, number, number, number, number, number];
      const cover = mix[species]?.foliage.cover ?? 1;
      for (const i of ranks) {
        const turn = places.turn[i] as number;
        const [cos, sin] = [Math.cos(turn), Math.sin(turn)];
        crowns.push({
          x: (places.x[i] as number) + cos * cx - sin * cy,
          y: (places.y[i] as number) + sin * cx + cos * cy,
          z: (feet[i] as number) + cz,
          wide: 0.5 * (rx + ry),
          high: rz,
          dense: 0.25 + 0.65 * cover,
        });
      }
    }
    return crowns;
  }

  clear(): void {
    for (const ticket of this.#tickets) ticket.cancel();
    this.#tickets.clear();
    this.#impostors?.removeFromParent();
    this.#impostors?.dispose();
    this.#impostors = null;
    this.#baker?.dispose();
    this.#baker?.atlas.dispose();
    this.#baker = null;
    this.#clumps?.dispose();
    this.#clumps = null;
    this.#shapes = [];
    this.#clumped.clear();
    this.#setup = null;
  }

  /** Has the worker grow what is to be photographed next. */
  #ask(): void {
    const setup = this.#setup;
    const busy = this.#shapes.filter(({ state }) => state === 'growing' || state === 'baking').length;
    if (!setup || busy >= AHEAD) return;
    const shape = this.#shapes.find(({ state }) => state === 'waiting');
    const species = shape && setup.mix[shape.species];
    if (!shape || !species) return;
    shape.state = 'growing';
    const seed = variantSeed(setup.document, shape.species, shape.variant);
    const request = { species, members: [{ seed, x: 0, y: 0, z: 0, turn: 0 }], form: 'full' } as const;
    // Before all groves.
    const ticket = this.#client.grow(request, Number.NEGATIVE_INFINITY);
    this.#tickets.add(ticket);
    ticket.done.then(
      ({ packed }) => {
        if (!this.#tickets.delete(ticket)) return;
        shape.state = 'baking';
        this.#baker?.bake(shape.layer, packed, species);
        if (this.#clumped.has(shape.species)) return;
        this.#clumped.add(shape.species);
        this.#clumps?.bake(shape.species, packed, species);
      },
      (error: unknown) => {
        if (!this.#tickets.delete(ticket) || isAborted(error)) return;
        if (!shapeFailed(shape)) return;
        this.#failed(error);
        const heir = bequeath(this.#shapes, shape);
        if (heir) this.#place();
      },
    );
  }

  /** Sets all trees out, each shown as far as it was. */
  #place(): void {
    const setup = this.#setup;
    if (!setup || !this.#impostors) return;
    const { places, feet } = setup;
    const layer = new Uint16Array(places.count);
    for (const shape of this.#shapes) for (const i of shape.ranks) layer[i] = shape.layer;
    const { count, x, y, turn } = places;
    this.#impostors.setTrees({ count, x, y, z: feet, turn, layer });
    for (const shape of this.#shapes) this.#show(shape);
  }

  /** The pictures of a shape have been taken: trees that another one stood in for have their own from now on. */
  #arrive(shape: Shape): void {
    const before = shownAs(this.#shapes, shape);
    if (before) shape.come = before.come;
    shape.state = 'there';
    this.#show(shape);
  }

  /** Draws the trees of a shape as they are to be shown now. */
  #show(shape: Shape): void {
    const shown = shownAs(this.#shapes, shape);
    for (const i of shape.ranks) {
      this.#own[i] = shown?.come ?? 0;
      if (shown) this.#impostors?.setLayer(i, shown.layer);
      this.#impostors?.setThere(i, this.#own[i] as number, this.#nearer[i] as number);
    }
  }
}
