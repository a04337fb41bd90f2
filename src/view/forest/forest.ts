import { type Camera, type Object3D as Group, Matrix4, Object3D, Vector2, type WebGLRenderer } from 'three';
import { forestDensity } from '../../core/forest/density.ts';
import type { ForestDocument, TreePlaces } from '../../core/forest/forest.ts';
import { windSpeedOf } from '../../core/forest/forest-wind.ts';
import type { HeightField } from '../../core/forest/height-field.ts';
import { scatter } from '../../core/forest/scatter.ts';
import type { Species } from '../../core/species/species.ts';
import { forceOfSpeed } from '../../core/wind/speed.ts';
import { STILL, type Wind } from '../../core/wind/wind.ts';
import type { WindSource } from '../../gpu/wind-source.ts';
import { type GroveClient, newGroveClient } from '../../worker/grove-client.ts';
import { FeltWind } from '../felt-wind.ts';
import { ForceField } from '../force-field.ts';
import { BudgetMeter, FOREST_STEPS, type ForestStep } from './budget.ts';
import { CardLayer } from './card-layer.ts';
import { bandOf, THRESHOLDS, type Thresholds } from './classes.ts';
import { FarTrees } from './far-trees.ts';
import { ForestGroves } from './forest-groves.ts';
import { type ForestSetup, setUpForest } from './forest-setup.ts';
import type { ShadeTree } from './ground-shade.ts';
import type { GroveOptions } from './grove.ts';
import type { AtlasOptions } from './impostor-atlas.ts';
import { litterColour } from './litter.ts';
import { CellView } from './view-cells.ts';

/** What a forest is made with. */
export interface ForestOptions {
  /** Who grows its trees; by default a worker of its own, which `dispose` ends. */
  client?: GroveClient;
  /** Milliseconds a frame. Default 16.7. */
  budget?: number;
  /** Bytes that its trees may take on the GPU. Default 512 MiB. */
  memoryBudget?: number;
  /** Shapes that a species has at most, as far as memory holds them and their pictures; where it has fewer trees, each is unique. Default 16. */
  variants?: number;
  /** How large the pictures of far trees are; by default 8 x 8 views of 64 texels. */
  pictures?: Omit<AtlasOptions, 'layers'>;
}

/** What a forest is and what its last frame drew. */
export interface ForestStats {
  readonly trees: number;
  /** Trees in view of each class; cells count as a whole. */
  readonly near: number;
  readonly middle: number;
  readonly far: number;
  readonly groves: number;
  readonly growing: number;
  /** Shadows left out. */
  readonly triangles: number;
  readonly drawCalls: number;
  readonly bytes: number;
  /** Name of the budget's step, and its place among `steps`. */
  readonly step: string;
  readonly steps: readonly string[];
  /** Milliseconds of a frame, the median of the last look; NaN before the first. */
  readonly frame: number;
  /** Part of the far trees' shapes that are there, 0..1. */
  readonly progress: number;
}

/** Seconds in which thresholds follow a step of the budget: nothing jumps. */
const EASE = 0.6;
/** Milliseconds a frame for taking pictures of far trees; and while nothing is there yet. */
const BAKE = 4;
const BAKE_FIRST = 60;

/**
 * A forest in the wind, at home in any three.js scene: near trees in full, others as moving branches with cards, the far ones as pictures
 * of themselves; each tree of its own shape as far as memory goes.
 *
 * Give it a document and a wind, and call `update` once a frame before rendering. Metres; y is up outside.
 */
export class Forest extends Object3D {
  readonly isForest = true;
  memoryBudget: number;
  /** Told why trees cannot be grown: they are then missing. By default the console. */
  onError: (error: unknown) => void = (error) => console.warn(error);
  readonly #variants: number | undefined;
  /** The wind over it as shaders take it; `update` fills it. */
  readonly field = new ForceField();
  readonly #client: GroveClient;
  readonly #ownsClient: boolean;
  readonly #meter: BudgetMeter;
  readonly #view = new CellView();
  readonly #felt = new FeltWind();
  readonly #space: Group = new Object3D();
  readonly #far: FarTrees;
  readonly #groves: ForestGroves;
  readonly #size = new Vector2();
  /** The camera's world matrix in the last frame. */
  readonly #seen = new Matrix4();
  #setup: ForestSetup | null = null;
  #wind: Wind = STILL;
  #thresholds: Thresholds = THRESHOLDS;
  #near = THRESHOLDS.near;
  #middle = THRESHOLDS.middle;
  #held: number | null = null;
  #last = Number.NaN;
  #time = Number.NaN;

  constructor({ client, budget = 16.7, memoryBudget = 512 * 2 ** 20, variants, pictures = {} }: ForestOptions = {}) {
    super();
    this.name = 'forest';
    this.#ownsClient = !client;
    this.#client = client ?? newGroveClient();
    this.#meter = new BudgetMeter(budget);
    this.memoryBudget = memoryBudget;
    this.#variants = variants;
    this.#space.rotation.x = -Math.PI / 2; // z up to y up
    this.#space.name = 'forest space';
    this.add(this.#space);
    this.#far = new FarTrees(this.#space, this.#client, this.field, pictures, (error) => this.onError(error));
    this.#groves = new ForestGroves(
      this,
      this.#client,
      this.#far.taken,
      (form, species) => this.#groveOptions(form, species),
      (error) => this.onError(error),
    );
  }

  /**
   * Takes a forest; the old one goes. `places`: where its trees stand, by default as `scatter` has them without a map of density.
   * Throws Error where a species of the mix is not in `species`, RangeError where `field` is no ground; the old forest then stays.
   */
  setForest(
    document: ForestDocument,
    species: ReadonlyMap<string, Species>,
    field: HeightField,
    places: TreePlaces = scatter(document, field, forestDensity(document, null)),
  ): void {
    const setup = setUpForest(document, species, field, places, this.memoryBudget, this.#variants);
    this.#setup = setup;
    this.#meter.budget = document.budget;
    this.#meter.restart();
    this.#groves.setForest(setup);
    this.#far.setForest(setup);
  }

  /** Lets a wind blow over the whole forest, fading over from the last one in `fade` seconds of the clock. */
  setWind(wind: Wind, { fade = 0 }: { fade?: number } = {}): void {
    this.#wind = wind;
    this.#felt.set(wind, Number.isNaN(this.#time) ? 0 : this.#time, fade);
  }

  get wind(): Wind {
    return this.#wind;
  }

  /** The wind as felt at the forest's middle. */
  windSource(): WindSource {
    return this.#felt;
  }

  /** Mean force of the wind, metres, as far as it has come. */
  get meanForce(): number {
    return this.#far.meanForce.value;
  }

  /** Milliseconds a frame, kept by lowering detail in named steps. */
  get budget(): number {
    return this.#meter.budget;
  }

  set budget(milliseconds: number) {
    this.#meter.budget = milliseconds;
  }

  /** How detail stands. */
  get step(): ForestStep {
    return FOREST_STEPS[this.#held ?? this.#meter.step] as ForestStep;
  }

  /** Holds a step of FOREST_STEPS whatever the frame time; null: as the budget says. */
  holdStep(index: number | null): void {
    this.#held = index;
  }

  /** Factor on the time in which trees fade in, and on the band of sizes over which classes share a tree out; 0: all at once. Default 1. */
  set crossFade(factor: number) {
    this.#groves.fade = factor;
  }

  /** Heights in pixels from which trees are drawn in full, and as cards; steps of the budget scale them. At once. */
  set thresholds(thresholds: Thresholds) {
    this.#thresholds = thresholds;
    this.#near = thresholds.near * this.step.near;
    this.#middle = thresholds.middle * this.step.middle;
  }

  /**
   * Goes on with everything for a camera whose world matrix is up to date: `time` of the clock in seconds, `now` of the page in
   * milliseconds.
   */
  update(renderer: WebGLRenderer, camera: Camera, time: number, now: number): void {
    if (!this.#setup) return;
    const passed = Number.isNaN(this.#last) ? 0 : Math.max(0, now - this.#last);
    // While everything stands still the step stays; who flies past a still forest waits for its frames, too.
    if (time !== this.#time || !this.#seen.equals(camera.matrixWorld)) this.#meter.frame(passed);
    else this.#meter.restart();
    this.#seen.copy(camera.matrixWorld);
    this.#last = now;
    this.#time = time;
    this.updateWorldMatrix(true, false);
    const { step } = this;
    const height = renderer.getDrawingBufferSize(this.#size).y;
    this.#view.take(camera, this.matrixWorld, height);
    this.#ease(step, Math.min(passed, 100));
    this.#felt.moveTo(this.matrixWorld);
    this.field.take(this.#felt, time);
    const thresholds = { near: this.#near, middle: this.#middle };
    const fresh = Math.min(passed, 100);
    const { forestEye, forestScale, forestFade } = this.#far.fade;
    forestEye.value.fromArray(this.#view.eye);
    forestScale.value = this.#view.scale;
    const [from, to] = bandOf(this.#groves.middle ? this.#middle : this.#near, this.#groves.fade);
    forestFade.value.setZ(from).setW(to);
    this.#far.update(renderer, camera, fresh, this.#far.progress === 0 ? BAKE_FIRST : BAKE);
    // Far trees come first: the worker grows nothing else until their shapes are there.
    if (!this.#far.grown) return;
    const { memoryBudget } = this;
    const wind = this.#wind;
    const memory = Math.max(0, memoryBudget - this.#far.bytes);
    this.#groves.update({
      renderer,
      camera,
      time,
      passed: fresh,
      view: this.#view,
      thresholds,
      step,
      memoryBudget: memory,
      wind,
    });
  }

  /** Is nothing growing, being photographed or fading? */
  get settled(): boolean {
    return this.#far.settled && this.#groves.settled;
  }

  stats(): ForestStats {
    const groves = this.#groves.stats();
    const far = this.#far.drawn;
    return {
      trees: this.#setup?.places.count ?? 0,
      near: groves.near,
      middle: groves.middle,
      far: Math.max(0, far - groves.near - groves.middle),
      groves: groves.groves,
      growing: groves.growing,
      triangles: groves.triangles + 2 * far,
      drawCalls: groves.drawCalls + (far > 0 ? 1 : 0),
      bytes: groves.bytes + this.#far.bytes,
      step: this.step.name,
      steps: FOREST_STEPS.map(({ name }) => name),
      frame: this.#meter.median,
      progress: this.#far.progress,
    };
  }

  /** The crowns of the trees whose shapes are known: they shade the ground. */
  crowns(): ShadeTree[] {
    return this.#far.crowns();
  }

  /** Colour of what lies under the trees, as the screen has it. */
  get litter(): readonly [number, number, number] {
    const setup = this.#setup;
    return setup ? litterColour(setup.mix, setup.trees, setup.document.season) : [0.3, 0.25, 0.2];
  }

  /** Frees everything on the GPU, and its worker. */
  override dispose(): void {
    this.#groves.clear();
    this.#far.clear();
    this.field.dispose();
    if (this.#ownsClient) this.#client.dispose();
    this.#setup = null;
  }

  /** Moves the thresholds towards those of the step, and what counts as a gust towards the wind's own mean. */
  #ease(step: ForestStep, passed: number): void {
    const part = 1 - Math.exp(-passed / (1000 * EASE));
    const { meanForce } = this.#far;
    meanForce.value += (forceOfSpeed(windSpeedOf(this.#wind)) - meanForce.value) * part;
    this.#near += (this.#thresholds.near * step.near - this.#near) * part;
    this.#middle += (this.#thresholds.middle * step.middle - this.#middle) * part;
  }

  #groveOptions(form: 'full' | 'middle', species: number): GroveOptions | null {
    if (form === 'full') return {};
    const pictures = this.#far.clumps(species);
    return pictures && { foliage: (host) => new CardLayer(host, pictures, species, this.#far.meanForce) };
  }
}
