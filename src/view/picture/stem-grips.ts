import { POSE_TARGETS, TEXEL } from '../../core/pack/layout.ts';
import type { PackedTree } from '../../core/pack/packed.ts';
import type { StemEnds } from '../overlay/stem-ends.ts';
import type { Grip } from './hands.ts';
import type { StemHandle, StemHandleChange } from './picture.ts';
import {
  draggedCurve,
  draggedDown,
  draggedLength,
  handlePlaces,
  type Pixel,
  type StemPoses,
  type StemStance,
  type StemView,
  stemStance,
} from './stem-stance.ts';

/** What the handles of a stem are to hands. */
export interface StemGripsView {
  /** The stem that bears handles now; null: none. */
  ends(): StemEnds | null;
  view(x: number): StemView;
  readPiece(piece: number): Promise<Float32Array | null>;
  /** Shows a handle at rest, pointed at or held. */
  mark(kind: StemHandle, how: 'rest' | 'hover' | 'held'): void;
  tell(kind: StemHandle, change: StemHandleChange, done: boolean): void;
  redraw(): void;
}

const CURSORS: Readonly<Record<StemHandle, string>> = { length: 'grab', down: 'grab', curve: 'grab' };

/** A handle that is dragged: the stem as it stood, where the handle was, and how far it has come. */
interface Drag {
  readonly kind: StemHandle;
  readonly stance: StemStance;
  readonly view: StemView;
  readonly from: Pixel;
  last: Pixel;
  degrees: number;
}

/**
 * The handles of the selected stem as things to drag.
 *
 * They are drawn where the GPU has the stem; hands look for them in a pose that was read back a moment ago. A drag is measured against
 * the stem as it stood when it was taken, whatever grows in its place meanwhile.
 */
export class StemGrips {
  readonly grips: readonly Grip[];
  readonly #of: StemGripsView;
  #tree: PackedTree | null = null;
  #poses: { readonly ends: StemEnds; readonly poses: StemPoses } | null = null;
  #reading = false;
  #drag: Drag | null = null;
  /** Where it was looked for last: in which of two panes. */
  #x = 0;

  constructor(of: StemGripsView) {
    this.#of = of;
    this.grips = (['length', 'curve', 'down'] as const).map((kind) => this.#grip(kind));
  }

  /** A handle is held. */
  get busy(): boolean {
    return this.#drag !== null;
  }

  setTree(tree: PackedTree): void {
    this.#tree = tree;
    this.#poses = null;
  }

  /** Reads where the stem stands, without holding up a frame; call it after each drawing. */
  look(): void {
    const ends = this.#of.ends();
    const tree = this.#tree;
    if (!ends || this.#reading || !tree) return;
    this.#reading = true;
    const places = [ends.base, ends.middle, ends.tip, ends.parent];
    const done = (read: readonly (Float32Array | null)[]): void => {
      this.#reading = false;
      const [base, middle, tip, parent] = read;
      if (tree !== this.#tree || !base || !middle || !tip) return;
      this.#poses = { ends, poses: { base, middle, tip, parent: parent ?? null } };
    };
    Promise.all(places.map((place) => (place ? this.#of.readPiece(place.piece) : null))).then(done, () => done([]));
  }

  /** The handles that can be held, in the window. */
  onScreen(): Readonly<Partial<Record<StemHandle, readonly [number, number]>>> {
    const places = Object.entries(this.#places(this.#x) ?? {});
    return Object.fromEntries(places.flatMap(([kind, at]) => (at ? [[kind, [at.x, at.y]]] : [])));
  }

  /** The stem as it stands, or before that is known as it rests. */
  #stance(): StemStance | null {
    const ends = this.#of.ends();
    const tree = this.#tree;
    if (!ends || !tree) return null;
    const known = this.#poses?.ends.stem === ends.stem ? this.#poses.poses : restOf(tree, ends);
    return stemStance(known, ends);
  }

  #places(x: number) {
    const stance = this.#stance();
    const ends = this.#of.ends();
    if (!stance || !ends) return null;
    const places = handlePlaces(stance, this.#of.view(x));
    return ends.down ? places : { ...places, down: null };
  }

  #grip(kind: StemHandle): Grip {
    return {
      cursor: CURSORS[kind],
      distance: (x, y) => {
        this.#x = x;
        const places = this.#places(x);
        if (!places) return null;
        const away = (at: Pixel | null): number => (at ? Math.hypot(x - at.x, y - at.y) : Number.POSITIVE_INFINITY);
        const own = away(places[kind]);
        // Of several that are near enough, the nearest is meant.
        const nearest = Math.min(away(places.length), away(places.curve), away(places.down));
        return Number.isFinite(own) && own === nearest ? own : null;
      },
      anchor: () => {
        this.#drag ??= this.#begin(kind);
        return this.#drag?.last ?? { x: this.#x, y: 0 };
      },
      drag: (x, y, done) => this.#move(kind, x, y, done),
      hover: (on) => {
        this.#of.mark(kind, on ? (this.#drag ? 'held' : 'hover') : 'rest');
        this.#of.redraw();
      },
    };
  }

  #move(kind: StemHandle, x: number, y: number, done: boolean): void {
    const drag = this.#drag;
    if (drag?.kind !== kind) return;
    drag.last = { x, y };
    const [dx, dy] = [x - drag.from.x, y - drag.from.y];
    const { stance, view } = drag;
    if (kind === 'down') drag.degrees = draggedDown(stance, view, dx, dy, drag.degrees);
    else if (kind === 'curve') drag.degrees = draggedCurve(stance, view, dx, dy);
    const change =
      kind === 'length'
        ? { ratio: draggedLength(stance, view, dx, dy) }
        : { degrees: Math.round(drag.degrees * 10) / 10 };
    if (done) this.#drag = null;
    this.#of.mark(kind, done ? 'rest' : 'held');
    this.#of.tell(kind, change, done);
    this.#of.redraw();
  }

  #begin(kind: StemHandle): Drag | null {
    const stance = this.#stance();
    const from = this.#places(this.#x)?.[kind];
    if (!stance || !from) return null;
    const { area, camera } = this.#of.view(this.#x);
    // The page may move its camera when another tree stands; the drag goes by what was seen when it began.
    return { kind, stance, view: { area, camera: camera.clone() }, from, last: from, degrees: 0 };
  }
}

/** The poses of a stem's pieces at rest. */
function restOf({ restPose }: PackedTree, { base, middle, tip, parent }: StemEnds): StemPoses {
  const plane = restPose.width * restPose.height * TEXEL;
  const at = (piece: number): Float32Array => {
    const out = new Float32Array(TEXEL * Object.keys(POSE_TARGETS).length);
    for (const k of Object.values(POSE_TARGETS)) {
      out.set(restPose.data.subarray(k * plane + TEXEL * piece, k * plane + TEXEL * (piece + 1)), TEXEL * k);
    }
    return out;
  };
  return { base: at(base.piece), middle: at(middle.piece), tip: at(tip.piece), parent: parent && at(parent.piece) };
}
