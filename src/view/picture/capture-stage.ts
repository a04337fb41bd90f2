import { type Box3, MathUtils } from 'three';
import type { CameraPose, StageId } from '../../core/link/link.ts';
import type { PackedTree } from '../../core/pack/packed.ts';
import type { StemTable } from '../../core/pack/stem-table.ts';
import type { Species } from '../../core/species/species.ts';
import type { Wind } from '../../core/wind/wind.ts';
import { frameTree } from '../framing.ts';
import type { KitTree } from '../kit-tree.ts';
import { AZIMUTH, FOV, type Shot, Stage } from '../stage.ts';
import { uprightBox } from '../tree-extent.ts';
import { placeOf } from './camera-pose.ts';
import { closeUp, WHOLE } from './close-up.ts';
import type { ChannelView, Show } from './picture.ts';
import { tilesOf } from './tiles.ts';

/** What stands on the stage, and how. */
export interface Sitter {
  readonly packed: PackedTree;
  readonly stems: StemTable;
  readonly species: Species;
  readonly wind: Wind;
  readonly show: Show;
  readonly dark: boolean;
  readonly channel: ChannelView | null;
  /** Where it stands, and when; by default the meadow at its own hour. */
  readonly scene?: { readonly stage: StageId; readonly hour: number | null };
}

/** What is drawn around the tree: all of the stage, the ground without its grass, or nothing. */
export type Setting = 'stage' | 'plain' | 'none';

/**
 * From where: a place of the camera, and what of its picture must be seen, in parts of its height; or the whole tree, as the stage frames
 * it (`whole`) or as close as its box allows (`close`).
 */
export type Viewpoint = { readonly pose: CameraPose; readonly high: number; readonly wide: number } | 'whole' | 'close';

/** Vertical field of view in degrees that shows `high` and `wide` of a picture of FOV in one of this shape. */
export const fieldOfView = (high: number, wide: number, aspect: number): number =>
  2 * MathUtils.radToDeg(Math.atan(Math.tan(MathUtils.degToRad(FOV / 2)) * Math.max(high, wide / aspect)));

/**
 * A stage of its own beside the visible one, with its own context on the GPU: whatever is drawn here, and however large, the visible
 * picture, its springs and its time stay as they are.
 */
export class CaptureStage {
  readonly #stage: Stage;
  readonly #tree: KitTree;
  readonly #longest: number;
  #sitter: Sitter | null = null;

  /**
   * `tree`: a new one, which is the stage's own from now on; `longest`: pixels of a side that are drawn at once at most, where the GPU could
   * do more. Throws where the browser gives no further WebGL2 context.
   */
  constructor(around: Setting, tree: KitTree, longest = Number.POSITIVE_INFINITY) {
    this.#tree = tree;
    this.#longest = longest;
    this.#stage = new Stage(document.createElement('canvas'), { alpha: around === 'none' });
    const { scene, sky, ground, meadow } = this.#stage;
    sky.visible = around !== 'none';
    ground.visible = around !== 'none';
    meadow.visible = around === 'stage';
    scene.add(this.#tree);
  }

  /** The longest side of a picture that this GPU's canvas can hold; longer ones are put together of tiles. */
  get longest(): number {
    const gl = this.#stage.renderer.getContext();
    return Math.min(this.#longest, gl.getParameter(gl.MAX_RENDERBUFFER_SIZE), ...gl.getParameter(gl.MAX_VIEWPORT_DIMS));
  }

  /** Sets a tree on the stage, in its wind as if that had always blown. */
  take(sitter: Sitter): void {
    const { packed, stems, species, wind, show, dark, channel, scene } = sitter;
    this.#sitter = sitter;
    this.#tree.setTree(packed, species);
    this.#tree.setWind(wind);
    this.#tree.settle();
    this.#tree.levelsShown = show.levelsShown;
    this.#tree.showLeaves = show.showLeaves ? 'auto' : false;
    this.#tree.mode = show.view;
    if (channel) this.#tree.showChannel(channel, stems);
    this.#stage.setScene(scene?.stage ?? 'meadow', scene?.hour ?? null);
    this.#stage.setDark(dark);
  }

  set shot(shot: Shot | null) {
    this.#stage.shot = shot;
  }

  /**
   * Draws the tree as of `time` seconds into `canvas`, in its whole size, tile by tile where it is large. Long ways of the springs are run
   * in parts, between which the page breathes. Rejects where the GPU was taken away.
   */
  async draw(canvas: HTMLCanvasElement, time: number, from: Viewpoint): Promise<void> {
    const { renderer } = this.#stage;
    do {
      this.#tree.update(renderer, time);
      if (renderer.getContext().isContextLost()) throw new Error('The graphics card was taken away.');
      if (this.#tree.catchingUp !== null) await breath();
    } while (this.#tree.catchingUp !== null);
    const context = canvas.getContext('2d');
    if (!context || !this.#sitter) throw new Error('There is nothing to draw on.');
    this.#stage.blow(this.#tree.windSource(), time);
    context.clearRect(0, 0, canvas.width, canvas.height);
    const { camera } = this.#stage;
    const { width, height } = canvas;
    this.#aim(from, width / height);
    const crop = from === 'close' ? closeUp(this.#box, camera) : WHOLE;
    for (const [i, tile] of tilesOf(canvas, this.longest).entries()) {
      this.#stage.resize(tile.width, tile.height);
      camera.aspect = width / height;
      camera.setViewOffset(
        width,
        height,
        crop.x * width + crop.part * tile.x,
        crop.y * height + crop.part * tile.y,
        crop.part * tile.width,
        crop.part * tile.height,
      );
      // The choice of detail goes by the drawing buffer, whose size may have changed.
      this.#tree.update(renderer, time);
      this.#stage.render(i === 0);
      context.drawImage(renderer.domElement, tile.x, tile.y);
    }
  }

  /** Resolves once the GPU has drawn all that it was given: who draws frame after frame does not run ahead of it. */
  async drawn(): Promise<void> {
    const gl = this.#stage.renderer.getContext() as WebGL2RenderingContext;
    const fence = gl.fenceSync(gl.SYNC_GPU_COMMANDS_COMPLETE, 0);
    gl.flush();
    while (fence && gl.clientWaitSync(fence, 0, 0) === gl.TIMEOUT_EXPIRED) await breath();
    gl.deleteSync(fence);
  }

  /** Frees everything, the context on the GPU too: a browser has few. */
  dispose(): void {
    const { renderer } = this.#stage;
    this.#tree.dispose();
    this.#stage.dispose();
    renderer.forceContextLoss();
  }

  get #box(): Box3 {
    return uprightBox((this.#sitter as Sitter).packed.bounds);
  }

  #aim(from: Viewpoint, aspect: number): void {
    const { camera, controls } = this.#stage;
    const box = this.#box;
    this.#stage.setSubject(box);
    controls.maxDistance = Number.POSITIVE_INFINITY;
    const placed = typeof from === 'object';
    if (placed) placeOf(from.pose, camera.position, controls.target);
    else {
      const { position, target } = frameTree(box, FOV, aspect, AZIMUTH);
      camera.position.copy(position);
      controls.target.copy(target);
    }
    camera.fov = placed ? fieldOfView(from.high, from.wide, aspect) : FOV;
    camera.aspect = aspect;
    camera.clearViewOffset();
    camera.lookAt(controls.target);
  }
}

const breath = (): Promise<void> => new Promise((done) => setTimeout(done));
