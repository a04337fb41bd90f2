import {
  BufferAttribute,
  InstancedBufferAttribute,
  InstancedBufferGeometry,
  Mesh,
  type ShaderMaterial,
  Vector4,
} from 'three';
import fragmentShader from '../../../shaders/overlay/arrow.frag';
import vertexShader from '../../../shaders/overlay/arrow.vert';
import { hashPcg, hashUnit } from '../../core/math/hash.ts';
import type { ForceField } from '../force-field.ts';
import { type OverlayUniforms, overlayMaterial } from './overlay-material.ts';

/** Arrows from the middle of the field to its edge. */
const RINGS = 11;

/** Radius of the field in reaches of the tree. */
const RADIUS = 1.7;

/** Metres of force that give an arrow 63 % of its length: about 9 m/s, so that a breeze and a storm can both be told apart. */
const HALFWAY = 0.25;

/** A triangular lattice within the unit circle; 2 a place. */
export function lattice(rings: number): Float32Array {
  const step = 1 / rings;
  const rows = Math.ceil(rings / Math.sqrt(0.75));
  const spots: number[] = [];
  for (let j = -rows; j <= rows; j++) {
    for (let i = -rings - 1; i <= rings + 1; i++) {
      const x = (i + (j & 1) / 2) * step;
      const y = j * Math.sqrt(0.75) * step;
      if (x * x + y * y <= 1) spots.push(x, y);
    }
  }
  return new Float32Array(spots);
}

/** Shaft, as two triangles, and head: part of the length | side | 1 on the head. */
const SHAPE = new Float32Array([0, -1, 0, 0, 1, 0, 1, -1, 0, 1, 1, 0, 0, -1, 1, 0, 1, 1, 1, 0, 1]);
const INDEX = [0, 2, 1, 1, 2, 3, 4, 6, 5];

/** The force over the meadow as arrows; each is computed where it stands, so that gusts are seen travelling through them. */
export class Arrows extends Mesh<InstancedBufferGeometry, ShaderMaterial> {
  readonly #field: ForceField;
  readonly #unit = lattice(RINGS);
  readonly #spots = new InstancedBufferAttribute(new Float32Array((this.#unit.length / 2) * 3), 3);
  readonly #shape = new Vector4();

  constructor(shared: OverlayUniforms, field: ForceField) {
    const geometry = new InstancedBufferGeometry();
    const shape = new Vector4();
    super(
      geometry,
      overlayMaterial(vertexShader, fragmentShader, { ...shared, ...field.uniforms, arrowField: { value: shape } }),
    );
    this.#field = field;
    this.#shape = shape;
    geometry.setAttribute('position', new BufferAttribute(SHAPE, 3));
    geometry.setAttribute('spot', this.#spots);
    geometry.setIndex(INDEX);
    geometry.instanceCount = this.#unit.length / 2;
    this.name = 'force arrows';
    this.frustumCulled = false;
    this.renderOrder = 3;
    this.raycast = () => {};
  }

  /** Spreads the field for a tree of this reach, metres. */
  fit(reach: number): void {
    const radius = RADIUS * reach;
    for (let i = 0; i < this.#spots.count; i++) {
      this.#spots.setXYZ(i, this.#unit[2 * i] * radius, this.#unit[2 * i + 1] * radius, hashUnit(hashPcg(i)));
    }
    this.#spots.needsUpdate = true;
    this.#shape.set((0.95 * radius) / RINGS, HALFWAY, 0.028 * reach, radius);
  }

  /** Takes the variant that the wind needs. */
  update(): void {
    this.#field.dress(this.material);
  }

  override dispose(): void {
    this.geometry.dispose();
    this.material.dispose();
  }
}
