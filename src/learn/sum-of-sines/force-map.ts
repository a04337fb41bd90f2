import type { FigureHost } from '../figure.ts';
import type { Plane } from '../plane.ts';

/** Pixels between the places at which the ground's colour and the arrows ask for the force. */
const CELL = 7;
const ARROWS = 36;

/** The ground from above: bluer where the force is larger, and arrows of it. */
export class ForceMap {
  readonly #host: FigureHost;
  readonly #sheet = document.createElement('canvas');

  constructor(host: FigureHost) {
    this.#host = host;
  }

  /** Draws over all that `plane` shows; `most`: the force of full colour, metres. */
  draw(plane: Plane, force: (x: number, y: number) => readonly [number, number], most: number): void {
    const [x0, y1] = plane.toPixel(plane.x[0], plane.y[1]);
    const [x1, y0] = plane.toPixel(plane.x[1], plane.y[0]);
    this.#ground(plane, force, most, [x0, y1, x1 - x0, y0 - y1]);
    const { force: colour } = this.#host.colours();
    const reach = (0.9 * ARROWS) / plane.scale[0] / most;
    for (let py = y1 + ARROWS / 2; py < y0; py += ARROWS) {
      for (let px = x0 + ARROWS / 2; px < x1; px += ARROWS) {
        const [x, y] = plane.toWorld(px, py);
        const [fx, fy] = force(x, y);
        const strength = Math.min(1, Math.hypot(fx, fy) / most);
        if (strength < 0.02) plane.dot([x, y], 1, { colour, alpha: 0.5 });
        else
          plane.arrow([x - (fx * reach) / 2, y - (fy * reach) / 2], [x + (fx * reach) / 2, y + (fy * reach) / 2], {
            colour,
            width: 0.8 + 1.2 * strength,
            alpha: 0.45 + 0.55 * strength,
          });
      }
    }
  }

  #ground(
    plane: Plane,
    force: (x: number, y: number) => readonly [number, number],
    most: number,
    [left, top, width, height]: readonly [number, number, number, number],
  ): void {
    const [across, down] = [Math.max(2, Math.ceil(width / CELL)), Math.max(2, Math.ceil(height / CELL))];
    const sheet = this.#sheet;
    if (sheet.width !== across) sheet.width = across;
    if (sheet.height !== down) sheet.height = down;
    const context = sheet.getContext('2d');
    if (!context) return;
    const image = context.createImageData(across, down);
    for (let j = 0; j < down; j++) {
      for (let i = 0; i < across; i++) {
        const [x, y] = plane.toWorld(left + ((i + 0.5) * width) / across, top + ((j + 0.5) * height) / down);
        const [fx, fy] = force(x, y);
        image.data[4 * (j * across + i) + 3] = 170 * Math.min(1, Math.hypot(fx, fy) / most);
      }
    }
    context.putImageData(image, 0, 0);
    // The alpha alone is the force; its colour is the page's.
    context.globalCompositeOperation = 'source-in';
    context.fillStyle = this.#host.colours().force;
    context.fillRect(0, 0, across, down);
    context.globalCompositeOperation = 'source-over';
    const { context: paper } = plane;
    paper.imageSmoothingEnabled = true;
    paper.imageSmoothingQuality = 'high';
    paper.drawImage(sheet, left, top, width, height);
  }
}
