import { MathUtils, PerspectiveCamera, Vector3 } from 'three';
import type { CameraPose } from '../../core/link/link.ts';
import type { Species } from '../../core/species/species.ts';
import { WindFader } from '../../core/wind/fade.ts';
import { poseTree } from '../../core/wind/pose-tree.ts';
import { presets } from '../../core/wind/presets.ts';
import type { Wind } from '../../core/wind/wind.ts';
import { frameTree } from '../framing.ts';
import { drawStillPicture } from '../still-picture.ts';
import { uprightBox } from '../tree-extent.ts';
import { placeOf, poseOf } from './camera-pose.ts';
import type { GrownTree } from './grow-tree.ts';
import { tipsOf } from './on-screen.ts';
import type { FrameFigures, Insets, OnScreen, Picture, PictureEvents, Show } from './picture.ts';

/** Vertical field of view in degrees and azimuth of the first view in radians: those of the stage. */
const FOV = 30;
const AZIMUTH = 0.2;

/** Draws the tree on a 2D canvas, posed by the reference on the CPU, where there is no WebGL2: once for each change. */
export class DrawnPicture implements Picture {
  readonly canvas = document.createElement('canvas');
  /** The reader moves the camera with keys alone. */
  readonly moving = false;
  private readonly eye = new PerspectiveCamera(FOV, 1, 0.05, 2000);
  private readonly target = new Vector3(0, 3, 0);
  private readonly fader = new WindFader(presets.still as Wind);
  private grown: GrownTree | null = null;
  private species: Species | null = null;
  private pose = new Float32Array(0);
  private shown: Show = { levelsShown: Number.POSITIVE_INFINITY, showLeaves: true, view: 'shaded' };
  private dark = false;
  private insets: Insets = { top: 0, right: 0, bottom: 0, left: 0 };
  private wished: CameraPose | null = null;

  /** Draws in `host`, as large as that is. */
  constructor(host: HTMLElement, events: PictureEvents) {
    this.canvas.tabIndex = 0;
    host.append(this.canvas);
    const size = (): void => {
      this.canvas.width = Math.max(1, host.clientWidth);
      this.canvas.height = Math.max(1, host.clientHeight);
      this.place();
      events.onChange();
    };
    new ResizeObserver(size).observe(host);
    size();
  }

  get camera(): CameraPose {
    return poseOf(this.eye.position, this.target);
  }

  setTree(grown: GrownTree, species: Species): void {
    this.grown = grown;
    this.species = species;
    this.pose = grown.packed.restPose.data.slice();
    this.place();
  }

  setWind(wind: Wind): void {
    this.fader.settle(wind);
  }

  show(how: Show): void {
    this.shown = how;
  }

  setDark(dark: boolean): void {
    this.dark = dark;
  }

  setInsets(insets: Insets): void {
    this.insets = insets;
    this.place();
  }

  setCamera(camera: CameraPose | null): void {
    this.wished = camera;
    this.place();
  }

  draw(time: number): FrameFigures {
    const start = performance.now();
    const context = this.canvas.getContext('2d');
    if (!this.grown || !this.species || !context) return { triangles: 0, drawCalls: 0, wind: 0, draw: 0 };
    const { packed } = this.grown;
    poseTree(packed, this.fader.at(time), 'exact', undefined, this.pose);
    const posed = performance.now();
    const { levelsShown, showLeaves } = this.shown;
    drawStillPicture(context, this.eye, packed, this.species, {
      dark: this.dark,
      levels: levelsShown,
      leaves: showLeaves && levelsShown >= packed.levels.length,
      pose: this.pose,
    });
    return { triangles: 0, drawCalls: 0, wind: posed - start, draw: performance.now() - start };
  }

  tips(): Float32Array {
    return this.grown ? tipsOf(this.grown.packed, this.pose) : new Float32Array(0);
  }

  onScreen(): OnScreen {
    return { branches: [], horizon: 0 };
  }

  capture(time: number): string {
    this.draw(time);
    return this.canvas.toDataURL();
  }

  /** Puts the camera where the document wants it, with the middle of its view clear of the panels, as the stage does. */
  private place(): void {
    const { width, height } = this.canvas;
    const { top, right, bottom, left } = this.insets;
    const { eye, target, wished } = this;
    eye.aspect = width / height;
    eye.setViewOffset(width, height, (right - left) / 2, (bottom - top) / 2, width, height);
    if (wished) placeOf(wished, eye.position, target);
    else if (this.grown) {
      const clear = Math.max(1, height - top - bottom);
      const fov = MathUtils.radToDeg(2 * Math.atan(Math.tan(MathUtils.degToRad(FOV / 2)) * (clear / height)));
      const framing = frameTree(
        uprightBox(this.grown.packed.bounds),
        fov,
        Math.max(1, width - left - right) / clear,
        AZIMUTH,
      );
      eye.position.copy(framing.position);
      target.copy(framing.target);
    }
    eye.lookAt(target);
    eye.updateProjectionMatrix();
  }
}
