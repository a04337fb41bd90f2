import type { CameraPose } from '../core/link/document.ts';
import { inSeason } from '../core/species/season.ts';
import type { Species } from '../core/species/species.ts';
import type { Wind } from '../core/wind/wind.ts';
import { KitTree, type Mode } from '../view/kit-tree.ts';
import { Fineness } from '../view/picture/fineness.ts';
import type { QualityLevel } from '../view/picture/quality.ts';
import type { GrownTree } from '../worker/client.ts';
import type { ElementDebug } from './attributes.ts';
import { elementKit } from './element-kit.ts';
import { type RendererUser, sharedRenderer } from './shared-renderer.ts';
import type { TreeLook } from './tree-look.ts';

export type { TreeLook } from './tree-look.ts';

/** What a view tells its element. */
export interface TreeViewEvents {
  /** The GPU was taken away (true), or is back. */
  readonly onLost: (lost: boolean) => void;
  /** It is drawn otherwise than before, because it was too slow, or is fast again. */
  readonly onQuality: (quality: DrawnQuality) => void;
  /** What it waited for has come: it can be drawn; or has not, and it stays as it was. */
  readonly onCome: (error?: unknown) => void;
}

/** How finely it is drawn at the moment. */
export interface DrawnQuality {
  readonly level: QualityLevel;
  /** Part of the pixels in each direction. */
  readonly scale: number;
}

/** What a picture was made of, and where the ground stopped the camera. */
export interface ViewFigures {
  readonly triangles: number;
  readonly drawCalls: number;
  readonly elevation: number;
  /** It is not yet as of this time: draw again. */
  readonly unfinished: boolean;
}

const MODE_OF: Readonly<Record<ElementDebug, Mode>> = {
  none: 'shaded',
  levels: 'levels',
  skeleton: 'control',
  mesh: 'wireframe',
  field: 'shaded',
  state: 'shaded',
};

/** One tree of the page on the renderer that all share, and the canvas that shows it. */
export class TreeView implements RendererUser {
  readonly canvas: HTMLCanvasElement;
  readonly #events: TreeViewEvents;
  readonly #fineness = new Fineness();
  #tree: KitTree | null = null;
  /** It has what is to be seen. */
  #set = false;
  #grown: GrownTree | null = null;
  /** As its file has it. */
  #species: Species | null = null;
  #wind: Wind | null = null;
  #look: TreeLook | null = null;
  #size: readonly [number, number] = [1, 1];
  #stale = true;
  #frame = 0;
  #drawn = 0;
  #time = Number.NaN;

  /** Throws where the browser gives no WebGL2 context. */
  constructor(canvas: HTMLCanvasElement, events: TreeViewEvents) {
    this.canvas = canvas;
    this.#events = events;
    sharedRenderer.join(this);
  }

  /** The object that is drawn, in the scene only while it is; null where there is none, or its memory was freed. */
  get tree(): KitTree | null {
    return this.#tree;
  }

  get grown(): GrownTree | null {
    return this.#grown;
  }

  get quality(): DrawnQuality {
    return { level: this.#fineness.level, scale: this.#fineness.scale };
  }

  setTree(grown: GrownTree, species: Species): void {
    this.#grown = grown;
    this.#species = species;
    if (this.#tree) this.#put(this.#tree);
    else this.#wake();
  }

  /** Lets a wind blow, fading over in `fade` seconds. */
  setWind(wind: Wind, fade: number): void {
    this.#wind = wind;
    this.#tree?.setWind(wind, { fade });
    this.#stale = true;
  }

  setLook(look: TreeLook): void {
    const season = look.season !== this.#look?.season;
    this.#look = look;
    this.#fineness.quality = look.detail;
    this.#stale = true;
    if (!this.#tree) return;
    if (season) this.#put(this.#tree);
    this.#dress(this.#tree);
  }

  /** CSS pixels. */
  setSize(width: number, height: number): void {
    this.#size = [Math.max(1, Math.round(width)), Math.max(1, Math.round(height))];
    this.#stale = true;
  }

  /** The camera that shows the whole tree; null before there is one. */
  whole(): CameraPose | null {
    return this.#grown && sharedRenderer.wholeView(this.#grown.packed.bounds, ...this.#size);
  }

  /** Draws the tree as of `time` seconds; `hurried`: more follows at once. null where it cannot be drawn now. */
  draw(time: number, camera: CameraPose, hurried: boolean): ViewFigures | null {
    if (!this.#grown || !this.#look) return null;
    this.#wake();
    const tree = this.#tree as KitTree;
    if (!this.#set) return null;
    const look = this.#look;
    const now = performance.now();
    const fineness = this.#fineness;
    const { scale, level } = fineness.frame(hurried, now - this.#drawn);
    this.#drawn = now;
    const { settings } = fineness;
    tree.detail = settings.detail;
    tree.leafBudget = settings.leafBudget;
    const moved = this.#stale || scale || level || time !== this.#time;
    // Shadows cost as much as the tree: on a slow machine they follow every third frame while it moves.
    const shadows = moved && (fineness.scale === 1 || this.#frame++ % 3 === 0);
    const drawn = sharedRenderer.draw(
      {
        ...look,
        tree,
        packed: this.#grown.packed,
        come: () => this.#events.onCome(),
        time,
        near: hurried,
        camera,
        width: this.#size[0],
        height: this.#size[1],
        pixelRatio: Math.min(fineness.pixelRatio, look.maxPixelRatio * fineness.scale),
        grass: settings.grass,
        moved: shadows,
      },
      this.canvas,
    );
    if (!drawn) return null;
    this.#stale = moved && !shadows;
    this.#time = time;
    if (scale || level) this.#events.onQuality(this.quality);
    const { triangles, drawCalls, elevation, catchingUp } = drawn;
    return { triangles, drawCalls, elevation, unfinished: catchingUp !== null || (this.#stale && !hurried) };
  }

  lost(lost: boolean): void {
    this.#stale = true;
    this.#events.onLost(lost);
  }

  /** Frees what it has on the GPU: it is far from the screen. The next drawing brings it back. */
  rest(): void {
    this.#tree?.dispose();
    this.#tree = null;
    this.#set = false;
    this.#time = Number.NaN;
  }

  dispose(): void {
    this.rest();
    sharedRenderer.leave(this);
  }

  #wake(): void {
    if (this.#tree) return;
    const tree = new KitTree(elementKit);
    this.#tree = tree;
    this.#put(tree);
    if (this.#wind) tree.setWind(this.#wind);
    this.#dress(tree);
  }

  #dress(tree: KitTree): void {
    const look = this.#look;
    if (!look) return;
    tree.mode = MODE_OF[look.debug];
    tree.levelsShown = look.levels;
    tree.showLeaves = look.leaves ? 'auto' : false;
  }

  /** In the colours of the season, at once or when what they need has come. */
  #put(tree: KitTree): void {
    if (!this.#grown || !this.#species) return;
    const species = inSeason(this.#species, this.#look?.season ?? 'summer');
    if (!elementKit.has(species)) {
      void this.#putLater(tree, species);
      return;
    }
    tree.setTree(this.#grown.packed, species);
    this.#set = true;
    this.#stale = true;
  }

  async #putLater(tree: KitTree, species: Species): Promise<void> {
    try {
      await elementKit.load(species);
    } catch (error) {
      this.#events.onCome(error);
      return;
    }
    if (this.#tree !== tree) return;
    // As the tree and the season are by now.
    this.#put(tree);
    this.#events.onCome();
  }
}
