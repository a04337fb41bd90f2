import { MathUtils, PerspectiveCamera, Ray, Vector3 } from 'three';
import type { CameraPose } from '../../core/link/link.ts';
import { inSeason, type Season } from '../../core/species/season.ts';
import type { Species } from '../../core/species/species.ts';
import type { Wind } from '../../core/wind/wind.ts';
import { CpuPoser } from '../../gpu/cpu-poser.ts';
import { TreeTextures } from '../../gpu/tree-textures.ts';
import { FeltWind } from '../felt-wind.ts';
import { frameTree } from '../framing.ts';
import { pickBranch } from '../pick.ts';
import { drawStillPicture } from '../still-picture.ts';
import { uprightBox } from '../tree-extent.ts';
import { groundAt, metresAPixel, rayAt } from './aim.ts';
import { placeOf, poseOf } from './camera-pose.ts';
import type { GrownTree } from './grow-tree.ts';
import { tipsOf } from './on-screen.ts';
import type {
  Capture,
  Compare,
  FrameFigures,
  Insets,
  OnScreen,
  Overlays,
  Picture,
  PictureEvents,
  Show,
  TextureImages,
} from './picture.ts';
import { textureImages } from './texture-images.ts';

/** Vertical field of view in degrees and azimuth of the first view in radians: those of the stage. */
const FOV = 30;
const AZIMUTH = 0.2;

/** Pixels that a pointer may be beside a twig. */
const NEAR = 8;

const toTreeSpace = ({ origin: o, direction: d }: Ray): Ray =>
  new Ray(new Vector3(o.x, -o.z, o.y), new Vector3(d.x, -d.z, d.y));

const NO_GPU = 'This browser draws a still picture only: it has no WebGL2.';

const NOTHING: FrameFigures = { triangles: 0, drawCalls: 0, wind: 0, draw: 0, catchingUp: null };

/** Draws the tree on a 2D canvas, posed by the reference on the CPU, where there is no WebGL2: once for each change. */
export class DrawnPicture implements Picture {
  readonly canvas = document.createElement('canvas');
  private readonly eye = new PerspectiveCamera(FOV, 1, 0.05, 2000);
  private readonly target = new Vector3(0, 3, 0);
  private readonly felt = new FeltWind();
  private poser: CpuPoser | null = null;
  private time = 0;
  private grown: GrownTree | null = null;
  private species: Species | null = null;
  /** The same as it looks in the season. */
  private dressed: Species | null = null;
  private season: Season = 'summer';
  private pose: Float32Array = new Float32Array(0);
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

  /** The reader moves the camera with keys alone; springs take some draws to a far time. */
  get moving(): boolean {
    return this.poser?.catchingUp != null;
  }

  get camera(): CameraPose {
    return poseOf(this.eye.position, this.target);
  }

  setTree(grown: GrownTree, species: Species): void {
    this.grown = grown;
    this.species = species;
    this.dressed = inSeason(species, this.season);
    const textures = new TreeTextures(grown.packed, false); // no GPU sees them: the pose is in `cpuPose`
    this.poser = new CpuPoser(textures);
    this.pose = textures.cpuPose ?? grown.packed.restPose.data;
    this.place();
  }

  setWind(wind: Wind): void {
    this.felt.set(wind, this.time, 0);
  }

  /** A still drawing shows A alone, and nothing beside the tree. */
  setCompare(_compare: Compare | null, _fade: number): void {}

  setOverlays(_overlays: Overlays): void {}

  show(how: Show): void {
    this.shown = how;
  }

  setDark(dark: boolean): void {
    this.dark = dark;
  }

  setSeason(season: Season): void {
    this.season = season;
    this.dressed = this.species && inSeason(this.species, season);
  }

  /** A drawing has one light. */
  setStage(): void {}

  setQuality(): void {}

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
    if (!this.grown || !this.dressed || !this.poser || !context) return NOTHING;
    const { packed } = this.grown;
    this.time = time;
    this.poser.update(null, time, this.felt);
    const posed = performance.now();
    const { levelsShown, showLeaves } = this.shown;
    drawStillPicture(context, this.eye, packed, this.dressed, {
      dark: this.dark,
      levels: levelsShown,
      leaves: showLeaves && levelsShown >= packed.levels.length,
      pose: this.pose,
    });
    return {
      triangles: 0,
      drawCalls: 0,
      wind: posed - start,
      draw: performance.now() - start,
      catchingUp: this.poser.catchingUp,
    };
  }

  tips(): Float32Array {
    return this.grown ? tipsOf(this.grown.packed, this.pose) : new Float32Array(0);
  }

  onScreen(): OnScreen {
    return { branches: [], stems: [], handles: {}, horizon: 0 };
  }

  pickPiece(x: number, y: number): number | null {
    if (!this.grown) return null;
    const { packed } = this.grown;
    const { ray } = rayAt(x, y, this.canvas.getBoundingClientRect(), this.eye);
    const places = packed.levels
      .slice(0, this.shown.levelsShown)
      .reduce((end, { start, count }) => Math.max(end, start + count), 0);
    const near = NEAR * metresAPixel(this.eye, this.canvas.height);
    return pickBranch(packed, toTreeSpace(ray), { places, pose: this.pose, near })?.piece ?? null;
  }

  pickStem(x: number, y: number): number | null {
    const piece = this.pickPiece(x, y);
    return piece === null ? null : (this.grown?.stems.stemOfPiece[piece] ?? null);
  }

  pickGround(x: number, y: number): { x: number; y: number } | null {
    return groundAt(x, y, this.canvas.getBoundingClientRect(), this.eye);
  }

  async readTextures(): Promise<TextureImages> {
    const back = await this.poser?.readBack(null);
    if (!back || !this.grown) throw new Error('There is no tree to read.');
    return textureImages(this.grown.packed, back.pose, back.state);
  }

  async readPiece(piece: number): Promise<Float32Array | null> {
    return (await this.poser?.readPiece(null, piece)) ?? null;
  }

  capture(time: number): string {
    while (this.draw(time).catchingUp !== null);
    return this.canvas.toDataURL();
  }

  async portrait(): Promise<Blob> {
    throw new Error(NO_GPU);
  }

  async openCapture(): Promise<Capture> {
    throw new Error(NO_GPU);
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
