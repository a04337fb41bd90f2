/** What hands and keys ask of the camera and of time. */
export interface OrbitWishes {
  /** Degrees to the right and up; `glide`: in a sweep, as a key asks for it. */
  turn(azimuth: number, elevation: number, glide: boolean): void;
  /** Nearer (below 1) or farther. */
  zoom(factor: number, glide: boolean): void;
  /** The whole tree again. */
  reset(): void;
  /** Plays what is paused, and the other way round. */
  toggle(): void;
  /** A pointer holds the camera, or has let it go. */
  hold(on: boolean): void;
}

/** Degrees that a drag over the height of the picture turns; that one press of a key does. */
const DRAG = 180;
const STEP = 12;

/** Factor of a press of a key, and of the wheel for each pixel that it would scroll. */
const NEARER = 0.86;
const WHEEL = 0.0016;

/** Pixels of a line, where the wheel counts in lines. */
const LINE = 16;

const TURNS: Readonly<Record<string, readonly [azimuth: number, elevation: number]>> = {
  ArrowLeft: [-STEP, 0],
  ArrowRight: [STEP, 0],
  ArrowUp: [0, STEP],
  ArrowDown: [0, -STEP],
};

/** Listens on `canvas` while `enabled` says so: drag and arrows turn, pinch, wheel and plus and minus zoom. The listeners go with the canvas. */
export function listenToOrbit(canvas: HTMLCanvasElement, enabled: () => boolean, wishes: OrbitWishes): void {
  const pointers = new Map<number, { x: number; y: number }>();
  const spread = (): number => {
    const [a, b] = [...pointers.values()];
    return a && b ? Math.hypot(a.x - b.x, a.y - b.y) : 0;
  };
  canvas.addEventListener('pointerdown', (event) => {
    if (!enabled() || event.button !== 0 || pointers.size > 1) return;
    pointers.set(event.pointerId, { x: event.clientX, y: event.clientY });
    canvas.setPointerCapture(event.pointerId);
    if (pointers.size === 1) wishes.hold(true);
  });
  canvas.addEventListener('pointermove', (event) => {
    const at = pointers.get(event.pointerId);
    if (!at) return;
    const before = spread();
    const [dx, dy] = [event.clientX - at.x, event.clientY - at.y];
    at.x = event.clientX;
    at.y = event.clientY;
    if (pointers.size > 1) {
      const after = spread();
      if (before > 0 && after > 0) wishes.zoom(before / after, false);
      return;
    }
    const degrees = DRAG / Math.max(1, canvas.clientHeight);
    wishes.turn(-dx * degrees, dy * degrees, false);
  });
  const letGo = (event: PointerEvent): void => {
    if (pointers.delete(event.pointerId) && pointers.size === 0) wishes.hold(false);
  };
  // The browser takes the pointer where it scrolls the page instead.
  for (const name of ['pointerup', 'pointercancel', 'lostpointercapture'] as const)
    canvas.addEventListener(name, letGo);
  canvas.addEventListener(
    'wheel',
    (event) => {
      // Over a picture that nobody has chosen the wheel scrolls the page; with Ctrl it is a pinch.
      const chosen = event.ctrlKey || (canvas.getRootNode() as ShadowRoot).activeElement === canvas;
      if (!enabled() || !chosen) return;
      event.preventDefault();
      wishes.zoom(Math.exp(event.deltaY * (event.deltaMode === 1 ? LINE : 1) * WHEEL), true);
    },
    { passive: false },
  );
  canvas.addEventListener('keydown', (event) => {
    if (!enabled() || event.ctrlKey || event.metaKey || event.altKey) return;
    const turn = TURNS[event.key];
    if (turn) wishes.turn(...turn, true);
    else if (event.key === '+' || event.key === '=') wishes.zoom(NEARER, true);
    else if (event.key === '-' || event.key === '_') wishes.zoom(1 / NEARER, true);
    else if (event.key === 'Home') wishes.reset();
    else if (event.key === ' ') wishes.toggle();
    else return;
    event.preventDefault();
  });
}
