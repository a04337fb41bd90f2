import { CircleGeometry, Color, Mesh, MeshLambertMaterial, Vector4 } from 'three';
import groundGlsl from '../../shaders/stage/ground.glsl';
import { inject } from './inject.ts';
import type { StageLook } from './stage-look.ts';
import { grassTexture } from './stage-textures.ts';

/** Where three's Lambert material takes the ground's own colour, its shelter under the tree, and its fading into the sky. */
export const GROUND_INJECTION = {
  vertex: [
    { anchor: '#include <common>', after: 'out vec3 vGround;' },
    { anchor: '#include <begin_vertex>', after: 'vGround = (modelMatrix * vec4(position, 1.0)).xyz;' },
  ],
  fragment: [
    { anchor: '#include <common>', after: groundGlsl },
    { anchor: '#include <map_fragment>', after: 'diffuseColor.rgb *= groundDiffuse();' },
    { anchor: '#include <aomap_fragment>', after: 'reflectedLight.indirectDiffuse *= groundSky();' },
    {
      // After fog, where colours are those of the screen already, as the sky's are.
      anchor: '#include <fog_fragment>',
      after: 'gl_FragColor.rgb = mix(gl_FragColor.rgb, groundHaze, groundFade());',
    },
  ],
} as const;

/** A disc of meadow that takes the tree's shadow and fades into the horizon. Lambert: a full screen of it must stay cheap. */
export class Ground extends Mesh<CircleGeometry, MeshLambertMaterial> {
  /** The meadow's grass takes these as well. */
  readonly uniforms = {
    grassMap: { value: grassTexture() },
    grassLight: { value: new Color() },
    grassDark: { value: new Color() },
    earth: { value: new Color() },
    groundHaze: { value: new Color() },
    groundReach: { value: new Vector4(20, 60, 0.3, 4) },
  };

  #reach = 10;

  constructor() {
    const material = new MeshLambertMaterial();
    super(new CircleGeometry(1, 64), material);
    inject(material, 'windgrove ground', GROUND_INJECTION, this.uniforms);
    this.rotation.x = -Math.PI / 2;
    this.receiveShadow = true;
    this.name = 'ground';
    this.raycast = () => {};
    this.fit(10, 0.3, 4);
  }

  /** Sizes it for a tree: its reach, radius of the trunk's foot and of the crown in metres. */
  fit(reach: number, foot: number, crown: number): void {
    this.#reach = reach;
    this.uniforms.groundReach.value.set(0, 0, foot, crown);
    this.see(3 * reach);
  }

  /** Reaches from the eye, `distance` metres from the tree, to well beyond the tree; there it fades. */
  see(distance: number): void {
    const { value } = this.uniforms.groundReach;
    value.x = distance + 0.3 * this.#reach;
    value.y = distance + 3.2 * this.#reach;
    this.scale.setScalar(distance + 4 * this.#reach);
  }

  setLook(look: StageLook): void {
    this.uniforms.grassLight.value.set(look.grassLight);
    this.uniforms.grassDark.value.set(look.grassDark);
    this.uniforms.earth.value.set(look.earth);
    this.uniforms.groundHaze.value.set(look.horizon).convertLinearToSRGB();
  }

  override dispose(): void {
    this.geometry.dispose();
    this.material.dispose();
    this.uniforms.grassMap.value.dispose();
  }
}
