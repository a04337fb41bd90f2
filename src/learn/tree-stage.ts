import { Box3, Spherical, Vector3 } from 'three';
import type { StageId } from '../core/link/document.ts';
import type { Species } from '../core/species/species.ts';
import { STILL, type Wind } from '../core/wind/wind.ts';
import { loadSpecies, loadWind } from '../view/load.ts';
import type { Stage } from '../view/stage.ts';
import { uprightBox } from '../view/tree-extent.ts';
import { type Mode, WindTree } from '../view/wind-tree.ts';
import { type GrownTree, isAborted } from '../worker/client.ts';
import { newGrowQueue } from '../worker/grow-queue.ts';
import type { FigureHost, FigureStage, Values } from './figure.ts';
import { OrbitHand } from './orbit-hand.ts';
import { releaseStage, type StageUser, stageFor } from './stage-pool.ts';

/** The trees of a page grow one after the other. */
const queue = newGrowQueue();

/** What a 3D figure shows. */
export interface TreeShown {
  /** Id of a species that ships, or one of the figure's own: another object is grown anew. */
  readonly species: string | Species;
  /** Default 1. */
  readonly seed?: number;
  /** Id of a wind that ships, or one of the figure's own; null, the default: none. */
  readonly wind?: string | Wind | null;
  /** Levels below this one are drawn; default all. */
  readonly levels?: number;
  /** Default 'auto': where all levels are. */
  readonly leaves?: boolean | 'auto';
  readonly mode?: Mode;
  /** A time of the wind in seconds, in place of the figure's own. */
  readonly time?: number;
}

/** What the figure may look at and change around its tree. */
export interface TreeScene {
  readonly stage: Stage;
  readonly tree: WindTree;
  readonly grown: GrownTree;
}

export interface TreeStageOptions {
  show(values: Values): TreeShown;
  /** Where it stands; default 'studio'. */
  readonly place?: StageId;
  /** Pixels to a CSS pixel at most; default 1.5, and 1 while it moves. */
  readonly pixels?: number;
  /** Called before each drawing. */
  dress?(scene: TreeScene, values: Values, time: number): void;
  readouts?(scene: TreeScene, values: Values, time: number): Readonly<Record<string, number | string>>;
  text?(values: Values, grown: GrownTree | null): string;
}

const speciesLoaded = new Map<string, Promise<Species>>();
const windsLoaded = new Map<string, Promise<Wind>>();

/** A species that ships, loaded once a page. Throws LoadError. */
export function shippedSpecies(id: string): Promise<Species> {
  const species = speciesLoaded.get(id) ?? loadSpecies(`../species/${id}.json`);
  speciesLoaded.set(id, species);
  return species;
}

/** A wind that ships, loaded once a page. Throws LoadError. */
export function shippedWind(id: string): Promise<Wind> {
  const wind = windsLoaded.get(id) ?? loadWind(`../winds/${id}.json`);
  windsLoaded.set(id, wind);
  return wind;
}

/** A stage with one tree on it: drawn on a context that figures share, and copied to the figure's canvas, where it stays. */
class TreeStage implements FigureStage, StageUser {
  readonly ready: Promise<void>;
  readonly #host: FigureHost;
  readonly #options: TreeStageOptions;
  readonly #tree = new WindTree({ detail: 'low' });
  readonly #hand: OrbitHand;
  readonly #far: IntersectionObserver;
  #settle: { keep(): void; breakOff(error: unknown): void } | null = null;
  #asked: string | Species = '';
  #askedSeed = Number.NaN;
  #askedWind: string | Wind | null | undefined;
  #species: Species | null = null;
  #grown: GrownTree | null = null;
  #box = new Box3();
  #set = false;
  #failed: unknown = null;

  constructor(host: FigureHost, options: TreeStageOptions) {
    this.#host = host;
    this.#options = options;
    // It has a light of its own: its still picture is not turned for the dark.
    host.canvas.dataset.scene = '';
    this.ready = new Promise((keep, breakOff) => {
      this.#settle = { keep, breakOff };
    });
    this.#hand = new OrbitHand(host.canvas, () => host.redraw());
    this.#far = new IntersectionObserver(
      (entries) => {
        if (entries.every(({ isIntersecting }) => !isIntersecting)) releaseStage(this);
      },
      { rootMargin: '150% 0px' },
    );
    this.#far.observe(host.canvas);
  }

  lose(stage: Stage): void {
    stage.scene.remove(this.#tree);
    this.#tree.dispose();
    this.#set = false;
  }

  draw(values: Values, time: number): Readonly<Record<string, number | string>> {
    if (this.#failed) throw this.#failed;
    const shown = this.#options.show(values);
    this.#follow(shown);
    const grown = this.#grown;
    const species = this.#species;
    if (!grown || !species) return {};
    const stage = stageFor(this);
    const { size, dark } = this.#host;
    const tree = this.#tree;
    if (!this.#set) {
      tree.setTree(grown.packed, species);
      stage.scene.add(tree);
      stage.setScene(this.#options.place ?? 'studio', null);
      this.#set = true;
    }
    stage.setDark(dark);
    stage.resize(size.width, size.height, Math.min(this.#host.pixelRatio, this.#options.pixels ?? 1.5));
    tree.levelsShown = shown.levels ?? Number.POSITIVE_INFINITY;
    tree.showLeaves = shown.leaves ?? 'auto';
    tree.mode = shown.mode ?? 'shaded';
    const framing = stage.frame(this.#box);
    this.#turn(stage, framing.target);
    this.#options.dress?.({ stage, tree, grown }, values, time);
    tree.update(stage.renderer, shown.time ?? time);
    stage.blow(tree.windSource(), shown.time ?? time);
    stage.render(true);
    const context = this.#host.canvas.getContext('2d');
    const { width, height } = this.#host.canvas;
    context?.clearRect(0, 0, width, height);
    context?.drawImage(stage.renderer.domElement, 0, 0, width, height);
    return this.#options.readouts?.({ stage, tree, grown }, values, time) ?? {};
  }

  text(values: Values): string {
    return this.#options.text?.(values, this.#grown) ?? '';
  }

  reset(): void {
    this.#hand.reset();
  }

  dispose(): void {
    this.#far.disconnect();
    this.#hand.dispose();
    releaseStage(this);
  }

  /** Loads and grows what is asked for; the picture before stays until it is there. */
  #follow({ species, seed = 1, wind = null }: TreeShown): void {
    if (wind !== this.#askedWind) {
      this.#askedWind = wind;
      void Promise.resolve(typeof wind === 'string' ? shippedWind(wind) : (wind ?? STILL))
        .then((loaded) => {
          if (this.#askedWind !== wind) return;
          this.#tree.setWind(loaded);
          this.#host.redraw();
        })
        .catch((error: unknown) => this.#fail(error));
    }
    if (species === this.#asked && seed === this.#askedSeed) return;
    this.#asked = species;
    this.#askedSeed = seed;
    void this.#grow(species, seed).catch((error: unknown) => {
      if (!isAborted(error)) this.#fail(error);
    });
  }

  async #grow(asked: string | Species, seed: number): Promise<void> {
    const species = typeof asked === 'string' ? await shippedSpecies(asked) : asked;
    if (asked !== this.#asked || seed !== this.#askedSeed) return;
    const grown = await queue.grow(this, { species, seed });
    this.#species = species;
    this.#grown = grown;
    this.#box = uprightBox(grown.packed.bounds);
    this.#set = false;
    this.#settle?.keep();
    this.#host.redraw();
  }

  #turn(stage: Stage, target: Vector3): void {
    const { camera } = stage;
    const seen = new Spherical().setFromVector3(new Vector3().subVectors(camera.position, target));
    seen.theta += this.#hand.azimuth;
    seen.phi = Math.min(1.62, Math.max(0.15, seen.phi - this.#hand.elevation));
    camera.position.setFromSpherical(seen).add(target);
    camera.lookAt(target);
  }

  #fail(error: unknown): void {
    this.#failed = error;
    this.#settle?.breakOff(error);
    this.#host.redraw();
  }
}

/** The stage of a figure that shows one tree in three dimensions: `stage: treeStage({ show: … })`. */
export const treeStage =
  (options: TreeStageOptions) =>
  (host: FigureHost): FigureStage =>
    new TreeStage(host, options);
