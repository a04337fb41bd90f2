/** Pixels around a grip that still hold it, for a mouse and for a finger (44 px across). */
const NEAR = { mouse: 16, touch: 24 } as const;

/** Pixels that a click may wander. */
const STILL = 5;

/** Something that can be dragged over the picture. */
export interface Grip {
  /** How far a point of the window is from it, CSS pixels; null: it is not there. */
  distance(x: number, y: number): number | null;
  /** Where it is held, so that it does not leap to the pointer. */
  anchor(): { x: number; y: number };
  /** `done`: the reader let go. */
  drag(x: number, y: number, done: boolean): void;
  /** The reader points at it or holds it, or no more. */
  hover(on: boolean): void;
  readonly cursor: string;
}

/** What lies under hands. */
export interface Reach {
  readonly canvas: HTMLElement;
  /** The first that is near enough is taken. */
  readonly grips: readonly Grip[];
  /** The camera must keep still while a grip is held. */
  hold(on: boolean): void;
  /** A pointer went down that may become a click. */
  press(x: number, y: number): void;
  /** A click that was no drag. */
  click(x: number, y: number): void;
}

/** Pointers on the picture: grips come before the camera, and what is neither is a click. */
export class Hands {
  private readonly reach: Reach;
  private held: { grip: Grip; pointer: number; x: number; y: number } | null = null;
  private over: Grip | null = null;
  private idle = '';
  private pressed: { pointer: number; x: number; y: number } | null = null;

  constructor(reach: Reach) {
    this.reach = reach;
    const { canvas } = reach;
    // Before the camera's own listeners, which were there first: a grip that is held turns no camera.
    canvas.addEventListener('pointerdown', this.down, { capture: true });
    canvas.addEventListener('pointermove', this.move);
    canvas.addEventListener('pointerup', this.up);
    canvas.addEventListener('pointercancel', this.cancel);
    canvas.addEventListener('lostpointercapture', this.cancel);
    canvas.addEventListener('pointerleave', () => this.point(null));
  }

  /** The pointer where there is nothing to hold. */
  set cursor(cursor: string) {
    this.idle = cursor;
    if (!this.over) this.reach.canvas.style.cursor = cursor;
  }

  /** A grip is held now. */
  get busy(): boolean {
    return this.held !== null;
  }

  /** The mouse is over a grip. */
  get pointing(): boolean {
    return this.over !== null;
  }

  private gripAt(event: PointerEvent): Grip | null {
    const near = event.pointerType === 'mouse' ? NEAR.mouse : NEAR.touch;
    for (const grip of this.reach.grips) {
      const distance = grip.distance(event.clientX, event.clientY);
      if (distance !== null && distance <= near) return grip;
    }
    return null;
  }

  private readonly down = (event: PointerEvent): void => {
    if (this.held) {
      event.stopImmediatePropagation();
      return;
    }
    // A second finger means the camera, not a click.
    this.pressed = this.pressed || event.button !== 0 ? null : this.at(event);
    const grip = event.button === 0 && event.isPrimary ? this.gripAt(event) : null;
    if (!grip) {
      if (this.pressed) this.reach.press(event.clientX, event.clientY);
      return;
    }
    event.stopImmediatePropagation();
    event.preventDefault();
    this.pressed = null;
    const anchor = grip.anchor();
    this.held = { grip, pointer: event.pointerId, x: anchor.x - event.clientX, y: anchor.y - event.clientY };
    this.reach.hold(true);
    this.reach.canvas.setPointerCapture(event.pointerId);
    this.point(grip);
  };

  private readonly move = (event: PointerEvent): void => {
    const { held } = this;
    if (held?.pointer === event.pointerId) held.grip.drag(event.clientX + held.x, event.clientY + held.y, false);
    else if (!held && event.pointerType === 'mouse' && event.buttons === 0) this.point(this.gripAt(event));
  };

  private readonly up = (event: PointerEvent): void => {
    const { held, pressed } = this;
    if (held?.pointer === event.pointerId) {
      this.release(event.clientX + held.x, event.clientY + held.y);
      return;
    }
    this.pressed = null;
    if (pressed?.pointer !== event.pointerId) return;
    if (Math.hypot(event.clientX - pressed.x, event.clientY - pressed.y) > STILL) return;
    this.reach.click(event.clientX, event.clientY);
  };

  private readonly cancel = (event: PointerEvent): void => {
    const { held } = this;
    this.pressed = null;
    if (held?.pointer !== event.pointerId) return;
    const anchor = held.grip.anchor();
    this.release(anchor.x, anchor.y);
  };

  private release(x: number, y: number): void {
    const { held } = this;
    if (!held) return;
    this.held = null;
    held.grip.drag(x, y, true);
    this.reach.hold(false);
    this.point(null);
  }

  private point(grip: Grip | null): void {
    if (this.held && grip !== this.held.grip) return;
    if (grip === this.over) return;
    this.over?.hover(false);
    this.over = grip;
    grip?.hover(true);
    this.reach.canvas.style.cursor = grip ? grip.cursor : this.idle;
  }

  private at(event: PointerEvent): { pointer: number; x: number; y: number } {
    return { pointer: event.pointerId, x: event.clientX, y: event.clientY };
  }
}
