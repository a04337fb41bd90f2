import {
  DataTexture,
  FloatType,
  LinearFilter,
  LinearMipmapLinearFilter,
  RGBAFormat,
  type Texture,
  WebGLArrayRenderTarget,
} from 'three';

/** Numbers of a layer in the table, four a texel: ROW says which. */
const ROW_TEXELS = 6;

/** What a layer shows, metres in tree space. */
export interface LayerFacts {
  readonly centre: readonly [number, number, number];
  /** Half of the width and of the height of a view. */
  readonly halfWidth: number;
  readonly halfHeight: number;
  readonly height: number;
  /** Metres that the top of the crown moves for a force of 1 m: crownGive. */
  readonly give: number;
  /** Light that is lost in the crown, 1/m. */
  readonly density: number;
  /** Middle and radii. */
  readonly crown: ArrayLike<number>;
  /** Height above which all that is seen counts as leaves. */
  readonly leafLow: number;
  /** Linear colour of the light that leaves let through. */
  readonly through: readonly [number, number, number];
  readonly roughness: number;
  /** Light that a blade lets through, 1 for one of common thickness, 0 where there are none: such turn in a gust. */
  readonly thin: number;
}

export interface AtlasOptions {
  /** Views along a side of a layer. Default 8. */
  views?: number;
  /** Texels along a side of a view; a power of two. Default 64. */
  size?: number;
  /** Layers that there is room for. Default 32. */
  layers?: number;
}

/** Texels along a side that the coarsest level leaves of a view. */
const LEAST = 4;

function arrayTarget(
  side: number,
  layers: number,
  levels: number,
  srgb: boolean,
  name: string,
): WebGLArrayRenderTarget {
  const target = new WebGLArrayRenderTarget(side, side, layers, {
    depthBuffer: false,
    generateMipmaps: false,
    magFilter: LinearFilter,
    minFilter: LinearMipmapLinearFilter,
  });
  const { texture } = target;
  texture.name = name;
  // Colours are stored as the eye tells them apart, and read as light; three is told nothing of it, or it would turn them about itself.
  if (srgb) texture.internalFormat = 'SRGB8_ALPHA8';
  // As many entries as there are levels: each is drawn.
  texture.mipmaps = Array.from({ length: levels }, (_, level) => ({
    data: new Uint8Array(0),
    width: side >> level,
    height: side >> level,
  }));
  return target;
}

/**
 * Pictures of trees from all sides, a layer each: colour before light with coverage; and normal (in the frame of the view: x, y), depth
 * and light of the sky. Views stand in a square, as the hemi-octahedral map has them.
 */
export class ImpostorAtlas {
  readonly views: number;
  readonly size: number;
  readonly layers: number;
  readonly levels: number;
  readonly colourTarget: WebGLArrayRenderTarget;
  readonly shapeTarget: WebGLArrayRenderTarget;
  /** RGBA32F, a row a layer: LayerFacts. */
  readonly table: DataTexture;
  readonly #facts: (LayerFacts | null)[];

  constructor({ views = 8, size = 64, layers = 32 }: AtlasOptions = {}) {
    this.views = views;
    this.size = size;
    this.layers = layers;
    this.levels = Math.max(1, Math.log2(size / LEAST) + 1);
    const side = views * size;
    this.colourTarget = arrayTarget(side, layers, this.levels, true, 'impostor colours');
    this.shapeTarget = arrayTarget(side, layers, this.levels, false, 'impostor shapes');
    this.table = new DataTexture(new Float32Array(ROW_TEXELS * 4 * layers), ROW_TEXELS, layers, RGBAFormat, FloatType);
    this.table.name = 'impostor table';
    this.#facts = new Array<LayerFacts | null>(layers).fill(null);
  }

  get colours(): Texture {
    return this.colourTarget.texture;
  }

  get shapes(): Texture {
    return this.shapeTarget.texture;
  }

  /** Bytes that one layer takes on the GPU, with its coarser levels. */
  get bytesPerLayer(): number {
    const side = this.views * this.size;
    let texels = 0;
    for (let level = 0; level < this.levels; level++) texels += (side >> level) ** 2;
    return 8 * texels;
  }

  get bytes(): number {
    return this.layers * this.bytesPerLayer;
  }

  /** What a layer shows; null while nothing is told of it. */
  facts(layer: number): LayerFacts | null {
    return this.#facts[layer] ?? null;
  }

  /** Says what a layer shows. */
  setFacts(layer: number, facts: LayerFacts): void {
    this.#facts[layer] = facts;
    const { centre, crown, through } = facts;
    const row = [
      [...centre, facts.halfWidth],
      [facts.halfHeight, facts.height, facts.give, facts.density],
      [crown[0], crown[1], crown[2], facts.leafLow],
      [crown[3], crown[4], crown[5], facts.roughness],
      [...through, facts.thin],
    ].flat();
    (this.table.image.data as Float32Array).set(row as number[], ROW_TEXELS * 4 * layer);
    this.table.needsUpdate = true;
  }

  dispose(): void {
    this.colourTarget.dispose();
    this.shapeTarget.dispose();
    this.table.dispose();
  }
}
