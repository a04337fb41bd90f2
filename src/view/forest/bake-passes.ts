import {
  BufferAttribute,
  BufferGeometry,
  GLSL3,
  type IUniform,
  LinearFilter,
  LinearMipmapLinearFilter,
  Mesh,
  NearestFilter,
  NoBlending,
  OrthographicCamera,
  RawShaderMaterial,
  Scene,
  type WebGLRenderer,
  WebGLRenderTarget,
} from 'three';
import cellShader from '../../../shaders/forest/impostor-cell.frag';
import coverShader from '../../../shaders/forest/impostor-cover.frag';
import passShader from '../../../shaders/forest/impostor-pass.vert';
import reduceShader from '../../../shaders/forest/impostor-reduce.frag';
import storeShader from '../../../shaders/forest/impostor-store.frag';
import type { ImpostorAtlas } from './impostor-atlas.ts';

/** How much finer than its cell a view is drawn, as a power of two. */
const FINER = 1;
/** Texels of gutter to each side of a cell. */
const GUTTER = 1.5;

const shader = (fragment: string, uniforms: Record<string, IUniform>): RawShaderMaterial =>
  new RawShaderMaterial({
    glslVersion: GLSL3,
    vertexShader: `precision highp float;\n${passShader}`,
    fragmentShader: `precision highp float;\nprecision highp int;\n${fragment}`,
    uniforms,
    depthTest: false,
    depthWrite: false,
    blending: NoBlending,
  });

/** Two textures that one draw writes: colours with coverage, and shape. */
function pair(width: number, mipmaps: boolean, depthBuffer: boolean): WebGLRenderTarget {
  const target = new WebGLRenderTarget(width, width, {
    count: 2,
    depthBuffer,
    generateMipmaps: mipmaps,
    minFilter: mipmaps ? LinearMipmapLinearFilter : NearestFilter,
    magFilter: mipmaps ? LinearFilter : NearestFilter,
  });
  // As the atlas has them: light is filtered, not what a screen shows.
  (target.textures[0] as { internalFormat: string | null }).internalFormat = 'SRGB8_ALPHA8';
  return target;
}

/** From one finely drawn view to its cell, and from the cells to the levels of an atlas. All on the GPU: nothing is read back. */
export class BakePasses {
  /** What a view is drawn into. */
  readonly view: WebGLRenderTarget;
  readonly #atlas: ImpostorAtlas;
  readonly #chain: WebGLRenderTarget[];
  readonly #cover: WebGLRenderTarget;
  readonly #cell = shader(cellShader, {
    viewColour: { value: null },
    viewShape: { value: null },
    level: { value: FINER },
    filled: { value: 1 },
  });
  readonly #reduce = shader(reduceShader, { fineColour: { value: null }, fineShape: { value: null } });
  readonly #coverage = shader(coverShader, { fineColour: { value: null }, cell: { value: 1 } });
  readonly #store = shader(storeShader, {
    fineColour: { value: null },
    thresholds: { value: null },
    scaled: { value: 1 },
    cell: { value: 1 },
  });
  readonly #mesh: Mesh;
  readonly #scene = new Scene();
  readonly #camera = new OrthographicCamera();

  constructor(atlas: ImpostorAtlas) {
    this.#atlas = atlas;
    const { size, views, levels } = atlas;
    this.view = pair(size << FINER, true, true);
    this.#chain = Array.from({ length: levels }, (_, level) => pair((views * size) >> level, false, false));
    this.#cover = new WebGLRenderTarget(views, views, {
      depthBuffer: false,
      minFilter: NearestFilter,
      magFilter: NearestFilter,
    });
    const triangle = new BufferGeometry();
    triangle.setAttribute('position', new BufferAttribute(new Float32Array([-1, -1, 0, 3, -1, 0, -1, 3, 0]), 3));
    this.#mesh = new Mesh(triangle, this.#cell);
    this.#mesh.frustumCulled = false;
    this.#scene.add(this.#mesh);
  }

  /** Part of a cell's side that its view fills. */
  get filled(): number {
    return 1 - (2 * GUTTER) / this.#atlas.size;
  }

  /** Takes what `view` holds into cell (i, j). */
  takeView(renderer: WebGLRenderer, i: number, j: number): void {
    const { size } = this.#atlas;
    const { uniforms } = this.#cell;
    const [colour, shape] = this.view.textures;
    if (!uniforms.viewColour || !uniforms.viewShape || !uniforms.filled) return;
    uniforms.viewColour.value = colour;
    uniforms.viewShape.value = shape;
    uniforms.filled.value = this.filled;
    const target = this.#chain[0] as WebGLRenderTarget;
    target.viewport.set(i * size, j * size, size, size);
    this.#draw(renderer, this.#cell, target);
    target.viewport.set(0, 0, target.width, target.height);
  }

  /** Makes the coarser levels of the cells and stores them all as a layer. */
  storeLayer(renderer: WebGLRenderer, layer: number): void {
    const { size, levels, colourTarget, shapeTarget } = this.#atlas;
    for (let level = 0; level < levels; level++) {
      const target = this.#chain[level] as WebGLRenderTarget;
      const [colour, shape] = target.textures;
      if (level > 0) {
        const fine = this.#chain[level - 1] as WebGLRenderTarget;
        set(this.#reduce, { fineColour: fine.textures[0], fineShape: fine.textures[1] });
        this.#draw(renderer, this.#reduce, target);
      }
      set(this.#coverage, { fineColour: colour, cell: size >> level });
      this.#draw(renderer, this.#coverage, this.#cover);
      set(this.#store, { fineColour: colour, thresholds: this.#cover.texture, scaled: 1, cell: size >> level });
      this.#draw(renderer, this.#store, colourTarget, layer, level);
      set(this.#store, { fineColour: shape, scaled: 0 });
      this.#draw(renderer, this.#store, shapeTarget, layer, level);
    }
  }

  dispose(): void {
    this.view.dispose();
    this.#cover.dispose();
    for (const target of this.#chain) target.dispose();
    for (const material of [this.#cell, this.#reduce, this.#coverage, this.#store]) material.dispose();
    this.#mesh.geometry.dispose();
  }

  #draw(renderer: WebGLRenderer, material: RawShaderMaterial, target: WebGLRenderTarget, layer = 0, level = 0): void {
    const { width, height } = target;
    if (level > 0) target.viewport.set(0, 0, width >> level, height >> level);
    this.#mesh.material = material;
    renderer.setRenderTarget(target, layer, level);
    renderer.render(this.#scene, this.#camera);
    if (level > 0) target.viewport.set(0, 0, width, height);
  }
}

function set(material: RawShaderMaterial, values: Record<string, unknown>): void {
  for (const [name, value] of Object.entries(values)) {
    const uniform = material.uniforms[name];
    if (uniform) uniform.value = value;
  }
}
