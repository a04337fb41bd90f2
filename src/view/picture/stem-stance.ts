import type { PerspectiveCamera } from 'three';
import { bezierPoint, type Cubic } from '../../core/math/bezier.ts';
import { handlesOf, sectionFrame } from '../../core/math/frames.ts';
import { add, addScaled, distance, dot, length, scale, type Vec3 } from '../../core/math/vec3.ts';
import { MIDDLE, type PlaceOnPiece } from '../overlay/stem-ends.ts';
import { type Area, metresAPixel, windowPoint } from './aim.ts';

/** A pose of one piece: P0 | O.x, P1 | O.y, P2 | O.z, P3 | stir, as `Picture.readPiece` gives it. */
export type PiecePose = ArrayLike<number>;

/** A stem as it stands, tree space: what its handles are drawn from, and what they drag. */
export interface StemStance {
  readonly base: Vec3;
  readonly tip: Vec3;
  readonly middle: Vec3;
  /** Towards which the stem bends where its curve grows: unit vector at its middle. */
  readonly bend: Vec3;
  /** Directions at the base, of the parent (of a trunk the vertical) and across it in the plane of both; unit vectors. */
  readonly parent: Vec3;
  readonly out: Vec3;
  /** Angle between parent and stem, radians. */
  readonly angle: number;
}

interface Section {
  readonly centre: Vec3;
  readonly along: Vec3;
  readonly t: Vec3;
}

function sectionAt(p: PiecePose, v: number): Section {
  const at = (k: number): Vec3 => [p[4 * k] as number, p[4 * k + 1] as number, p[4 * k + 2] as number];
  const curve: Cubic = { p0: at(0), p1: at(1), p2: at(2), p3: at(3) };
  const handles = handlesOf(curve, [p[3] as number, p[7] as number, p[11] as number]);
  const [along, t] = sectionFrame(curve, handles, v);
  return { centre: bezierPoint(curve, v), along, t };
}

/** The poses of the pieces on which a stem's handles sit. */
export interface StemPoses {
  readonly base: PiecePose;
  readonly middle: PiecePose;
  readonly tip: PiecePose;
  readonly parent: PiecePose | null;
}

/** A stem as its pieces stand. Twin: shaders/overlay/stem-handle.vert. */
export function stemStance(
  poses: StemPoses,
  { middle, parent }: { readonly middle: PlaceOnPiece; readonly parent: PlaceOnPiece | null },
): StemStance {
  const base = sectionAt(poses.base, 0);
  const half = sectionAt(poses.middle, middle.v);
  const up: Vec3 = parent && poses.parent ? sectionAt(poses.parent, parent.v).along : [0, 0, 1];
  const c = dot(base.along, up);
  const across = addScaled(base.along, up, -c);
  const s = length(across);
  return {
    base: base.centre,
    tip: sectionAt(poses.tip, 1).centre,
    middle: half.centre,
    // A positive curve turns a stem towards -y of its frame (src/core/grow/frame.ts), which the handle T of a piece is.
    bend: scale(half.t, -1),
    parent: up,
    out: s > 1e-3 ? scale(across, 1 / s) : scale(base.t, -1),
    angle: Math.atan2(s, c),
  };
}

/** Where a stem is seen from. */
export interface StemView {
  readonly area: Area;
  readonly camera: PerspectiveCamera;
}

export interface Pixel {
  readonly x: number;
  readonly y: number;
}

/** Pixels from the tip to its handle, radii of the arc, and the length below which a stem has no room for the handle of its curve. */
const BEYOND = 20;
const ARC = { part: 0.3, least: 34, most: 60 } as const;
const LEAST_FOR_CURVE = 100;

/** How far the handle of the curve moves at least for a metre, as a part of what it would seen from the side: else it runs away. */
const LEAST_SIDE = 0.4;

const onWindow = (p: Vec3, { area, camera }: StemView): Pixel | null => windowPoint(...p, area, camera);

/** Metres before the eye, along the way that it looks. */
function depthOf(p: Vec3, { camera }: StemView): number {
  camera.updateMatrixWorld();
  const m = camera.matrixWorldInverse.elements;
  const depth = -((m[2] as number) * p[0] + (m[6] as number) * p[2] - (m[10] as number) * p[1] + (m[14] as number));
  return Math.max(depth, camera.near);
}

const pixelsPerMetre = (p: Vec3, view: StemView): number =>
  1 / (metresAPixel(view.camera, view.area.height) * depthOf(p, view));

function stretchOf(stance: StemStance, view: StemView): { from: Pixel; to: Pixel; pixels: number } | null {
  const from = onWindow(stance.base, view);
  const to = onWindow(stance.tip, view);
  return from && to ? { from, to, pixels: Math.hypot(to.x - from.x, to.y - from.y) } : null;
}

const arcRadius = (stance: StemStance, pixels: number, view: StemView): number =>
  Math.min(Math.max(ARC.part * pixels, ARC.least), ARC.most) / pixelsPerMetre(stance.base, view);

function onArc({ base, parent, out }: StemStance, radius: number, angle: number): Vec3 {
  const towards = add(scale(parent, Math.cos(angle)), scale(out, Math.sin(angle)));
  return addScaled(base, towards, radius);
}

/** Where the handles are in the window, CSS pixels; null: out of sight, or without room. */
export function handlePlaces(
  stance: StemStance,
  view: StemView,
): { readonly length: Pixel | null; readonly curve: Pixel | null; readonly down: Pixel | null } {
  const stretch = stretchOf(stance, view);
  if (!stretch) return { length: null, curve: null, down: null };
  const { from, to, pixels } = stretch;
  const part = pixels > 1 ? BEYOND / pixels : 0;
  return {
    length: { x: to.x + part * (to.x - from.x), y: to.y + part * (to.y - from.y) - (part ? 0 : BEYOND) },
    curve: pixels >= LEAST_FOR_CURVE ? onWindow(stance.middle, view) : null,
    down: onWindow(onArc(stance, arcRadius(stance, pixels, view), stance.angle), view),
  };
}

/** What the stem's length is multiplied by when the handle at its tip is moved by pixels. */
export function draggedLength(stance: StemStance, view: StemView, dx: number, dy: number): number {
  const stretch = stretchOf(stance, view);
  if (!stretch) return 1;
  const { from, to, pixels } = stretch;
  // A stem that points at the eye is short on the screen.
  const whole = Math.max(pixels, 40);
  const along = (dx * (to.x - from.x) + dy * (to.y - from.y)) / Math.max(pixels, 1);
  const t = 1 + along / whole;
  // Where the point is, on the line from base to tip, that stands at the part t of its picture.
  const near = depthOf(stance.base, view);
  const far = depthOf(stance.tip, view);
  return Math.max(0.05, (t * near) / Math.max(far + t * (near - far), 0.2 * far));
}

/**
 * Degrees by which a stem's curve grows when its middle is moved by pixels: a stem of length L that curves by c radians evenly has
 * moved by c f^2 L/2 at the part f of its length.
 */
export function draggedCurve(stance: StemStance, view: StemView, dx: number, dy: number): number {
  const at = onWindow(stance.middle, view);
  const reach = distance(stance.base, stance.tip);
  const side = onWindow(addScaled(stance.middle, stance.bend, 0.1 * reach), view);
  if (!at || !side || reach === 0) return 0;
  const mx = (side.x - at.x) / (0.1 * reach);
  const my = (side.y - at.y) / (0.1 * reach);
  const seen = Math.hypot(mx, my);
  const least = LEAST_SIDE * pixelsPerMetre(stance.middle, view);
  if (seen === 0) return 0;
  const metres = (dx * mx + dy * my) / seen / Math.max(seen, least);
  return ((2 * metres) / (reach * MIDDLE * MIDDLE)) * (180 / Math.PI);
}

/** Degrees between neighbours that are tried, and how far from the last one. */
const STEP = 0.5;
const WINDOW = 30;

/** Degrees by which the down angle grows when the handle on the arc is moved by pixels; `last`: what it was a moment ago. */
export function draggedDown(stance: StemStance, view: StemView, dx: number, dy: number, last: number): number {
  const stretch = stretchOf(stance, view);
  if (!stretch) return last;
  const radius = arcRadius(stance, stretch.pixels, view);
  const began = (stance.angle * 180) / Math.PI;
  const from = onWindow(onArc(stance, radius, stance.angle), view);
  if (!from) return last;
  let best = last;
  let least = Number.POSITIVE_INFINITY;
  // The place on the arc that is nearest to the pointer on the screen: right from every side, even where the arc is seen edge-on.
  for (let change = last - WINDOW; change <= last + WINDOW; change += STEP) {
    const angle = began + change;
    if (angle < 0 || angle > 180) continue;
    const at = onWindow(onArc(stance, radius, (angle * Math.PI) / 180), view);
    if (!at) continue;
    const away = Math.hypot(at.x - from.x - dx, at.y - from.y - dy);
    if (away < least) {
      least = away;
      best = change;
    }
  }
  return best;
}
