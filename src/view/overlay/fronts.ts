import { BufferAttribute, InstancedBufferGeometry, Mesh, type ShaderMaterial, Vector2 } from 'three';
import fragmentShader from '../../../shaders/overlay/front.frag';
import vertexShader from '../../../shaders/overlay/front.vert';
import type { ForceField } from '../force-field.ts';
import { type OverlayUniforms, overlayMaterial } from './overlay-material.ts';

/** How far gusts are shown, in reaches of the tree. */
const REACH = 2.6;

/** The gusts that cross the meadow now, as soft bands on the ground with a bright brim where each begins. */
export class Fronts extends Mesh<InstancedBufferGeometry, ShaderMaterial> {
  readonly #reach: Vector2;
  readonly #field: ForceField;

  constructor(shared: OverlayUniforms, field: ForceField) {
    const geometry = new InstancedBufferGeometry();
    geometry.setAttribute('position', new BufferAttribute(new Float32Array([0, -1, 0, 1, -1, 0, 0, 1, 0, 1, 1, 0]), 3));
    geometry.setIndex([0, 1, 2, 2, 1, 3]);
    const reach = new Vector2();
    const material = overlayMaterial(vertexShader, fragmentShader, {
      ...shared,
      ...field.uniforms,
      frontReach: { value: reach },
    });
    // On the ground, and yet before it: blades of grass stand in the band.
    material.polygonOffset = true;
    material.polygonOffsetFactor = -1;
    material.polygonOffsetUnits = -4;
    super(geometry, material);
    this.#reach = reach;
    this.#field = field;
    this.name = 'gust fronts';
    this.frustumCulled = false;
    this.renderOrder = 1;
    this.raycast = () => {};
  }

  fit(reach: number): void {
    this.#reach.set(REACH * reach, 0.002 * reach);
  }

  /** Takes as many gusts as blow. */
  update(): void {
    const { gustCount } = this.#field.state;
    this.geometry.instanceCount = gustCount;
    this.visible = gustCount > 0;
  }

  override dispose(): void {
    this.geometry.dispose();
    this.material.dispose();
  }
}
