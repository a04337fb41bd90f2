import { type Box3, MathUtils } from 'three';
import { TABLE_RANGES } from '../core/lod/table-2.ts';
import { growPacked } from '../core/pack/grow-packed.ts';
import { inSeason, type Season } from '../core/species/season.ts';
import type { Species } from '../core/species/species.ts';
import type { Wind } from '../core/wind/wind.ts';
import { LEAF_BUDGET } from '../view/detail.ts';
import { Stage } from '../view/stage.ts';
import { uprightBox } from '../view/tree-extent.ts';
import { type DrawnElements, WindTree } from '../view/wind-tree.ts';
import type { RangeState } from './state.ts';

/** The picture that the paper's ranges are written for: rows, and degrees that they span. */
const ROWS = 1000;
const SPAN = 60;

/** Height of the eye above the ground, metres. */
const EYE = 1.7;

/** What the last frame drew. */
export interface Figures {
  readonly triangles: number;
  readonly lines: number;
  readonly points: number;
}

/** The aspen on its meadow, at any range. */
export class RangePicture {
  readonly stage: Stage;
  readonly tree: WindTree;
  readonly #species: Species;
  readonly #packed: ReturnType<typeof growPacked>['packed'];
  readonly #box: Box3;
  readonly #canvas: HTMLCanvasElement;
  readonly #inset: HTMLCanvasElement;
  #season: Season = 'summer';
  #dark = false;
  #view = '';
  #rows = 1;

  /** Grows the tree. Throws where there is no WebGL2. */
  constructor(canvas: HTMLCanvasElement, inset: HTMLCanvasElement, species: Species, wind: Wind, seed: number) {
    this.#canvas = canvas;
    this.#inset = inset;
    this.#species = species;
    this.#packed = growPacked(species, seed).packed;
    this.#box = uprightBox(this.#packed.bounds);
    this.stage = new Stage(canvas, { shadows: 1024 });
    this.tree = new WindTree({ degradation: 'paper' });
    this.tree.setTree(this.#packed, species);
    this.tree.setWind(wind);
    this.stage.scene.add(this.tree);
  }

  /** What the tree's draws count at each range of Table 2, in summer at quality 1: it is drawn for each of them. */
  async countTable(): Promise<DrawnElements[]> {
    this.resize();
    this.tree.degradation = 'paper';
    await this.tree.degradationLoaded();
    Object.assign(this.tree.paperRange, { quality: 1, season: 'summer' });
    this.#frame();
    return TABLE_RANGES.map((range) => {
      this.tree.paperRange.r2 = range;
      this.tree.update(this.stage.renderer, 0);
      this.stage.render(false);
      return this.tree.elementsDrawn as DrawnElements;
    });
  }

  /** Takes the canvas's size over. */
  resize(): void {
    const { clientWidth, clientHeight } = this.#canvas;
    const ratio = Math.min(devicePixelRatio, 2);
    this.stage.resize(clientWidth, clientHeight, ratio);
    this.#rows = Math.max(1, clientHeight * ratio);
    this.#view = '';
  }

  /** Draws one frame as `state` says, at `time` seconds. */
  draw(state: RangeState, dark: boolean, time: number): void {
    const { tree, stage } = this;
    if (state.season !== this.#season) {
      this.#season = state.season;
      tree.setTree(this.#packed, inSeason(this.#species, state.season));
    }
    tree.degradation = state.way === 'paper' ? 'paper' : 'screen';
    tree.detail = state.way === 'full' ? 'high' : 'auto';
    tree.leafBudget = state.way === 'full' ? Number.POSITIVE_INFINITY : LEAF_BUDGET.auto;
    Object.assign(tree.paperRange, { quality: state.quality, season: state.season, r2: state.range });
    this.#look(state, dark);
    tree.update(stage.renderer, time);
    stage.blow(tree.windSource(), time);
    stage.render(true);
    this.#magnify(state);
  }

  /** What the last frame drew. */
  figures(): Figures {
    const drawn = this.tree.elementsDrawn;
    return {
      triangles: this.tree.stats().triangles,
      lines: drawn ? drawn.trunkLines + drawn.mainLines + drawn.otherLines : 0,
      points: drawn ? drawn.leafPoints : 0,
    };
  }

  /** How long a frame takes, milliseconds: the middle one of `frames` that are drawn and waited for. */
  measure(state: RangeState, dark: boolean, time: number, frames: number): number {
    const gl = this.stage.renderer.getContext();
    const pixel = new Uint8Array(4);
    const took = Array.from({ length: frames }, () => {
      const began = performance.now();
      this.draw(state, dark, time);
      gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, pixel);
      return performance.now() - began;
    });
    return took.toSorted((a, b) => a - b)[frames >> 1] as number;
  }

  /** Puts the camera where the state says, if it says another thing than before: what the reader turned stays. */
  #look({ range, near }: RangeState, dark: boolean): void {
    const view = near ? 'near' : `far ${range}`;
    if (dark !== this.#dark) this.stage.setDark(dark);
    this.#dark = dark;
    if (view === this.#view) return;
    this.#view = view;
    const { camera, controls } = this.stage;
    controls.enabled = near;
    this.#inset.hidden = near;
    if (near) {
      this.#frame();
      return;
    }
    // The part of the paper's picture that this canvas has room for, pixel for pixel.
    camera.fov = 2 * MathUtils.RAD2DEG * Math.atan((Math.tan((SPAN / 2) * MathUtils.DEG2RAD) * this.#rows) / ROWS);
    camera.far = 4 * range + 2000;
    camera.near = 0.02 * range;
    const middle = 0.5 * this.#box.max.y;
    controls.minDistance = 0;
    controls.maxDistance = 10 * range;
    controls.target.set(0, range < 40 ? Math.min(middle, EYE + 0.3 * range) : middle, 0);
    camera.position.set(range * Math.sin(0.35), EYE, range * Math.cos(0.35));
    camera.updateProjectionMatrix();
  }

  #frame(): void {
    const { camera } = this.stage;
    camera.fov = 30;
    this.stage.frame(this.#box, { azimuth: 0.35 });
  }

  /** Shows the middle of a small picture pixel by pixel. */
  #magnify({ near, range }: RangeState): void {
    const small = range >= 60 && !near;
    this.#inset.hidden = !small;
    if (!small) return;
    const { width, height } = this.#canvas;
    const tall = (this.#box.max.y * ROWS) / (2 * Math.tan((SPAN / 2) * MathUtils.DEG2RAD) * range);
    const side = Math.max(12, Math.min(height, Math.round(1.3 * tall)));
    const context = this.#inset.getContext('2d');
    if (!context) return;
    context.imageSmoothingEnabled = false;
    const { width: w, height: h } = this.#inset;
    context.drawImage(this.#canvas, (width - side) / 2, (height - side) / 2, side, side, 0, 0, w, h);
  }
}
