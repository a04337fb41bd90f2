import { Vector3 } from 'three';
import type { CameraPose } from '../../core/link/link.ts';
import type { Species } from '../../core/species/species.ts';
import type { Wind } from '../../core/wind/wind.ts';
import { Stage } from '../stage.ts';
import { uprightBox } from '../tree-extent.ts';
import { WindTree } from '../wind-tree.ts';
import { placeOf, poseOf } from './camera-pose.ts';
import { GpuTimer } from './gpu-timer.ts';
import type { GrownTree } from './grow-tree.ts';
import { onScreen, tipsOf } from './on-screen.ts';
import { Pace } from './pace.ts';
import type { FrameFigures, Insets, OnScreen, Picture, PictureEvents, Show } from './picture.ts';

/** Milliseconds of a frame on most screens, and the part of the camera's swing that is left after one. */
const FRAME = 1000 / 60;
const SWING = 0.9;

/** The picture that moves: three's stage with one tree in the wind. */
export class LivePicture implements Picture {
  readonly canvas = document.createElement('canvas');
  private readonly stage: Stage;
  private readonly tree = new WindTree();
  private readonly events: PictureEvents;
  private readonly timer: GpuTimer;
  private grown: GrownTree | null = null;
  /** Where the document wants the camera; null: the whole tree. */
  private wished: CameraPose | null = null;
  /** Where the camera rests: set anew before each frame, so that rounding in the controls never adds up. */
  private readonly rest = { position: new Vector3(), target: new Vector3() };
  /** The reader holds the camera, or let it go and it glides. */
  private held = false;
  private gliding = false;
  /** What casts shadows has changed since they were drawn. */
  private stale = true;
  private time = Number.NaN;
  private windMs = 0;
  private readonly pace = new Pace();
  private size: [width: number, height: number] = [1, 1];
  /** Part of the pixels in each direction that is drawn now. */
  private scale = 1;
  private drawn = 0;
  private hurried = false;
  private frame = 0;

  /** Draws in `host`, as large as that is. Throws where the browser gives no WebGL2 context. */
  constructor(host: HTMLElement, events: PictureEvents) {
    this.events = events;
    this.canvas.tabIndex = 0;
    host.append(this.canvas);
    this.stage = new Stage(this.canvas);
    this.stage.scene.add(this.tree);
    this.timer = new GpuTimer(this.stage.renderer.getContext() as WebGL2RenderingContext);
    const { controls } = this.stage;
    controls.enableDamping = !matchMedia('(prefers-reduced-motion: reduce)').matches;
    controls.addEventListener('start', () => {
      this.held = true;
      this.gliding = true;
      events.onChange();
    });
    controls.addEventListener('end', () => {
      this.held = false;
      events.onChange();
    });
    controls.addEventListener('change', events.onChange);
    for (const [name, lost] of [
      ['webglcontextlost', true],
      ['webglcontextrestored', false],
    ] as const) {
      this.canvas.addEventListener(name, () => {
        this.stale = true;
        events.onLost(lost);
      });
    }
    const size = (): void => {
      this.size = [host.clientWidth, host.clientHeight];
      this.resize();
      this.place();
      events.onChange();
    };
    new ResizeObserver(size).observe(host);
    size();
  }

  get renderer(): Stage['renderer'] {
    return this.stage.renderer;
  }

  get moving(): boolean {
    return this.held || this.gliding;
  }

  get camera(): CameraPose {
    return poseOf(this.stage.camera.position, this.stage.controls.target);
  }

  setTree(grown: GrownTree, species: Species): void {
    this.grown = grown;
    this.tree.setTree(grown.packed, species);
    this.stale = true;
    this.place();
  }

  setWind(wind: Wind, fade: number): void {
    this.tree.setWind(wind, { fade });
    this.stale = true;
  }

  show({ levelsShown, showLeaves, view }: Show): void {
    this.tree.levelsShown = levelsShown;
    this.tree.showLeaves = showLeaves ? 'auto' : false;
    this.tree.mode = view;
    this.stale = true;
  }

  setDark(dark: boolean): void {
    this.stage.setDark(dark);
    this.stale = true;
  }

  setInsets(insets: Insets): void {
    this.stage.setInsets(insets);
    this.place();
  }

  setCamera(camera: CameraPose | null): void {
    this.wished = camera;
    this.place();
  }

  draw(time: number, hurried: boolean): FrameFigures {
    this.keepPace(hurried);
    const { stage, tree } = this;
    const { renderer, controls, camera } = stage;
    if (!this.moving) {
      camera.position.copy(this.rest.position);
      controls.target.copy(this.rest.target);
    }
    const start = performance.now();
    // The swing fades by time, not by frames: where frames are slow it would go on for a minute.
    controls.dampingFactor = 1 - SWING ** Math.max(1, (start - this.drawn) / FRAME);
    this.drawn = start;
    this.timer.begin();
    tree.update(renderer, time);
    this.timer.end();
    const submitted = performance.now();
    const moved = this.stale || time !== this.time;
    // On a slow machine shadows follow every third frame while things move: they cost as much as the tree.
    const shadows = moved && (this.scale === 1 || this.frame % 3 === 0);
    stage.render(shadows);
    this.frame++;
    const drawn = performance.now();
    // Where nothing changed the pass did nothing: its last figure stands.
    if (moved) this.windMs = this.timer.milliseconds ?? submitted - start;
    this.stale = moved && !shadows;
    this.time = time;
    if (this.gliding && !this.held && !stage.moving) this.settle();
    const { triangles, calls } = renderer.info.render;
    return { triangles, drawCalls: calls, wind: this.windMs, draw: drawn - start };
  }

  tips(): Float32Array {
    const pose = this.tree.readPose(this.stage.renderer);
    if (!pose || !this.grown) return new Float32Array(0);
    return tipsOf(this.grown.packed, pose);
  }

  onScreen(): OnScreen {
    const pose = this.tree.readPose(this.stage.renderer);
    if (!pose || !this.grown) return { branches: [], horizon: 0 };
    return onScreen(this.grown.packed, pose, this.tree, this.stage.camera, this.canvas);
  }

  capture(time: number): string {
    this.draw(time, false);
    return this.canvas.toDataURL(); // in the same task: the drawing is gone once it was shown
  }

  private resize(): void {
    this.stage.resize(...this.size, window.devicePixelRatio * this.scale);
  }

  /** While things move, as many pixels as this machine can draw; all of them once they rest. */
  private keepPace(hurried: boolean): void {
    if (hurried && this.hurried) this.pace.frame(performance.now() - this.drawn);
    else this.pace.restart();
    this.hurried = hurried;
    const scale = hurried ? this.pace.scale : 1;
    if (scale === this.scale) return;
    this.scale = scale;
    this.stale = true;
    this.resize();
  }

  /** The camera came to rest: what is left of its swing goes, and the document learns where it stands. */
  private settle(): void {
    const { controls } = this.stage;
    const { enableDamping } = controls;
    controls.enableDamping = false;
    controls.update();
    controls.enableDamping = enableDamping;
    this.gliding = false;
    this.events.onCamera(this.camera);
  }

  /** Puts the camera where the document wants it. */
  private place(): void {
    const { stage, rest, wished } = this;
    if (this.grown) {
      const box = uprightBox(this.grown.packed.bounds);
      if (wished) stage.setSubject(box);
      else stage.frame(box);
    }
    if (wished) placeOf(wished, rest.position, rest.target);
    else {
      rest.position.copy(stage.camera.position);
      rest.target.copy(stage.controls.target);
    }
    this.gliding = false;
    this.stale = true; // how finely the tree is drawn goes by the camera, and so do its shadows
  }
}
