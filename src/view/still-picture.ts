import { Color, type PerspectiveCamera, Vector3, Vector4 } from 'three';
import { coverCount, organCount } from '../core/look/leaf-count.ts';
import { growthWidth, leafGrowth } from '../core/look/leaf-growth.ts';
import { leafRamp, leafTurn } from '../core/look/leaf-look.ts';
import { leafSpecOf } from '../core/look/leaf-spec.ts';
import { hashPcg, hashUnit } from '../core/math/hash.ts';
import { BRANCH_LAYERS, TEXEL } from '../core/pack/layout.ts';
import { leafTexel } from '../core/pack/leaf-texel.ts';
import type { PackedTree } from '../core/pack/packed.ts';
import type { Species } from '../core/species/species.ts';
import { css, lookAt } from './stage-look.ts';

/** What a still picture shows, and from where. */
export interface StillOptions {
  readonly dark: boolean;
  /** Levels below this one are drawn; all by default. */
  readonly levels?: number;
  readonly leaves?: boolean;
  /** A pose laid out as `PackedTree.restPose.data` (src/core/wind/pose-tree.ts); the rest pose by default. */
  readonly pose?: Float32Array;
}

/** Leaves and pieces drawn at most: a 2D canvas makes about a million strokes a second. */
const MOST_LEAVES = 40_000;
const MOST_PIECES = 20_000;

/** Straight parts that a piece is drawn in. */
const PARTS = 3;

/** Something to paint, from far to near. */
interface Stroke {
  depth: number;
  paint: () => void;
}

/**
 * Draws a tree on a 2D canvas, where there is no WebGL2: strokes for the branches, a dab for each leaf, lit from one side.
 *
 * `camera` looks at the tree as the stage's does (y up, tree at the origin); its aspect must be the canvas's.
 */
export function drawStillPicture(
  context: CanvasRenderingContext2D,
  camera: PerspectiveCamera,
  tree: PackedTree,
  species: Species,
  { dark, levels = Number.POSITIVE_INFINITY, leaves = true, pose = tree.restPose.data }: StillOptions,
): void {
  const { width, height } = context.canvas;
  camera.updateMatrixWorld();
  const view = new View(camera, width, height, pose, tree);
  backdrop(context, view, dark);
  const strokes: Stroke[] = [];
  branches(context, view, tree, species, levels, dark, strokes);
  if (leaves) foliage(context, view, tree, species, dark, strokes);
  strokes.sort((a, b) => b.depth - a.depth);
  context.lineCap = 'round';
  for (const { paint } of strokes) paint();
}

/** Puts points of the tree on the canvas. */
class View {
  readonly #plane: number;
  readonly #camera: PerspectiveCamera;
  readonly #pose: Float32Array;
  readonly #point = new Vector4();
  readonly width: number;
  readonly height: number;

  constructor(camera: PerspectiveCamera, width: number, height: number, pose: Float32Array, tree: PackedTree) {
    this.#camera = camera;
    this.#pose = pose;
    this.#plane = tree.restPose.width * tree.restPose.height * TEXEL;
    this.width = width;
    this.height = height;
  }

  /** The point of a piece at u, tree space (z up) turned to y up. */
  onPiece(piece: number, u: number, out: Vector3): Vector3 {
    const w = 1 - u;
    const weights = [w * w * w, 3 * w * w * u, 3 * w * u * u, u * u * u];
    let [x, y, z] = [0, 0, 0];
    for (let k = 0; k < 4; k++) {
      const at = k * this.#plane + piece * TEXEL;
      x += weights[k] * this.#pose[at];
      y += weights[k] * this.#pose[at + 1];
      z += weights[k] * this.#pose[at + 2];
    }
    return out.set(x, z, -y);
  }

  /** Pixel x | y | distance | pixels a metre there; null behind the camera. */
  project(p: Vector3): { x: number; y: number; depth: number; scale: number } | null {
    const v = this.#point.set(p.x, p.y, p.z, 1).applyMatrix4(this.#camera.matrixWorldInverse);
    const depth = -v.z;
    if (depth < this.#camera.near) return null;
    v.applyMatrix4(this.#camera.projectionMatrix);
    const scale = (this.#camera.projectionMatrix.elements[5] * this.height * 0.5) / depth;
    return { x: (v.x / v.w + 1) * 0.5 * this.width, y: (1 - v.y / v.w) * 0.5 * this.height, depth, scale };
  }
}

function backdrop(context: CanvasRenderingContext2D, view: View, dark: boolean): void {
  const look = lookAt('meadow', null, dark);
  const { width, height } = view;
  const foot = view.project(new Vector3(0, 0, 0));
  const horizon = view.project(new Vector3(0, 0, -1e4));
  const level = Math.min(height, Math.max(0, horizon?.y ?? height * 0.7));
  const sky = context.createLinearGradient(0, 0, 0, level || 1);
  sky.addColorStop(0, css(look.zenith));
  sky.addColorStop(0.45, css(look.middle));
  sky.addColorStop(1, css(look.horizon));
  context.fillStyle = sky;
  context.fillRect(0, 0, width, height);
  const ground = context.createLinearGradient(0, level, 0, height);
  ground.addColorStop(0, css(look.horizon));
  ground.addColorStop(0.25, css(look.grassLight));
  ground.addColorStop(1, css(look.grassDark));
  context.fillStyle = ground;
  context.fillRect(0, level, width, height - level);
  if (!foot) return;
  context.save();
  context.translate(foot.x, foot.y);
  context.scale(1, 0.12);
  const shade = context.createRadialGradient(0, 0, 0, 0, 0, foot.scale * 3);
  shade.addColorStop(0, 'rgba(20, 30, 15, 0.6)');
  shade.addColorStop(1, 'rgba(20, 30, 15, 0)');
  context.fillStyle = shade;
  context.fillRect(-width, -width, 2 * width, 2 * width);
  context.restore();
}

/** A colour made lighter or darker, as CSS. */
function shaded(colour: Color, light: number): string {
  return `#${new Color().copy(colour).multiplyScalar(light).getHexString()}`;
}

/** Eight shades of a colour, so that a stroke need not make its own. */
const ramp = (colour: Color, from: number, to: number): string[] =>
  Array.from({ length: 8 }, (_, i) => shaded(colour, from + ((to - from) * i) / 7));

function branches(
  context: CanvasRenderingContext2D,
  view: View,
  tree: PackedTree,
  { bark }: Species,
  levels: number,
  dark: boolean,
  strokes: Stroke[],
): void {
  const span = BRANCH_LAYERS.SPAN * tree.branches.width * tree.branches.height * TEXEL;
  const colours = ramp(new Color(bark.colour).lerp(new Color(bark.dark), 0.35), dark ? 0.25 : 0.45, dark ? 0.6 : 1.05);
  const a = new Vector3();
  const b = new Vector3();
  tree.levels.slice(0, levels).forEach(({ start, count }) => {
    for (let i = start; i < start + Math.min(count, MOST_PIECES); i++) {
      const t = span + i * TEXEL;
      const { data } = tree.branches;
      const [piece, z0, z1, radius] = [data[t], data[t + 1], data[t + 2], data[t + 3]];
      for (let part = 0; part < PARTS; part++) {
        const from = view.project(view.onPiece(piece, part / PARTS, a));
        const to = view.project(view.onPiece(piece, (part + 1) / PARTS, b));
        if (!from || !to) continue;
        const z = z0 + ((z1 - z0) * (part + 0.5)) / PARTS;
        const thick = Math.max(0.5, 2 * radius * (1 - 0.9 * z) * from.scale);
        // Lit from the upper right: what rises to the left is in shade.
        const light = b.sub(a).normalize().dot(LIGHT);
        const colour = colours[Math.min(7, Math.max(0, Math.round(4.5 - 3 * light)))];
        strokes.push({
          depth: from.depth,
          paint: () => {
            context.strokeStyle = colour;
            context.lineWidth = thick;
            context.beginPath();
            context.moveTo(from.x, from.y);
            context.lineTo(to.x, to.y);
            context.stroke();
          },
        });
      }
    }
  });
}

const LIGHT = new Vector3(-0.6, 0.3, 0.2);

function foliage(
  context: CanvasRenderingContext2D,
  view: View,
  tree: PackedTree,
  { foliage: look, leaves, organ }: Species,
  dark: boolean,
  strokes: Stroke[],
): void {
  const there = coverCount(tree.leafCount, look);
  const borne = organCount(tree.leafCount, organ);
  const [count, organs] = [Math.min(there, MOST_LEAVES), Math.min(borne, MOST_LEAVES)];
  const [growX, growY] = leafGrowth(count / Math.max(there, 1), growthWidth(leafSpecOf({ leaves, foliage: look })));
  const shades = (colour: Color): string[] => ramp(colour, dark ? 0.15 : 0.35, dark ? 0.7 : 1.25);
  // How far a leaf has turned, in quarters.
  const turned = [0, 0.25, 0.5, 0.75, 1].map((t) =>
    shades(new Color(...leafRamp(look, t)).lerp(new Color(look.glow), 0.2 * (1 - t))),
  );
  const blossom = shades(new Color(organ.colour));
  const centre = new Vector3(tree.crown[0], tree.crown[2], -tree.crown[1]);
  const radii = new Vector3(tree.crown[3], tree.crown[5], tree.crown[4]);
  const p = new Vector3();
  const leafLength = tree.leafLength * look.size;
  for (let n = 0; n < count + organs; n++) {
    const leaf = n < count;
    const i = leaf ? n : n - count;
    const { piece, v, phase } = leafTexel(tree.leaves.data, i);
    const turn = phase * Math.PI * 2;
    // The blade hangs beside the twig; which way does not matter for a dab.
    const reach = leaf ? leafLength * (leaves.petiole + 0.5) : organ.size;
    view.onPiece(piece, v, p);
    p.x += reach * Math.cos(turn * 5);
    p.y += reach * 0.5 * Math.sin(turn * 11);
    p.z += reach * Math.sin(turn * 7);
    const seen = view.project(p);
    if (!seen) continue;
    p.sub(centre).divide(radii);
    // Brighter towards the sun and outwards, darker deep inside and below.
    const light = 0.32 * p.x + 0.3 * p.y + 0.45 * Math.min(1, p.length()) + 0.3 * (phase - 0.5);
    const own = hashUnit(hashPcg(Math.floor(phase * 65535 + 0.5)));
    const colours = leaf ? turned[Math.round(4 * leafTurn(look, own))]! : blossom;
    const colour = colours[Math.min(7, Math.max(0, Math.round(-0.4 + 6.5 * light)))];
    const [length, width] = leaf ? [leafLength * growY, leafLength * growX * leaves.scaleX] : [organ.size, organ.size];
    const long = Math.max(0.6, length * seen.scale * 0.5);
    const wide = Math.max(0.5, width * seen.scale * 0.42);
    strokes.push({
      depth: seen.depth,
      paint: () => {
        context.fillStyle = colour;
        context.beginPath();
        context.ellipse(seen.x, seen.y, long, wide * (0.4 + 0.6 * Math.abs(Math.sin(turn * 3))), turn, 0, 2 * Math.PI);
        context.fill();
      },
    });
  }
}
