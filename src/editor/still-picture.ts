import type { CameraPose } from '../core/link/link.ts';
import type { OnScreen, Picture, PictureEvents } from './picture.ts';

/** Draws the tree once for each change, where there is no WebGL2. */
export class StillPicture implements Picture {
  readonly canvas = document.createElement('canvas');
  readonly camera: CameraPose = { azimuth: 0, elevation: 0, distance: 1, target: [0, 0, 0] };
  readonly moving = false;
  constructor(host: HTMLElement, events: PictureEvents) {
    host.append(this.canvas);
    events.onChange();
  }
  setTree(): void {}
  setWind(): void {}
  show(): void {}
  setDark(): void {}
  setInsets(): void {}
  setCamera(): void {}
  draw() {
    return { triangles: 0, drawCalls: 0, frame: 0, wind: 0, draw: 0 };
  }
  tips(): Float32Array {
    return new Float32Array(0);
  }
  onScreen(): OnScreen {
    return { branches: [], horizon: 0 };
  }
  capture(): string {
    return this.canvas.toDataURL();
  }
}
