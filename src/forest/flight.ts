import type { ForestCamera } from '../core/forest/forest.ts';

/** Metres: the eye of somebody who stands. */
export const LOWEST = 1.7;

/** Metres a second, and how much faster with Shift. */
const SPEED = 9;
const FASTER = 4;

/** Degrees a second by keys. */
const TURN = 60;

/** Seconds in which a speed is reached and lost. */
const EASE = 0.16;

/** Metres a notch of the wheel, and a pixel of two fingers. */
const NOTCH = 0.06;
const FINGER = 0.08;

const STEEPEST = 85;

/** What a key does: ahead, right, up in metres; turn left, look up. */
const MOVES: Readonly<Record<string, readonly [number, number, number, number, number]>> = {
  KeyW: [1, 0, 0, 0, 0],
  ArrowUp: [1, 0, 0, 0, 0],
  KeyS: [-1, 0, 0, 0, 0],
  ArrowDown: [-1, 0, 0, 0, 0],
  KeyA: [0, -1, 0, 0, 0],
  KeyD: [0, 1, 0, 0, 0],
  KeyQ: [0, 0, -1, 0, 0],
  KeyE: [0, 0, 1, 0, 0],
  ArrowLeft: [0, 0, 0, 1, 0],
  ArrowRight: [0, 0, 0, -1, 0],
  PageUp: [0, 0, 0, 0, 1],
  PageDown: [0, 0, 0, 0, -1],
};

/** Whether keys belong to what has the focus. */
const typing = (target: EventTarget | null): boolean =>
  target instanceof HTMLElement && target.closest('input, select, textarea') !== null;

type Eye = { -readonly [Key in keyof ForestCamera]: ForestCamera[Key] };

/** Flies an eye through the forest by mouse, wheel, keys and fingers; it never goes under the ground nor out of sight of it. */
export class Flight {
  readonly eye: Eye = { x: 0, y: 0, z: LOWEST, yaw: 90, pitch: 0 };
  /** Metres of the ground under a place. */
  groundAt: (x: number, y: number) => number = () => 0;
  /** Metres of a side of the ground. */
  size = 500;
  /** Degrees that the height of the picture shows. */
  fov = 45;
  readonly #canvas: HTMLElement;
  readonly #held = new Set<string>();
  /** Keys that were pressed since the last frame, though they may be up again. */
  readonly #tapped = new Set<string>();
  readonly #pointers = new Map<number, { x: number; y: number }>();
  readonly #speed = [0, 0, 0, 0, 0];
  /** Metres ahead, right and up that are still to go. */
  readonly #rest = [0, 0, 0];
  #fast = false;
  #last: readonly number[] = [];

  constructor(canvas: HTMLElement) {
    this.#canvas = canvas;
    canvas.addEventListener('pointerdown', (event) => this.#down(event));
    canvas.addEventListener('pointermove', (event) => this.#drag(event));
    for (const end of ['pointerup', 'pointercancel', 'lostpointercapture'] as const)
      canvas.addEventListener(end, (event) => void this.#pointers.delete(event.pointerId));
    canvas.addEventListener('wheel', (event) => this.#wheel(event), { passive: false });
    window.addEventListener('keydown', (event) => this.#key(event, true));
    window.addEventListener('keyup', (event) => this.#key(event, false));
    window.addEventListener('blur', () => this.#held.clear());
  }

  /** Sets the eye down; null: at the south edge, looking north over the forest. */
  place(camera: ForestCamera | null): void {
    const south = -0.5 * this.size + 8;
    Object.assign(this.eye, camera ?? { x: 0, y: south, z: this.groundAt(0, south) + 6, yaw: 90, pitch: 0 });
    this.#speed.fill(0);
    this.#rest.fill(0);
    this.hold();
  }

  /** Keeps the eye over the ground. */
  hold(): void {
    const { eye, size } = this;
    const edge = 0.5 * size + 40;
    eye.x = Math.min(edge, Math.max(-edge, eye.x));
    eye.y = Math.min(edge, Math.max(-edge, eye.y));
    const ground = this.groundAt(eye.x, eye.y);
    eye.z = Math.min(ground + Math.max(100, size), Math.max(ground + LOWEST, eye.z));
    eye.yaw = ((eye.yaw % 360) + 360) % 360;
    eye.pitch = Math.min(STEEPEST, Math.max(-STEEPEST, eye.pitch));
  }

  /** Goes on for `seconds`; whether the eye has moved since the last time. */
  update(seconds: number): boolean {
    const wished = [0, 0, 0, 0, 0];
    for (const code of new Set([...this.#held, ...this.#tapped])) {
      MOVES[code]?.forEach((move, i) => {
        wished[i]! += move;
      });
    }
    this.#tapped.clear();
    const part = 1 - Math.exp(-seconds / EASE);
    const times = SPEED * (this.#fast ? FASTER : 1);
    wished.forEach((wish, i) => {
      const aim = i < 3 ? wish * times : wish * TURN;
      this.#speed[i]! += (aim - this.#speed[i]!) * part;
      if (aim === 0 && Math.abs(this.#speed[i]!) < 0.01) this.#speed[i] = 0;
    });
    const { eye } = this;
    eye.yaw += this.#speed[3]! * seconds;
    eye.pitch += this.#speed[4]! * seconds;
    const go = this.#rest.map((rest, i) => {
      const now = Math.abs(rest) < 0.005 ? rest : rest * part;
      this.#rest[i] = rest - now;
      return now + this.#speed[i]! * seconds;
    });
    this.#go(go as [number, number, number]);
    this.hold();
    const now = [eye.x, eye.y, eye.z, eye.yaw, eye.pitch];
    const moved = now.some((value, i) => value !== this.#last[i]);
    this.#last = now;
    return moved;
  }

  /** Metres ahead (where it looks), right and up. */
  #go([ahead, right, up]: readonly [number, number, number]): void {
    const { eye } = this;
    const yaw = (eye.yaw * Math.PI) / 180;
    const pitch = (eye.pitch * Math.PI) / 180;
    const level = Math.cos(pitch) * ahead;
    eye.x += Math.cos(yaw) * level + Math.sin(yaw) * right;
    eye.y += Math.sin(yaw) * level - Math.cos(yaw) * right;
    eye.z += Math.sin(pitch) * ahead + up;
  }

  #key(event: KeyboardEvent, down: boolean): void {
    this.#fast = event.shiftKey;
    if (!(event.code in MOVES)) return;
    if (!down) return void this.#held.delete(event.code);
    if (event.ctrlKey || event.metaKey || event.altKey || typing(event.target)) return;
    event.preventDefault();
    this.#held.add(event.code);
    this.#tapped.add(event.code);
  }

  #down(event: PointerEvent): void {
    if (event.pointerType === 'mouse' && event.button !== 0) return;
    this.#canvas.focus({ preventScroll: true });
    this.#canvas.setPointerCapture(event.pointerId);
    this.#pointers.set(event.pointerId, { x: event.clientX, y: event.clientY });
  }

  #drag(event: PointerEvent): void {
    const from = this.#pointers.get(event.pointerId);
    if (!from) return;
    const to = { x: event.clientX, y: event.clientY };
    const dx = to.x - from.x;
    const dy = to.y - from.y;
    const other = [...this.#pointers].find(([id]) => id !== event.pointerId)?.[1];
    this.#pointers.set(event.pointerId, to);
    if (!other) {
      // The picture goes with the pointer, as if it were held.
      const degrees = this.fov / Math.max(1, this.#canvas.clientHeight);
      this.eye.yaw += dx * degrees;
      this.eye.pitch += dy * degrees;
      return;
    }
    const apart = Math.hypot(to.x - other.x, to.y - other.y) - Math.hypot(from.x - other.x, from.y - other.y);
    this.#push((apart + dy / 2) * FINGER, (-dx / 2) * FINGER);
  }

  #wheel(event: WheelEvent): void {
    event.preventDefault();
    const pixels = event.deltaY * (event.deltaMode === 1 ? 16 : event.deltaMode === 2 ? 400 : 1);
    this.#push(-pixels * NOTCH * (event.shiftKey ? FASTER : 1), 0);
  }

  #push(ahead: number, right: number): void {
    this.#rest[0]! += ahead;
    this.#rest[1]! += right;
  }
}
