import type { CameraPose } from '../core/link/document.ts';
import { Clock } from '../view/clock.ts';
import type { CameraOrbit } from './attribute-rules.ts';
import type { Drawing } from './drawing.ts';
import type { WindTreeEventDetails } from './element-events.ts';
import { Orbit } from './orbit.ts';
import type { OrbitWishes } from './orbit-input.ts';
import type { Planted } from './tree-loader.ts';
import type { DrawnQuality, TreeLook, TreeView } from './tree-view.ts';

/** What a player tells its element. */
export interface PlayerHost {
  tell<Name extends keyof WindTreeEventDetails>(name: Name, detail: WindTreeEventDetails[Name]): void;
  /** The first picture of a tree is there. */
  seen(): void;
  lost(lost: boolean): void;
  /** What a change needs did not come: the picture stays as it was. */
  failed(error: unknown): void;
  /** Where the camera stands by the attribute. */
  readonly cameraOrbit: CameraOrbit | null;
  toggle(): void;
}

/** Milliseconds from one `timeupdate` to the next, at least. */
const TOLD = 250;

const reduced = (): boolean => matchMedia('(prefers-reduced-motion: reduce)').matches;

/** Time, camera and picture of one element: draws a frame when something has changed and it can be seen, and else nothing. */
export class TreePlayer implements OrbitWishes {
  readonly clock = new Clock();
  readonly orbit = new Orbit();
  readonly #host: PlayerHost;
  #drawing: Drawing | null = null;
  #view: TreeView | null = null;
  #canvas: HTMLCanvasElement | null = null;
  #size: readonly [number, number] = [0, 0];
  #visible = false;
  #lost = false;
  #held = false;
  #cameraBy: 'user' | 'script' | null = null;
  #fresh = false;
  #figures = { triangles: 0, drawCalls: 0 };
  #before = 0;
  #told = 0;

  constructor(host: PlayerHost) {
    this.#host = host;
  }

  get view(): TreeView | null {
    return this.#view;
  }

  get lost(): boolean {
    return this.#lost;
  }

  get figures(): { readonly triangles: number; readonly drawCalls: number } {
    return this.#figures;
  }

  /** Opens a view where there is none. Throws where the browser gives no WebGL2 context. */
  open(drawing: Drawing, canvas: HTMLCanvasElement): void {
    this.#drawing = drawing;
    this.#canvas = canvas;
    this.#view ??= drawing.open(canvas, {
      onLost: (lost) => {
        this.#lost = lost;
        this.#host.lost(lost);
        this.request();
      },
      onQuality: (quality: DrawnQuality) => this.#host.tell('quality-change', quality),
      onCome: (error) => (error === undefined ? this.request() : this.#host.failed(error)),
    });
  }

  /** Gives back all that it has on the GPU. */
  close(): void {
    this.#drawing?.loop.cancel(this.#frame);
    this.#view?.dispose();
    this.#view = null;
    this.#visible = false;
    this.#lost = false;
    this.clock.pause();
  }

  plant({ grown, species }: Planted): void {
    this.#fresh = true;
    this.#view?.setTree(grown, species);
    this.#frameTree();
  }

  setLook(look: TreeLook): void {
    this.#view?.setLook(look);
    this.request();
  }

  /** CSS pixels. */
  resize(width: number, height: number): void {
    this.#size = [width, height];
    this.#frameTree();
  }

  /** It can be seen, or no longer. */
  show(visible: boolean): void {
    this.#visible = visible;
    if (visible) this.request();
    else this.#drawing?.loop.cancel(this.#frame);
  }

  /** Lets time run or stand; tells whether that is a change. */
  run(runs: boolean): boolean {
    const { clock } = this;
    if (runs === clock.playing) return false;
    if (runs) clock.play();
    else clock.pause();
    this.request();
    return true;
  }

  seek(seconds: number): void {
    this.clock.seek(seconds);
    this.#timeSet();
  }

  step(steps: number): void {
    this.clock.pause();
    this.clock.step(steps);
    this.#timeSet();
  }

  /** The attribute puts the camera somewhere; `glide`: there is a picture, in which it is seen to go there. */
  wishCamera(glide: boolean): void {
    this.orbit.wish(this.#host.cameraOrbit, glide && !reduced());
    // Before there is a picture nobody has seen it move.
    if (glide) this.moved('script');
  }

  turn(azimuth: number, elevation: number, glide: boolean): void {
    this.orbit.turn(azimuth, elevation, glide && !reduced());
    this.moved('user');
  }

  zoom(factor: number, glide: boolean): void {
    this.orbit.zoom(factor, glide && !reduced());
    this.moved('user');
  }

  reset(): void {
    this.orbit.wish(this.#host.cameraOrbit, !reduced());
    this.moved('user');
  }

  /** Stands at a pose. */
  place(pose: CameraPose): void {
    this.orbit.place(pose);
    this.moved('script');
  }

  toggle(): void {
    this.#host.toggle();
  }

  hold(on: boolean): void {
    this.#held = on;
    this.#canvas?.classList.toggle('turning', on);
    this.request();
  }

  moved(source: 'user' | 'script'): void {
    this.#cameraBy = source;
    this.request();
  }

  /** Something has changed: draws it, if it can be seen. */
  request(): void {
    if (this.#view?.grown && this.#visible && !this.#lost) this.#drawing?.loop.request(this.#frame);
  }

  #timeSet(): void {
    this.#host.tell('timeupdate', { time: this.clock.time });
    this.request();
  }

  #frameTree(): void {
    const [width, height] = this.#size;
    if (!this.#view || width === 0 || height === 0) return;
    this.#view.setSize(width, height);
    const whole = this.#view.whole();
    if (whole) this.orbit.frame(whole);
    this.request();
  }

  readonly #frame = (now: number): boolean => {
    const view = this.#view;
    const { clock, orbit } = this;
    if (!view || !this.#visible || this.#lost || this.#size[0] === 0) return false;
    clock.tick(now);
    const glided = orbit.step(now - this.#before);
    this.#before = now;
    const hurried = clock.playing || orbit.moving || this.#held;
    const figures = view.draw(clock.time, orbit.pose, hurried);
    if (!figures) return false;
    orbit.stoppedAt(figures.elevation);
    this.#figures = { triangles: figures.triangles, drawCalls: figures.drawCalls };
    if (this.#cameraBy && (glided || !orbit.moving)) {
      this.#host.tell('camera-change', { ...orbit.pose, source: this.#cameraBy });
      if (!orbit.moving) this.#cameraBy = null;
    }
    if (clock.playing && now - this.#told >= TOLD) {
      this.#told = now;
      this.#host.tell('timeupdate', { time: clock.time });
    }
    if (this.#fresh && !figures.unfinished) {
      this.#fresh = false;
      this.#host.seen();
    }
    return clock.playing || hurried || figures.unfinished;
  };
}
