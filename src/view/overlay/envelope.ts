import { BufferAttribute, BufferGeometry, Mesh, Object3D, Vector2 } from 'three';
import fragmentShader from '../../../shaders/overlay/envelope.frag';
import vertexShader from '../../../shaders/overlay/envelope.vert';
import { envelopeRatio } from '../../core/grow/stem-shape.ts';
import type { TreeSize } from '../../core/grow/tree-size.ts';
import type { PruningParameters } from '../../core/species/species.ts';
import { type OverlayUniforms, overlayMaterial } from './overlay-material.ts';

/** Lines from the base to the top, rings between, and straight parts of each. */
const MERIDIANS = 16;
const RINGS = 9;
const UP = 48;
const ROUND = 72;

/** Radius and height in metres of the envelope at n + 1 places from its base to its top, closer together at both ends; 2 a place. */
export function envelopeProfile(pruning: PruningParameters, size: TreeSize, n: number): Float32Array {
  const out = new Float32Array(2 * (n + 1));
  for (let i = 0; i <= n; i++) {
    // The profile may rise from its ends as steeply as a root does.
    const up = 0.5 - 0.5 * Math.cos((Math.PI * i) / n);
    out[2 * i] = size.scale * pruning.width * envelopeRatio(1 - up, pruning);
    out[2 * i + 1] = size.stretch * size.scale * (size.baseSize + (1 - size.baseSize) * up);
  }
  return out;
}

/**
 * The pruning envelope as a body of fine lines, tree space (Weber & Penn 1995, 4.6): meridians and rings, the ring of the widest place
 * among them, and a veil that thickens towards the rim.
 */
export class Envelope extends Object3D {
  readonly #geometry = new BufferGeometry();
  /** Strength 0..1 of the drawing | of the ghost where something hides it. */
  readonly #look = { value: new Vector2(1, 1) };
  readonly #materials;
  #size: TreeSize = { scale: 1, stretch: 1, baseSize: 0 };
  #pruning: PruningParameters | null = null;
  #made = '';

  constructor(shared: OverlayUniforms) {
    super();
    this.#materials = (['hidden', 'seen'] as const).map((layer) =>
      overlayMaterial(vertexShader, fragmentShader, { ...shared, envelopeLook: this.#look }, layer),
    );
    this.#materials.forEach((material, i) => {
      const mesh = new Mesh(this.#geometry, material);
      mesh.frustumCulled = false;
      mesh.renderOrder = 2 + 0.1 * i;
      mesh.raycast = () => {};
      this.add(mesh);
    });
    this.name = 'pruning envelope';
  }

  /** The size of the tree that it stands around. */
  fit(size: TreeSize): void {
    this.#size = size;
    this.#make();
  }

  set(pruning: PruningParameters): void {
    this.#pruning = pruning;
    // What prunes nothing is a proposal.
    this.#look.value.x = 0.55 + 0.45 * Math.min(1, pruning.ratio);
    this.#make();
  }

  override dispose(): void {
    this.#geometry.dispose();
    for (const material of this.#materials) material.dispose();
  }

  #make(): void {
    const pruning = this.#pruning;
    const { scale, stretch, baseSize } = this.#size;
    if (!pruning) return;
    const { width, widthPeak, powerLow, powerHigh } = pruning;
    const made = String([width, widthPeak, powerLow, powerHigh, scale, stretch, baseSize]);
    if (made === this.#made) return;
    this.#made = made;
    const { position, normal, mark, index } = envelopeMesh(pruning, this.#size);
    // Of the same size each time: the buffers are filled anew.
    for (const [name, data, items] of [
      ['position', position, 3],
      ['normal', normal, 3],
      ['mark', mark, 4],
    ] as const) {
      const there = this.#geometry.getAttribute(name) as BufferAttribute | undefined;
      if (there) there.set(data).needsUpdate = true;
      else this.#geometry.setAttribute(name, new BufferAttribute(data, items));
    }
    if (!this.#geometry.index) this.#geometry.setIndex(index);
  }
}

/** The body as triangles. mark: direction of the line there (3) | side -1 or 1, twice that on the widest ring, 0 on the veil. */
function envelopeMesh(pruning: PruningParameters, size: TreeSize) {
  const position: number[] = [];
  const normal: number[] = [];
  const mark: number[] = [];
  const index: number[] = [];
  const profile = envelopeProfile(pruning, size, UP);
  const at = (i: number): [radius: number, height: number] => [profile[2 * i] as number, profile[2 * i + 1] as number];
  /** The slope of the profile: how its normal leans. */
  const lean = (i: number): [out: number, up: number] => {
    const [r0, h0] = at(Math.max(0, i - 1));
    const [r1, h1] = at(Math.min(UP, i + 1));
    const n = Math.hypot(r1 - r0, h1 - h0) || 1;
    return [(h1 - h0) / n, (r0 - r1) / n];
  };
  const vertex = (i: number, turn: number, line: 'up' | 'round' | null, side: number): number => {
    const [radius, height] = at(i);
    const [out, up] = lean(i);
    const [c, s] = [Math.cos(2 * Math.PI * turn), Math.sin(2 * Math.PI * turn)];
    position.push(radius * c, radius * s, height);
    normal.push(out * c, out * s, up);
    if (line === 'up') mark.push(-up * c, -up * s, out, side);
    else if (line === 'round') mark.push(-s, c, 0, side);
    else mark.push(0, 0, 0, 0);
    return position.length / 3 - 1;
  };
  const ribbon = (points: number, line: 'up' | 'round', where: (k: number) => [number, number], weight = 1): void => {
    for (let k = 0; k <= points; k++) {
      const [i, turn] = where(k);
      const a = vertex(i, turn, line, -weight);
      vertex(i, turn, line, weight);
      if (k > 0) index.push(a - 2, a, a - 1, a - 1, a, a + 1);
    }
  };
  // The veil first: lines are drawn over it.
  for (let i = 0; i <= UP; i++) {
    for (let k = 0; k <= ROUND / 2; k++) {
      const here = vertex(i, (2 * k) / ROUND, null, 0);
      const row = ROUND / 2 + 1;
      if (i > 0 && k > 0) index.push(here - row - 1, here - row, here - 1, here - 1, here - row, here);
    }
  }
  for (let m = 0; m < MERIDIANS; m++) ribbon(UP, 'up', (k) => [k, m / MERIDIANS]);
  let widest = 0;
  for (let i = 0; i <= UP; i++) if (at(i)[0] > at(widest)[0]) widest = i;
  for (let r = 1; r <= RINGS; r++) {
    const i = Math.round((UP * r) / (RINGS + 1));
    ribbon(ROUND, 'round', (k) => [i, k / ROUND]);
  }
  ribbon(ROUND, 'round', (k) => [widest, k / ROUND], 2);
  return {
    position: new Float32Array(position),
    normal: new Float32Array(normal),
    mark: new Float32Array(mark),
    index,
  };
}

export type { TreeSize };
