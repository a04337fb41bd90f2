import { BufferAttribute, BufferGeometry, Mesh, Object3D, Vector4 } from 'three';
import fragmentShader from '../../../shaders/overlay/handle.frag';
import vertexShader from '../../../shaders/overlay/handle.vert';
import { type OverlayUniforms, overlayMaterial } from './overlay-material.ts';

/** Parts of a ring, and ticks around the outer one. */
const PARTS = 96;
const TICKS = 16;

/** Radii of the two rings in reaches of the tree, at most; and in radii of the crown. */
const OUTER = 0.72;
const CROWN = 0.92;
const INNER = 0.42;

/** What a handle tells a reader's hand. */
export interface HandlePlace {
  /** Direction towards which the wind blows, radians from x to y in tree space. */
  direction: number;
  /** 0..1. */
  strength: number;
}

/** Kinds of corners, as shaders/overlay/handle.vert names them. */
const RING = 0;
const TICK = 1;
const SHAFT = 2;
const HEAD = 3;
const KNOB = 4;

function handleGeometry(): BufferGeometry {
  const position: number[] = [];
  const corner: number[] = [];
  const index: number[] = [];
  const vertex = (x: number, y: number, kind: number, u: number, v: number): void => {
    position.push(x, y, kind);
    corner.push(u, v);
  };
  const quad = (): void => {
    const n = position.length / 3;
    index.push(n - 4, n - 2, n - 3, n - 3, n - 2, n - 1);
  };
  for (const ring of [0, 1]) {
    for (let i = 0; i <= PARTS; i++) {
      vertex(i / PARTS, ring, RING, -1, 0);
      vertex(i / PARTS, ring, RING, 1, 0);
      if (i > 0) quad();
    }
  }
  for (let i = 0; i < TICKS; i++) {
    for (const y of [0, 1]) for (const side of [-1, 1]) vertex(i / TICKS, y, TICK, side, 0);
    quad();
  }
  for (const y of [0, 1]) for (const side of [-1, 1]) vertex(0, y, SHAFT, side, 0);
  quad();
  vertex(0, 0, HEAD, -1, 0);
  vertex(0, 0, HEAD, 1, 0);
  vertex(0, 1, HEAD, 0, 0);
  const n = position.length / 3;
  index.push(n - 3, n - 1, n - 2);
  for (const v of [-1, 1]) for (const u of [-1, 1]) vertex(0, 0, KNOB, u, v);
  quad();
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new BufferAttribute(new Float32Array(position), 3));
  geometry.setAttribute('corner', new BufferAttribute(new Float32Array(corner), 2));
  geometry.setIndex(index);
  return geometry;
}

/**
 * The wind's handle around the foot of the tree, tree space: its knob stands upwind, the farther out the stronger it blows, and
 * an arrow runs from it to the tree.
 */
export class Handle extends Object3D {
  readonly #geometry = handleGeometry();
  /** Inner radius | outer radius | height above the ground, metres | scale of the pixels. */
  readonly shape = new Vector4(2, 5, 0.05, 1);
  readonly #wind = new Vector4(1, 0, 0, 0);
  readonly #held = { value: 0 };
  #grasped = false;
  #focused = false;
  readonly #materials;
  readonly #place: HandlePlace = { direction: 0, strength: 0 };

  constructor(shared: OverlayUniforms) {
    super();
    const uniforms = {
      ...shared,
      handleShape: { value: this.shape },
      handleWind: { value: this.#wind },
      handleHeld: this.#held,
    };
    this.#materials = (['hidden', 'seen'] as const).map((layer) =>
      overlayMaterial(vertexShader, fragmentShader, uniforms, layer),
    );
    this.#materials.forEach((material, i) => {
      const mesh = new Mesh(this.#geometry, material);
      mesh.frustumCulled = false;
      mesh.renderOrder = 4 + i;
      mesh.raycast = () => {};
      this.add(mesh);
    });
    this.name = 'wind handle';
  }

  /** Sizes it for a tree: its reach and the radius of its crown, metres. */
  fit(reach: number, crown: number): void {
    const outer = Math.min(OUTER * reach, Math.max(CROWN * crown, 0.3 * reach));
    this.shape.set(INNER * outer, outer, 0.012 * reach, 1);
  }

  get place(): Readonly<HandlePlace> {
    return this.#place;
  }

  set(direction: number, strength: number): void {
    this.#place.direction = direction;
    this.#place.strength = Math.min(1, Math.max(0, strength));
    this.#wind.x = Math.cos(direction);
    this.#wind.y = Math.sin(direction);
    this.#wind.z = this.#place.strength;
  }

  /** 0..1: how brightly its halo shines. */
  set glow(glow: number) {
    this.#wind.w = glow;
  }

  /** The reader holds it, or points at it. */
  set held(held: boolean) {
    this.#grasped = held;
    this.#shine();
  }

  /** A control of the page that does the same has the focus. */
  set focused(focused: boolean) {
    this.#focused = focused;
    this.#shine();
  }

  /** Distance of the knob from the tree for a strength, metres. */
  radiusOf(strength: number): number {
    return this.shape.x + (this.shape.y - this.shape.x) * strength;
  }

  /** The wind that a knob at (x, y) stands for, tree space, metres. */
  placeOf(x: number, y: number): HandlePlace {
    const strength = (Math.hypot(x, y) - this.shape.x) / (this.shape.y - this.shape.x);
    return { direction: Math.atan2(-y, -x), strength: Math.min(1, Math.max(0, strength)) };
  }

  #shine(): void {
    this.#held.value = this.#grasped || this.#focused ? 1 : 0;
  }

  override dispose(): void {
    this.#geometry.dispose();
    for (const material of this.#materials) material.dispose();
  }
}
