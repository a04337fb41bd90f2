import {
  Box3,
  type Camera,
  Color,
  DataTexture,
  Frustum,
  InstancedBufferAttribute,
  type InstancedBufferGeometry,
  type IUniform,
  LinearMipmapNearestFilter,
  Matrix4,
  Mesh,
  MeshLambertMaterial,
  Object3D,
  ShaderChunk,
  SRGBColorSpace,
  type Texture,
  Vector2,
  Vector3,
} from 'three';
import look from '../../../shaders/forest/terrain-look.glsl';
import normal from '../../../shaders/forest/terrain-normal.glsl';
import shadow from '../../../shaders/forest/terrain-shadow.glsl';
import vertex from '../../../shaders/forest/terrain-vertex.glsl';
import type { HeightField } from '../../core/forest/height-field.ts';
import type { ForceField } from '../force-field.ts';
import type { Ground } from '../ground.ts';
import { inject } from '../inject.ts';
import { SHADOW_MAP } from '../shadow-map.ts';
import type { StageLook } from '../stage-look.ts';
import { type TerrainMaps, terrainMaps } from './terrain-maps.ts';
import { terrainPatch } from './terrain-patch.ts';
import { PATCH_CELLS, type Tile, terrainTiles, tileDetail } from './terrain-tiles.ts';

/** Three's own lookup of shadows is one that `terrainShadow` knows; an older one is called. */
const LOOKS = ShaderChunk.shadowmap_pars_fragment.includes('interleavedGradientNoise') ? '#define TERRAIN_LOOKS' : '';

/** Where three's Lambert material takes the shape, the colours and the haze of the forest's ground. */
export const TERRAIN_INJECTION = {
  vertex: [
    { anchor: '#include <common>', after: vertex },
    { anchor: '#include <beginnormal_vertex>', instead: 'vec3 objectNormal = vec3(0.0, 0.0, 1.0);' },
    {
      anchor: '#include <begin_vertex>',
      instead: `vec3 transformed = terrainPoint();
vTerrain = transformed.xy;
vGround = (modelMatrix * vec4(transformed, 1.0)).xyz;
vHaze = farField(vGround - cameraPosition);
vSlow = terrainSlow(vTerrain, distance(vGround, cameraPosition));
// As crowns are: what a wind does to all grass alike shows no gust.
vLaid = crownLaid(length(fieldForce(transformed.xy)), terrainMean);`,
    },
  ],
  fragment: [
    { anchor: '#include <common>', after: `#define TERRAIN_MESH\n${look}\nin float vLaid;` },
    { anchor: '#include <shadowmap_pars_fragment>', after: `${SHADOW_MAP}\n${LOOKS}\n${shadow}\n${normal}` },
    {
      anchor: '#include <map_fragment>',
      after: 'diffuseColor.rgb *= terrainDiffuse(); diffuseColor.rgb *= 1.0 + 0.4 * vLaid * terrainLight.y;',
    },
    { anchor: '#include <normal_fragment_begin>', instead: 'vec3 normal = terrainNormal();' },
    // What the eye's direction is does not matter to a Lambert surface: it is not worked out.
    {
      anchor: '#include <lights_fragment_begin>',
      before: '#define isOrthographic true',
      after: '#undef isOrthographic',
    },
    {
      anchor: '#include <aomap_fragment>',
      after: `reflectedLight.indirectDiffuse *= terrainSky();
#ifndef USE_SHADOWMAP
reflectedLight.directDiffuse *= terrainLight.x;
#endif`,
    },
    {
      anchor: '#include <fog_fragment>',
      after: 'gl_FragColor.rgb = mix(gl_FragColor.rgb, vHaze, terrainFade());',
    },
  ],
} as const;

/** Cells of the grid of heights, a side. */
const CELLS = 256;

/** Of the meshes, the one of the tiles outside; those before it are those of PATCH_CELLS. */
const OUTSIDE = PATCH_CELLS.length;

/** How far grass stands up to a low light. */
const UPRIGHT = 0.3;

/** A texel that says: all light, open sky. */
function openSky(): DataTexture {
  const texture = new DataTexture(new Uint8Array([255, 255, 255, 255]), 1, 1);
  texture.needsUpdate = true;
  return texture;
}

const frustum = new Frustum();
const matrix = new Matrix4();
const box = new Box3();
const eye = new Vector3();

/** The ground of a forest: hills from a height field, going over into open land that the haze takes. Forest space, z up. */
export class Terrain extends Object3D {
  /** What grass that stands on it takes as well. */
  readonly uniforms: Ground['uniforms'] & Record<string, IUniform>;
  readonly material = new MeshLambertMaterial();
  /** Of what lies within the square: without what is only outside of it. */
  readonly #within = new MeshLambertMaterial();
  readonly #field: ForceField;
  readonly #own = {
    terrainHeights: { value: null as Texture | null },
    terrainNormals: { value: null as Texture | null },
    terrainPlace: { value: new Vector3(0.01, 1, 0) },
    terrainShade: { value: null as Texture | null },
    terrainLitter: { value: new Color('#6b5438') },
    terrainAir: { value: new Vector2(0.001, 1) },
    terrainMean: { value: 1 },
  };
  readonly #open = openSky();
  readonly #grass: DataTexture;
  readonly #places: InstancedBufferAttribute[] = [];
  readonly #meshes: Mesh<InstancedBufferGeometry, MeshLambertMaterial>[] = [];
  #tiles: readonly Tile[] = [];
  #maps: TerrainMaps | null = null;

  /** `ground`: whose colours it has; `field`: the wind that runs over it; `sky`: what it fades into. */
  constructor(ground: Ground, field: ForceField, sky: Readonly<Record<string, IUniform>>) {
    super();
    this.name = 'terrain';
    const { grassMap, grassLight, grassDark, earth, groundLook, groundShade, grassGrowth } = ground.uniforms;
    // Looks at it make up most of what a pixel of the ground costs; between two mip levels each would be two.
    this.#grass = grassMap.value.clone();
    this.#grass.minFilter = LinearMipmapNearestFilter;
    this.#grass.needsUpdate = true;
    this.uniforms = {
      grassMap: { value: this.#grass },
      grassLight,
      grassDark,
      earth,
      groundLook,
      groundShade,
      grassGrowth,
      // No single tree: nothing is bare or dark around the middle of the world.
      groundReach: { value: ground.uniforms.groundReach.value.clone().set(200, 1000, 1e-3, 1e-3) },
      groundTree: { value: new Vector2(10, UPRIGHT) },
      ...this.#own,
    };
    this.#own.terrainShade.value = this.#open;
    this.#field = field;
    this.#within.defines = { TERRAIN_WITHIN: 1 };
    for (const material of [this.material, this.#within]) {
      field.dress(material);
      material.fog = false; // its haze has the colour of the direction
      inject(material, 'windgrove terrain', TERRAIN_INJECTION, { ...this.uniforms, ...field.uniforms, ...sky });
    }
    this.rotation.x = -Math.PI / 2;
    for (const cells of [...PATCH_CELLS, PATCH_CELLS[0]]) {
      const material = this.#meshes.length === OUTSIDE ? this.material : this.#within;
      const places = new InstancedBufferAttribute(new Float32Array(3 * 96), 3);
      const mesh = new Mesh(terrainPatch(cells, places), material);
      mesh.frustumCulled = false; // tile by tile
      mesh.receiveShadow = true;
      mesh.raycast = () => {};
      this.#places.push(places);
      this.#meshes.push(mesh);
      this.add(mesh);
    }
  }

  get maps(): TerrainMaps | null {
    return this.#maps;
  }

  setField(field: HeightField): void {
    this.#dropMaps();
    const maps = terrainMaps(field, CELLS);
    this.#maps = maps;
    this.#tiles = terrainTiles(field.size);
    this.#own.terrainHeights.value = maps.heights;
    this.#own.terrainNormals.value = maps.normals;
    this.#own.terrainPlace.value.set(1 / field.size, maps.cells, maps.edge);
    this.uniforms.groundReach.value.setX(1.2 * field.size).setY(4 * field.size);
  }

  /** Mean force of the wind, metres: what is more is a gust, which lays the grass over. */
  set meanForce(metres: number) {
    this.#own.terrainMean.value = metres;
  }

  /** Shade of the trees as a picture of the square from above (GroundShade); null: none. */
  setShade(texture: Texture | null): void {
    this.#own.terrainShade.value = texture ?? this.#open;
  }

  setLook(stageLook: StageLook): void {
    this.uniforms.groundTree.value.y = stageLook.blades > 0 ? UPRIGHT : 0;
    this.uniforms.groundLook.value.setZ(0).setW(0); // no mower, no path
  }

  /** Colour of what lies under the trees, as the screen has it. */
  setLitter(r: number, g: number, b: number): void {
    this.#own.terrainLitter.value.setRGB(r, g, b, SRGBColorSpace);
  }

  /** Density of the haze, 1 / metre. */
  set haze(density: number) {
    this.#own.terrainAir.value.x = density;
  }

  /** Chooses the tiles for a camera and how finely each is drawn. */
  see(camera: Camera): void {
    const maps = this.#maps;
    if (!maps) return;
    this.updateWorldMatrix(true, false);
    frustum.setFromProjectionMatrix(matrix.multiplyMatrices(camera.projectionMatrix, camera.matrixWorldInverse));
    eye.setFromMatrixPosition(camera.matrixWorld);
    this.#field.dress(this.#within);
    const counts = [0, 0, 0, 0];
    for (const tile of this.#tiles) {
      const { x, y, side } = tile;
      box.min.set(x, y, maps.low - 0.06 * side);
      box.max.set(x + side, y + side, maps.high);
      box.applyMatrix4(this.matrixWorld);
      if (!frustum.intersectsBox(box)) continue;
      const kind = tile.inside ? tileDetail(tile, box.distanceToPoint(eye)) : OUTSIDE;
      const n = counts[kind] as number;
      (this.#places[kind] as InstancedBufferAttribute).setXYZ(n, x, y, side);
      counts[kind] = n + 1;
    }
    this.#meshes.forEach((mesh, i) => {
      const count = counts[i] as number;
      mesh.visible = count > 0;
      mesh.geometry.instanceCount = count;
      (this.#places[i] as InstancedBufferAttribute).needsUpdate = true;
    });
  }

  override dispose(): void {
    this.#dropMaps();
    this.#open.dispose();
    this.#grass.dispose();
    for (const { geometry } of this.#meshes) geometry.dispose();
    this.material.dispose();
    this.#within.dispose();
  }

  #dropMaps(): void {
    this.#maps?.heights.dispose();
    this.#maps?.normals.dispose();
    this.#maps = null;
  }
}
