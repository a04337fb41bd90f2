import type { PerspectiveCamera } from 'three';
import type { Handle } from '../overlay/handle.ts';
import { type Area, groundTowards, windowPoint } from './aim.ts';
import type { Grip } from './hands.ts';

/** Pixels that a finger may be beside the arrow: it is a line, not a knob. */
const SLACK = 6;

/** Where the picture is, and who is told. */
export interface HandleView {
  /** The rectangle that the camera's picture fills, as it stands in the pane at x. */
  areaAt(x: number): Area;
  readonly camera: PerspectiveCamera;
  tell(direction: number, strength: number, done: boolean): void;
  redraw(): void;
}

/** The wind's handle as something to drag: its knob, and the arrow that starts there. */
export class HandleGrip implements Grip {
  readonly cursor = 'grab';
  private readonly handle: Handle;
  private readonly view: HandleView;
  /** Where it was looked for last. */
  private area: Area = { left: 0, top: 0, width: 1, height: 1 };

  constructor(handle: Handle, view: HandleView) {
    this.handle = handle;
    this.view = view;
  }

  distance(x: number, y: number): number | null {
    if (!this.handle.visible) return null;
    this.area = this.view.areaAt(x);
    const knob = this.knob();
    const tip = this.at(0.82 * this.handle.shape.x);
    if (!knob || !tip) return null;
    const [ax, ay] = [tip.x - knob.x, tip.y - knob.y];
    const along = ((x - knob.x) * ax + (y - knob.y) * ay) / (ax * ax + ay * ay || 1);
    const part = Math.min(1, Math.max(0, along));
    const beside = Math.hypot(x - knob.x - part * ax, y - knob.y - part * ay) + SLACK;
    return Math.min(Math.hypot(x - knob.x, y - knob.y), beside);
  }

  anchor(): { x: number; y: number } {
    return this.knob() ?? { x: 0, y: 0 };
  }

  drag(x: number, y: number, done: boolean): void {
    const { handle, view } = this;
    // Beyond the rings the strength is full, and the sky is the far side of the meadow.
    const ground = groundTowards(x, y, this.area, view.camera, view.camera.position.length() + 4 * handle.shape.y);
    const { direction, strength } = handle.placeOf(ground.x, ground.y);
    handle.set(direction, strength);
    view.redraw();
    view.tell(direction, strength, done);
  }

  hover(on: boolean): void {
    this.handle.held = on;
    this.view.redraw();
  }

  private knob(): { x: number; y: number } | null {
    return this.at(this.handle.radiusOf(this.handle.place.strength));
  }

  /** The point upwind of the tree, `radius` metres away, in the window. */
  private at(radius: number): { x: number; y: number } | null {
    const { direction } = this.handle.place;
    const { camera } = this.view;
    return windowPoint(
      -radius * Math.cos(direction),
      -radius * Math.sin(direction),
      this.handle.shape.z,
      this.area,
      camera,
    );
  }
}
