import {
  BufferAttribute,
  BufferGeometry,
  Color,
  type IUniform,
  Mesh,
  MeshLambertMaterial,
  SRGBColorSpace,
  Vector2,
  Vector4,
} from 'three';
import fieldGlsl from '../../shaders/stage/field.glsl';
import groundGlsl from '../../shaders/stage/ground.glsl';
import groundNormal from '../../shaders/stage/ground-normal.glsl';
import groundShadow from '../../shaders/stage/ground-shadow.glsl';
import skyGlsl from '../../shaders/stage/sky.glsl';
import type { ForceField } from './force-field.ts';
import { inject } from './inject.ts';
import { SHADOW_MAP } from './shadow-map.ts';
import type { StageLook } from './stage-look.ts';
import { grassTexture } from './stage-textures.ts';
import type { Sun } from './sun.ts';

/** Where three's Lambert material takes the ground's own colour, its shelter under the tree, and its fading into the sky. */
export const GROUND_INJECTION = {
  vertex: [
    {
      anchor: '#include <common>',
      after: `${fieldGlsl}\n${skyGlsl}\nout vec3 vGround;\nout vec3 vHaze;\nout float vLaid;`,
    },
    {
      anchor: '#include <begin_vertex>',
      // Grass that the wind lays over shows its pale side: gusts run over a meadow as waves of light.
      after: `vGround = (modelMatrix * vec4(position, 1.0)).xyz;
vHaze = farField(vGround - cameraPosition);
vLaid = length(fieldForce(vec2(vGround.x, -vGround.z)));
vLaid /= vLaid + 0.6;`,
    },
  ],
  fragment: [
    { anchor: '#include <common>', after: `${groundGlsl}\nin float vLaid;` },
    { anchor: '#include <shadowmap_pars_fragment>', after: `${SHADOW_MAP}\n${groundShadow}\n${groundNormal}` },
    {
      anchor: '#include <map_fragment>',
      after: 'diffuseColor.rgb *= groundDiffuse() * (1.0 + 0.5 * vLaid);',
    },
    { anchor: '#include <normal_fragment_begin>', after: 'normal = groundNormal(normal);' },
    { anchor: '#include <aomap_fragment>', after: 'reflectedLight.indirectDiffuse *= groundSky();' },
    {
      // After fog, where colours are those of the screen already, as the sky's are.
      anchor: '#include <fog_fragment>',
      after: 'gl_FragColor.rgb = mix(gl_FragColor.rgb, vHaze, groundFade());',
    },
  ],
} as const;

/** Where it ends, in reaches of the tree beyond it. */
const FAR = 14;

/** How far grass stands up to a low light, in which bare ground would be dark. */
const UPRIGHT = 0.45;

/** Half the angle under which the sun is seen, radians. */
const SUN_RADIUS = 0.0047;

/** Rings and sectors of the disc: fine enough near the tree to carry the waves that the wind makes. */
const RINGS = 40;
const SECTORS = 72;

/** A unit disc in x and y, its rings closer the nearer they are to the middle. */
function disc(): BufferGeometry {
  const position: number[] = [0, 0, 0];
  const normal: number[] = [0, 0, 1];
  const index: number[] = [];
  for (let ring = 1; ring <= RINGS; ring++) {
    const radius = (ring / RINGS) ** 2.6;
    for (let i = 0; i < SECTORS; i++) {
      const angle = (i * 2 * Math.PI) / SECTORS;
      position.push(radius * Math.cos(angle), radius * Math.sin(angle), 0);
      normal.push(0, 0, 1);
      const here = 1 + (ring - 1) * SECTORS + i;
      const next = 1 + (ring - 1) * SECTORS + ((i + 1) % SECTORS);
      if (ring === 1) index.push(0, here, next);
      else index.push(here - SECTORS, here, next, here - SECTORS, next, next - SECTORS);
    }
  }
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new BufferAttribute(new Float32Array(position), 3));
  geometry.setAttribute('normal', new BufferAttribute(new Float32Array(normal), 3));
  geometry.setIndex(index);
  return geometry;
}

/** A disc of meadow that takes the tree's shadow and fades into the horizon. Lambert: a full screen of it must stay cheap. */
export class Ground extends Mesh<BufferGeometry, MeshLambertMaterial> {
  /** The meadow's grass takes these as well. */
  readonly uniforms = {
    grassMap: { value: grassTexture() },
    grassLight: { value: new Color() },
    grassDark: { value: new Color() },
    earth: { value: new Color() },
    groundReach: { value: new Vector4(20, 60, 0.3, 4) },
    groundTree: { value: new Vector2(10, 0) },
    groundLook: { value: new Vector4(1, 1, 0, 0) },
    groundShade: { value: new Vector4(1, 0, 1, 0) },
    grassGrowth: { value: new Vector2(1, 0) },
  };

  #reach = 10;

  /** `field`: the wind that runs over it; `sky`: what it fades into. */
  constructor(field: ForceField, sky: Readonly<Record<string, IUniform>>) {
    const material = new MeshLambertMaterial();
    super(disc(), material);
    field.dress(material);
    inject(material, 'windgrove ground', GROUND_INJECTION, { ...this.uniforms, ...field.uniforms, ...sky });
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
    value.x = distance + 0.5 * this.#reach;
    value.y = distance + FAR * this.#reach;
    this.scale.setScalar(distance + (FAR + 0.5) * this.#reach);
    this.uniforms.groundTree.value.x = this.#reach;
  }

  setLook(look: StageLook): void {
    const { grassLight, grassDark, earth, groundLook, grassGrowth } = this.uniforms;
    grassLight.value.setRGB(...look.grassLight, SRGBColorSpace);
    grassDark.value.setRGB(...look.grassDark, SRGBColorSpace);
    earth.value.setRGB(...look.earth, SRGBColorSpace);
    groundLook.value.set(...look.ground);
    this.uniforms.groundTree.value.y = look.blades > 0 ? UPRIGHT : 0;
    grassGrowth.value.set(look.blades, look.flowers);
  }

  /** Takes how shadows fall on it from the light that throws them. `softness`: width of their rims as a multiple of the sun's. */
  setShadow({ direction, texel }: Sun, softness: number): void {
    const level = Math.max(1e-3, Math.hypot(direction.x, direction.z));
    const rim = (SUN_RADIUS * softness) / Math.max(0.05, direction.y) / texel;
    this.uniforms.groundShade.value.set(-direction.x / level, -direction.z / level, direction.y / level, rim);
  }

  override dispose(): void {
    this.geometry.dispose();
    this.material.dispose();
    this.uniforms.grassMap.value.dispose();
  }
}
