import {
  BufferAttribute,
  Color,
  CustomBlending,
  GLSL3,
  InstancedBufferAttribute,
  InstancedBufferGeometry,
  LinearFilter,
  LinearMipmapLinearFilter,
  Mesh,
  OrthographicCamera,
  RawShaderMaterial,
  Scene,
  SrcColorFactor,
  type Texture,
  type WebGLRenderer,
  WebGLRenderTarget,
  ZeroFactor,
} from 'three';
import fragmentShader from '../../../shaders/forest/shade.frag';
import vertexShader from '../../../shaders/forest/shade.vert';
import type { HeightField } from '../../core/forest/height-field.ts';
import { type Crown, type Ellipse, shadeEllipse } from './shade-ellipse.ts';

/** A tree that shades the ground. */
export interface ShadeTree extends Crown {
  /** Part of the light that its crown keeps, 0..1. */
  readonly dense: number;
}

/** Texels a side. */
const SIDE = 1024;
const SUN = 0.82;
const SKY = 0.5;

const white = new Color(1, 1, 1);

/**
 * The shade of all trees as one picture of the ground from above, for where no shadow map reaches: red the sunlight that is left, green
 * the open sky. Drawn once a sun or a forest.
 */
export class GroundShade {
  readonly #target = new WebGLRenderTarget(SIDE, SIDE, {
    depthBuffer: false,
    generateMipmaps: true,
    minFilter: LinearMipmapLinearFilter,
    magFilter: LinearFilter,
  });
  readonly #material = new RawShaderMaterial({
    glslVersion: GLSL3,
    vertexShader: `precision highp float;\n${vertexShader}`,
    fragmentShader: `precision highp float;\n${fragmentShader}`,
    uniforms: { shadeScale: { value: 1 } },
    depthTest: false,
    depthWrite: false,
    transparent: true,
    blending: CustomBlending,
    blendSrc: ZeroFactor,
    blendDst: SrcColorFactor,
  });
  readonly #scene = new Scene();
  readonly #camera = new OrthographicCamera();

  constructor() {
    this.#target.texture.name = 'ground shade';
  }

  get texture(): Texture {
    return this.#target.texture;
  }

  /** Draws it. `sun`: unit vector to the light, forest space. Renderer settings are left as they were. */
  draw(
    renderer: WebGLRenderer,
    field: HeightField,
    trees: readonly ShadeTree[],
    sun: readonly [number, number, number],
  ): void {
    const ellipse = new Float32Array(trees.length * 8);
    const strength = new Float32Array(trees.length * 6);
    const out: Ellipse = { x: 0, y: 0, alongX: 0, alongY: 0, across: 0 };
    trees.forEach((tree, i) => {
      shadeEllipse(field, tree, sun, out);
      ellipse.set([out.x, out.y, out.alongX, out.alongY, tree.x, tree.y, 1.25 * tree.wide, 0], i * 8);
      strength.set([out.across, SUN * tree.dense, 0, 1.25 * tree.wide, 0, SKY * tree.dense], i * 6);
    });
    const geometry = new InstancedBufferGeometry();
    geometry.setAttribute('corner', new BufferAttribute(new Float32Array([-1, -1, 1, -1, 1, 1, -1, 1]), 2));
    geometry.setIndex([0, 1, 2, 0, 2, 3]);
    geometry.setAttribute('ellipse', new InstancedBufferAttribute(ellipse, 4));
    geometry.setAttribute('strength', new InstancedBufferAttribute(strength, 3));
    geometry.instanceCount = 2 * trees.length;
    const mesh = new Mesh(geometry, this.#material);
    mesh.frustumCulled = false;
    this.#scene.add(mesh);
    this.#material.uniforms.shadeScale!.value = 2 / field.size;
    const target = renderer.getRenderTarget();
    const clear = renderer.getClearColor(new Color());
    const alpha = renderer.getClearAlpha();
    const { autoClear } = renderer;
    const { needsUpdate } = renderer.shadowMap;
    renderer.shadowMap.needsUpdate = false;
    renderer.autoClear = true;
    renderer.setRenderTarget(this.#target);
    renderer.setClearColor(white, 1);
    renderer.render(this.#scene, this.#camera);
    renderer.setRenderTarget(target);
    renderer.setClearColor(clear, alpha);
    renderer.autoClear = autoClear;
    renderer.shadowMap.needsUpdate = needsUpdate;
    this.#scene.clear();
    geometry.dispose();
  }

  dispose(): void {
    this.#target.dispose();
    this.#material.dispose();
  }
}
