/** Radians a pixel of a drag, and a press of an arrow key. */
const PER_PIXEL = 0.008;
const PER_KEY = 0.12;

const KEYS: Readonly<Record<string, readonly [number, number]>> = {
  ArrowLeft: [-1, 0],
  ArrowRight: [1, 0],
  ArrowUp: [0, 1],
  ArrowDown: [0, -1],
};

/** Turns a picture by a drag on its canvas or the arrow keys. A finger that goes up or down scrolls the page. */
export class OrbitHand {
  /** Radians about the vertical, and above where the view began. */
  azimuth = 0;
  elevation = 0;
  readonly #canvas: HTMLCanvasElement;
  readonly #ended = new AbortController();

  constructor(canvas: HTMLCanvasElement, turned: () => void) {
    this.#canvas = canvas;
    canvas.tabIndex = 0;
    canvas.style.touchAction = 'pan-y';
    canvas.style.cursor = 'grab';
    const { signal } = this.#ended;
    let held = false;
    const turn = (across: number, up: number): void => {
      this.azimuth += across;
      this.elevation = Math.min(1.2, Math.max(-0.6, this.elevation + up));
      turned();
    };
    canvas.addEventListener(
      'pointerdown',
      (event) => {
        if (event.button !== 0) return;
        held = true;
        canvas.setPointerCapture(event.pointerId);
      },
      { signal },
    );
    canvas.addEventListener(
      'pointermove',
      ({ movementX, movementY }) => {
        if (held) turn(-movementX * PER_PIXEL, movementY * PER_PIXEL);
      },
      { signal },
    );
    canvas.addEventListener(
      'lostpointercapture',
      () => {
        held = false;
      },
      { signal },
    );
    canvas.addEventListener(
      'keydown',
      (event) => {
        const way = KEYS[event.key];
        if (!way || event.ctrlKey || event.metaKey || event.altKey) return;
        event.preventDefault();
        turn(way[0] * PER_KEY, way[1] * PER_KEY);
      },
      { signal },
    );
  }

  /** Back to where the view began. */
  reset(): void {
    this.azimuth = 0;
    this.elevation = 0;
  }

  dispose(): void {
    this.#ended.abort();
    this.#canvas.removeAttribute('tabindex');
  }
}
