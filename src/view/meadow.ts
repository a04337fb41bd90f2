import {
  BufferAttribute,
  BufferGeometry,
  type Camera,
  DoubleSide,
  type IUniform,
  Mesh,
  MeshLambertMaterial,
  Vector3,
} from 'three';
import grassGlsl from '../../shaders/stage/grass.glsl';
import groundGlsl from '../../shaders/stage/ground.glsl';
import groundNormal from '../../shaders/stage/ground-normal.glsl';
import { hashPcg, hashUnit } from '../core/math/hash.ts';
import type { ForceField } from './force-field.ts';
import type { Ground } from './ground.ts';
import { type Injection, inject } from './inject.ts';

const ahead = new Vector3();

/** Tufts, blades of each. */
const TUFTS = 10_000;
const BLADES = 2;

/** Half the side of the square of grass, metres, for a middle at a distance of a metre; it grows with this power of the distance. */
const SPREAD = 1.25;
const GROWS = 0.8;
/** How far below the middle of the view the middle of the grass lies, and how far below the horizon at least; radians. */
const BELOW = 0.16;
const LEAST = 0.115;

/** Where three's Lambert material takes the blades and the colour of the ground that they stand on. */
export const GRASS_INJECTION = {
  vertex: [
    { anchor: '#include <common>', after: grassGlsl },
    { anchor: '#include <beginnormal_vertex>', instead: 'vec3 objectNormal = vec3(0.0, 1.0, 0.0);' },
    {
      anchor: '#include <begin_vertex>',
      instead: `vec3 transformed = grassPoint();
vGround = (modelMatrix * vec4(transformed, 1.0)).xyz;
vHaze = farField(vGround - cameraPosition);`,
    },
  ],
  fragment: [
    { anchor: '#include <common>', after: `${groundGlsl}\nin vec4 vBlade;` },
    {
      anchor: '#include <map_fragment>',
      after: `diffuseColor.rgb *= mix(groundDiffuse() * 0.82, grassLight * (0.8 + 0.45 * vBlade.y + 0.3 * vBlade.z), vBlade.x * 0.7);
if (vBlade.w > 0.0) diffuseColor.rgb = vBlade.w < 0.6 ? vec3(0.78, 0.76, 0.7) : mix(vec3(0.75, 0.55, 0.08), vec3(0.42, 0.3, 0.6), step(0.86, vBlade.w));`,
    },
    { anchor: '#include <shadowmap_pars_fragment>', after: groundNormal },
    // Both sides of a blade are lit as the ground under it is.
    { anchor: '#include <normal_fragment_begin>', after: 'normal = groundNormal(normal * faceDirection);' },
    { anchor: '#include <aomap_fragment>', after: 'reflectedLight.indirectDiffuse *= groundSky();' },
    {
      anchor: '#include <fog_fragment>',
      after: 'gl_FragColor.rgb = mix(gl_FragColor.rgb, vHaze, groundFade());',
    },
  ],
} as const;

/** Blades as one mesh over a square of side 2, which the shader lays out before the eye. */
function blades(): BufferGeometry {
  const position = new Float32Array(TUFTS * BLADES * 9);
  const shape = new Float32Array(TUFTS * BLADES * 9);
  let h = 4711;
  const draw = (): number => {
    h = hashPcg(h);
    return hashUnit(h);
  };
  let at = 0;
  for (let tuft = 0; tuft < TUFTS; tuft++) {
    const tuftX = 2 * draw() - 1;
    const tuftZ = 2 * draw() - 1;
    const size = 0.09 + 0.16 * draw() ** 2;
    for (let blade = 0; blade < BLADES; blade++) {
      const way = draw() * Math.PI * 2;
      const root = 0.05 * draw();
      const x = Math.cos(way) * root;
      const z = Math.sin(way) * root;
      const half = size * (0.05 + 0.05 * draw());
      const lean = size * (0.15 + 0.55 * draw());
      const height = size * (0.6 + 0.5 * draw());
      const tone = draw();
      const corners = [
        [0, x - Math.sin(way) * half, z + Math.cos(way) * half],
        [0, x + Math.sin(way) * half, z - Math.cos(way) * half],
        [height, x + Math.cos(way) * lean, z + Math.sin(way) * lean],
      ] as const;
      for (const [up, dx, dz] of corners) {
        position.set([tuftX, up, tuftZ], at);
        shape.set([dx, dz, tone], at);
        at += 3;
      }
    }
  }
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new BufferAttribute(position, 3));
  geometry.setAttribute('normal', new BufferAttribute(shape, 3));
  return geometry;
}

/** Grass that stands on the ground. It takes shadows and casts none. */
export class Meadow extends Mesh<BufferGeometry, MeshLambertMaterial> {
  /** Middle of the square before the eye, and half its side as a power of two. */
  readonly #square = { value: new Vector3(0, 0, 3) };

  /** `field`: the wind that lays the grass over; `sky`: what it fades into; `injection`: its shader where the ground is not this stage's, with a name. */
  constructor(
    ground: { readonly uniforms: Ground['uniforms'] & Record<string, IUniform> },
    field: ForceField,
    sky: Readonly<Record<string, IUniform>>,
    [key, injection]: readonly [string, Injection] = ['windgrove grass', GRASS_INJECTION],
  ) {
    const material = new MeshLambertMaterial();
    super(blades(), material);
    field.dress(material);
    material.side = DoubleSide; // a blade has no back
    inject(material, key, injection, {
      ...ground.uniforms,
      ...field.uniforms,
      ...sky,
      grassSquare: this.#square,
    });
    this.name = 'meadow';
    this.receiveShadow = true;
    this.frustumCulled = false;
    this.raycast = () => {};
  }

  /** Part of the tufts that grow, 0..1; `visible` is for whoever draws. */
  set growing(part: number) {
    this.geometry.setDrawRange(0, Math.round(TUFTS * part) * BLADES * 3);
  }

  /** Lays the grass where the lower part of the picture shows the ground: few blades, all of them seen. `height`: of the eye above the ground. */
  see(camera: Camera, height = camera.position.y): void {
    camera.getWorldDirection(ahead);
    const level = Math.max(1e-3, Math.hypot(ahead.x, ahead.z));
    const below = Math.max(LEAST, BELOW - Math.atan2(ahead.y, level));
    const away = Math.max(0.1, height) / Math.tan(Math.min(1.4, below));
    const x = camera.position.x + (ahead.x / level) * away;
    const z = camera.position.z + (ahead.z / level) * away;
    this.#square.value.set(x, z, Math.log2(SPREAD * away ** GROWS));
  }

  override dispose(): void {
    this.geometry.dispose();
    this.material.dispose();
  }
}
