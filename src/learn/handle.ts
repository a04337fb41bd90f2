/** Something in a stage that can be dragged: a round button over the canvas, which the arrow keys move, too. */
export interface Handle {
  readonly id: string;
  /** What it is, for screen readers: "Tip of the branch". */
  readonly label: string;
  /** CSS pixels from the stage's upper left corner. */
  readonly x: number;
  readonly y: number;
  /** Which ways it goes: the cursor and the arrow keys tell; default both. */
  readonly ways?: 'both' | 'across' | 'up';
  /** Pixels a press of an arrow key; ten times that with Shift. Default 4. */
  readonly step?: number;
  /** Its colour as CSS; default that of ink. */
  readonly colour?: string;
  /** Where it stands, as it is spoken: "12.5 metres". */
  readonly said?: string;
  /** Called with where it is dragged to, CSS pixels. */
  move(x: number, y: number): void;
  /** What the arrow keys do in place of `move`, for one that goes round: 1 for right and up, -1 for left and down; ten with Shift. */
  turn?(steps: number): void;
}

const ARROWS: Readonly<Record<string, readonly [number, number]>> = {
  ArrowLeft: [-1, 0],
  ArrowRight: [1, 0],
  ArrowUp: [0, -1],
  ArrowDown: [0, 1],
};

/** Pixels that an arrow key tries at most, until something changes: the steps of a control may be farther apart than those of the handle. */
const FARTHEST = 80;

/** Whom a layer of handles tells and asks. */
export interface HandleHost {
  /** A move has ended. */
  moved(): void;
  /** Another object once a move has changed something. */
  state(): unknown;
}

/** Moves a handle by an arrow key, as far as it takes for `state` to change; false for any other key. */
export function pressed(handle: Handle, key: string, times: number, state: () => unknown): boolean {
  const way = ARROWS[key];
  if (!way) return false;
  const [across, down] = way;
  const { x, y, step = 4 } = handle;
  if (handle.turn) {
    handle.turn((across - down) * times);
    return true;
  }
  const before = state();
  const farthest = Math.max(FARTHEST, step * times);
  for (let far = step * times; far <= farthest && state() === before; far += step)
    handle.move(x + across * far, y + down * far);
  return true;
}

/** The buttons over one stage: as many as the stage has handles, kept while they are dragged. */
export class HandleLayer {
  readonly #stage: HTMLElement;
  readonly #buttons = new Map<string, { readonly button: HTMLButtonElement; handle: Handle }>();
  readonly #host: HandleHost;
  /** One of them is dragged. */
  held = false;

  constructor(stage: HTMLElement, host: HandleHost) {
    this.#stage = stage;
    this.#host = host;
  }

  show(handles: readonly Handle[]): void {
    const left = new Set(this.#buttons.keys());
    for (const handle of handles) {
      left.delete(handle.id);
      const known = this.#buttons.get(handle.id);
      const { button } = known ?? this.#make(handle);
      if (known) known.handle = handle;
      button.style.left = `${handle.x}px`;
      button.style.top = `${handle.y}px`;
      button.style.setProperty('--handle', handle.colour ?? 'var(--ink)');
      button.setAttribute('aria-label', handle.said ? `${handle.label}: ${handle.said}` : handle.label);
    }
    for (const id of left) {
      this.#buttons.get(id)?.button.remove();
      this.#buttons.delete(id);
    }
  }

  #make(handle: Handle): { readonly button: HTMLButtonElement; handle: Handle } {
    const button = document.createElement('button');
    button.type = 'button';
    button.className = 'handle';
    button.dataset.handle = handle.id;
    button.dataset.ways = handle.ways ?? 'both';
    button.setAttribute('aria-roledescription', 'handle, move it with the arrow keys');
    const kept = { button, handle };
    this.#buttons.set(handle.id, kept);
    this.#stage.append(button);
    // Where in the handle it was taken: it does not jump to the pointer.
    let grip: readonly [number, number] | null = null;
    button.addEventListener('pointerdown', (event) => {
      if (event.button !== 0) return;
      button.setPointerCapture(event.pointerId);
      grip = [event.clientX - kept.handle.x, event.clientY - kept.handle.y];
      this.held = true;
    });
    button.addEventListener('pointermove', (event) => {
      if (grip) kept.handle.move(event.clientX - grip[0], event.clientY - grip[1]);
    });
    button.addEventListener('lostpointercapture', () => {
      this.held = false;
      if (grip) this.#host.moved();
      grip = null;
    });
    button.addEventListener('keydown', (event) => {
      if (event.ctrlKey || event.metaKey || event.altKey) return;
      if (!pressed(kept.handle, event.key, event.shiftKey ? 10 : 1, this.#host.state)) return;
      event.preventDefault();
      this.#host.moved();
    });
    return kept;
  }
}
