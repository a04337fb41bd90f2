import type { Box3 } from 'three';
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';
import { AZIMUTH, BareStage, EMPTY, FOV, type StageOptions } from './bare-stage.ts';
import { type Framing, frameTree } from './framing.ts';
import type { StageLook } from './stage-look.ts';

export { AZIMUTH, FOV, type StageOptions } from './bare-stage.ts';

/** Pixels of the picture that something else covers: the tree is framed in what is left. */
export interface Insets {
  readonly top: number;
  readonly right: number;
  readonly bottom: number;
  readonly left: number;
}

/** How a photograph differs from what stage and camera give. */
export interface Shot {
  /** The light as it is exposed. */
  readonly look: (look: StageLook) => StageLook;
  /** Puts another lens on the camera for one drawing; what it returns takes it off. */
  readonly aim: (stage: Stage) => () => void;
}

/** A part of the picture that is drawn by itself: its left edge and width in CSS pixels, and how far the view's middle is moved right. */
export interface StagePane {
  readonly left: number;
  readonly width: number;
  readonly shift: number;
  /** Called before it is drawn: shows what belongs there. */
  readonly before: () => void;
}

const NO_INSETS: Insets = { top: 0, right: 0, bottom: 0, left: 0 };

/** How far the camera goes away, in reaches of the tree. */
const FARTHEST = 9;

/** A meadow under the sky for one tree: renderer, camera, sun, ground, orbit. */
export class Stage extends BareStage {
  readonly controls: OrbitControls;
  #insets = NO_INSETS;
  #settling = 0;
  #shot: Shot | null = null;

  /** Draws on `canvas`. Throws where the browser gives no WebGL2 context. */
  constructor(canvas: HTMLCanvasElement, options: StageOptions = {}) {
    super(canvas, options);
    this.controls = new OrbitControls(this.camera, canvas);
    this.controls.target = this.target;
    this.controls.enableDamping = true;
    this.controls.dampingFactor = 0.08;
    this.controls.zoomToCursor = true;
    this.controls.screenSpacePanning = true;
    this.controls.addEventListener('change', () => {
      this.#settling = 2;
    });
    this.frame(EMPTY);
  }

  /** Keeps the middle of the view clear of what covers the picture's edges. */
  setInsets(insets: Insets): void {
    this.#insets = insets;
    this.shape();
  }

  /** null: neither exposure nor lens of its own. */
  set shot(shot: Shot | null) {
    this.#shot = shot;
    this.relight();
  }

  protected override look(): StageLook {
    const look = super.look();
    return this.#shot?.look(look) ?? look;
  }

  override setSubject(box: Box3, foot?: number): number {
    const reach = super.setSubject(box, foot);
    this.controls.minDistance = 0.02 * reach;
    this.controls.maxDistance = FARTHEST * reach;
    return reach;
  }

  /** Shows the whole of a box in metres, y up, in a window of any shape, or in each of `columns` equal parts of it. */
  frame(box: Box3, { azimuth = AZIMUTH, columns = 1 }: { azimuth?: number; columns?: number } = {}): Framing {
    this.setSubject(box);
    const { top, right, bottom, left } = this.#insets;
    const clear = Math.max(1, this.height - top - bottom);
    // The insets shift the middle of the view; what is left of the window has a narrower field of view.
    const part = clear / this.height;
    const fov = (2 * Math.atan(Math.tan((FOV * Math.PI) / 360) * part) * 180) / Math.PI;
    const wide = Math.max(1, (this.width - left - right) / columns);
    const framing = frameTree(box, fov, wide / clear, azimuth);
    // A low window, or one of two columns, has the whole tree from very far.
    const distance = framing.position.distanceTo(framing.target);
    this.controls.maxDistance = Math.max(this.controls.maxDistance, 1.1 * distance);
    this.camera.position.copy(framing.position);
    this.controls.target.copy(framing.target);
    this.controls.update();
    return framing;
  }

  /** The camera still moves by itself: draw again. */
  get moving(): boolean {
    return this.#settling > 0;
  }

  /** Draws, the whole picture or its panes. `shadows`: what casts them has moved since the last time. */
  override render(shadows = true, panes: readonly StagePane[] = []): void {
    const { camera, controls, renderer } = this;
    if (this.#settling > 0) this.#settling--;
    controls.maxPolarAngle = this.lowest(camera.position.distanceTo(this.target));
    controls.update();
    const back = this.#shot?.aim(this);
    this.see();
    if (panes.length < 2) {
      panes[0]?.before();
      renderer.shadowMap.needsUpdate ||= shadows;
      renderer.render(this.scene, camera);
    } else this.#renderPanes(panes);
    back?.();
  }

  #renderPanes(panes: readonly StagePane[]): void {
    const { renderer, camera } = this;
    const { info } = renderer;
    info.reset();
    info.autoReset = false; // the figures are those of the whole picture
    renderer.setScissorTest(true);
    for (const { left, width, shift, before } of panes) {
      if (width <= 0) continue;
      before();
      this.shape(shift);
      renderer.setScissor(left, 0, width, this.height);
      // The same map serves one pane after the other: what casts the shadows is not the same in both.
      renderer.shadowMap.needsUpdate = true;
      renderer.render(this.scene, camera);
    }
    this.#divide(panes[1]?.left ?? 0);
    renderer.setScissorTest(false);
    info.autoReset = true;
    this.shape();
  }

  /** A line between two panes: dark within light, so that it shows on sky and leaves alike. */
  #divide(x: number): void {
    const { renderer } = this;
    if (x <= 0 || x >= this.width) return;
    for (const [colour, half] of [
      ['#fbfaf6', 1.5],
      ['#1d2021', 0.5],
    ] as const) {
      renderer.setScissor(x - half, 0, 2 * half, this.height);
      renderer.setClearColor(colour, 1);
      renderer.clear(true, false, false);
    }
  }

  override dispose(): void {
    this.controls.dispose();
    super.dispose();
  }

  /** `shift`: how far right of the middle of what is clear the middle of the view lies, CSS pixels. */
  protected override shape(shift = 0): void {
    const { top, right, bottom, left } = this.#insets;
    const { camera } = this;
    camera.aspect = this.width / this.height;
    if (top || right || bottom || left || shift) {
      camera.setViewOffset(
        this.width,
        this.height,
        (right - left) / 2 - shift,
        (bottom - top) / 2,
        this.width,
        this.height,
      );
    } else {
      camera.clearViewOffset();
    }
    camera.updateProjectionMatrix();
  }
}
