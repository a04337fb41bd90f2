import { Box3, type Frustum, Matrix4, Object3D, Vector2, type Vector3, type Vector4, type WebGLRenderer } from 'three';
import dither from '../../../shaders/forest/dither.glsl';
import groveTree from '../../../shaders/forest/grove-tree.glsl';
import type { GroveLight } from '../../core/look/grove-light.ts';
import type { PackedGrove } from '../../core/pack/merge-trees.ts';
import type { Species } from '../../core/species/species.ts';
import type { Wind } from '../../core/wind/wind.ts';
import { type Detail, LEAF_BUDGET } from '../detail.ts';
import { providePart } from '../inject.ts';
import type { LeafHost } from '../leaf-layer.ts';
import { windBox } from '../tree-extent.ts';
import { TreeParts } from '../tree-parts.ts';
import { groveUniforms } from '../uniforms.ts';
import { wholeKit } from '../whole-kit.ts';
import { WindLane } from '../wind-lane.ts';
import { GroveMotion } from './grove-motion.ts';
import { GrovePace } from './grove-pace.ts';
import type { Foliage } from './grove-parts.ts';
import { GroveTrees } from './grove-trees.ts';

// The shaders of branches, leaves and cards name them; who draws single trees never loads them.
const part = (name: string, text: string): void => providePart(`grove_${name}`, `#ifdef GROVE\n${text}\n#endif`);
part('tree', groveTree);
part('shares', `flat in vec2 vShare;\n${dither}`);
part('fade', 'if (fadedOut(vShare.x, vShare.y)) discard;');

/** How a grove is drawn. */
export interface GroveOptions {
  /** `auto` (default) goes by size on screen of the nearest tree. */
  detail?: Detail;
  /** Leaves drawn at most of a tree, on average. */
  leafBudget?: number;
  /** What its branches bear in place of leaves: cards. */
  foliage?: (host: LeafHost) => Foliage;
}

/** From where a grove is seen. */
export interface GroveView {
  /** The camera's place in the world. */
  readonly eye: Vector3;
  /** Pixels that a metre takes a metre away from it: half the picture's height times the projection's scale. */
  readonly scale: number;
  /** Number of the frame: it says whose turn it is to be posed. */
  readonly frame: number;
  /** What the camera sees; groves outside of it move no oftener than a shadow shows. */
  readonly frustum?: Frustum;
}

let born = 0;

/**
 * Several trees in one place, moved by one wind pass and drawn by one draw a level; at home in any scene as WindTree is.
 *
 * Grove space is z up; the object's own place in the world is the origin of it, and keep that near its trees: float32 holds a forest to
 * a tenth of a millimetre, not a country. Trees fade by their size on screen (`fade`), each of them by itself.
 */
export class Grove extends Object3D {
  readonly isGrove = true;
  /** Heights in pixels between which its trees come in (x, y) and are given up to a nearer class (z, w); at first: never. */
  readonly fade: Vector4;
  readonly #uniforms = groveUniforms();
  readonly #parts: TreeParts;
  readonly #lane = new WindLane(wholeKit);
  readonly #pace = new GrovePace(born++);
  readonly #box = new Box3();
  readonly #world = new Box3();
  readonly #inverse = new Matrix4();
  readonly #size = new Vector2();
  #packed: PackedGrove | null = null;
  #species: Species | null = null;
  #trees: GroveTrees | null = null;
  #motion: GroveMotion | null = null;
  #light = 0;
  #time = 0;

  constructor({ detail = 'auto', leafBudget = LEAF_BUDGET[detail], foliage }: GroveOptions = {}) {
    super();
    this.name = 'grove';
    this.fade = this.#uniforms.forestFade.value;
    const trees = (): GroveTrees | null => this.#trees;
    const shown = { mode: 'shaded', levels: Number.POSITIVE_INFINITY, leaves: true, detail, leafBudget } as const;
    this.#parts = new TreeParts({ ...shown }, wholeKit, {
      uniforms: this.#uniforms,
      ...(foliage ? { foliage } : {}),
      get count() {
        return trees()?.count ?? 1;
      },
      nearest: (camera, matrixWorld, height) => trees()?.pixelsPerMetre(camera, matrixWorld, height) ?? 1,
    });
    this.#parts.visible = false;
    this.add(this.#parts);
  }

  /** Takes a grove, and the light inside the crowns of its species; the same trees in other colours move on as they did. */
  setGrove(packed: PackedGrove, species: Species, light: GroveLight): void {
    if (packed !== this.#packed) {
      this.#parts.visible = false;
      this.#lane.leave();
      this.#trees?.dispose();
      this.#trees = new GroveTrees(packed);
      this.#motion = new GroveMotion(packed);
      this.#pace.reset();
      this.#uniforms.trees.value = this.#trees.texture;
      this.#uniforms.treeLog2Width.value = this.#trees.log2Width;
      this.#box.copy(windBox(packed.bounds));
    }
    this.#packed = packed;
    this.#species = species;
    this.#light = light.data.byteLength;
    this.#parts.setTree(packed, species, light);
  }

  /** Lets a wind blow, fading over from the last one in `fade` seconds of the clock (default: at once). */
  setWind(wind: Wind, { fade = 0 }: { fade?: number } = {}): void {
    this.#lane.felt.set(wind, this.#time, fade);
  }

  /** Poses the grove as of `time` seconds where it is its turn, and lets its trees fade for this view. Once a frame, before rendering. */
  update(renderer: WebGLRenderer, time: number, view: GroveView): void {
    const packed = this.#packed;
    const species = this.#species;
    if (!packed || !species) return;
    this.#time = time;
    this.#parts.updateWorldMatrix(true, false);
    const { matrixWorld } = this.#parts;
    const { forestEye, forestScale } = this.#uniforms;
    forestEye.value.copy(view.eye).applyMatrix4(this.#inverse.copy(matrixWorld).invert());
    forestScale.value = view.scale;
    const seen = view.frustum?.intersectsBox(this.#world.copy(this.#box).applyMatrix4(matrixWorld)) ?? true;
    const lane = this.#lane;
    const pixels = view.scale / Math.max(this.distance, 1e-3);
    const speed = (this.#motion?.speed(lane.state, lane.force) ?? 0) * pixels;
    lane.felt.moveTo(this.matrixWorld);
    if (this.#pace.due(view.frame, time, speed, seen, lane.felt.revision)) {
      lane.update(renderer, packed, time, 'always');
      this.#show(packed);
    }
    // Leaves beat in every frame: that takes no pass.
    const beats = (time * species.wind.flutterRate) / 16;
    this.#parts.setWind(beats - Math.floor(beats), lane.way);
    this.#parts.pictureHeight = renderer.getDrawingBufferSize(this.#size).y;
    this.#parts.visible = true;
  }

  /** Metres from the eye of the last `update` to the nearest tree. */
  get distance(): number {
    return this.#trees?.distance(this.#uniforms.forestEye.value) ?? Number.POSITIVE_INFINITY;
  }

  /** Factor on the half pixel that tips may move between two poses: larger saves passes. */
  set slack(factor: number) {
    this.#pace.slack = factor;
  }

  /**
   * How much of tree `index` has come in this class, 0..1, and how much of it the nearer class may take over: 0 while that has not come.
   * At first 1 and 1.
   */
  share(index: number, come: number, taken: number): void {
    this.#trees?.share(index, come, taken);
  }

  /** Sets both for every part. */
  setShadows(cast: boolean, receive: boolean): void {
    this.#parts.setShadows(cast, receive);
  }

  /** What the last frame drew, shadows left out, and what it takes on the GPU. */
  stats(): { triangles: number; drawCalls: number; pieces: number; leaves: number; bytes: number } {
    const { textures, poser } = this.#lane;
    const trees = this.#packed?.trees.data.byteLength ?? 0;
    const bytes = (textures?.bytes ?? 0) + (poser?.bytes ?? 0) + trees + this.#light;
    return { ...this.#parts.stats(), bytes };
  }

  /** Frees everything on the GPU; a grove may be given anew. */
  override dispose(): void {
    this.#parts.visible = false;
    this.#lane.drop();
    this.#parts.dispose();
    this.#trees?.dispose();
    this.#trees = null;
    this.#uniforms.trees.value = null;
    this.#packed = null;
    this.#light = 0;
  }

  /** Hands what the pass has written, and what does not move, to the shaders. */
  #show(packed: PackedGrove): void {
    const { textures } = this.#lane;
    const { shared } = this.#parts;
    if (!textures) return;
    shared.poseEven.value = textures.uniforms.poseEven.value;
    shared.poseOdd.value = textures.uniforms.poseOdd.value;
    if (shared.branches.value === textures.branches && shared.leaves.value === textures.leaves) return;
    shared.branches.value = textures.branches;
    shared.leaves.value = textures.leaves;
    shared.poseLog2Width.value = Math.log2(packed.restPose.width);
    shared.branchLog2Width.value = Math.log2(packed.branches.width);
    shared.leafLog2Width.value = Math.log2(packed.leaves.width);
  }
}
