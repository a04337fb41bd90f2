import {
  BackSide,
  Color,
  CylinderGeometry,
  DoubleSide,
  GLSL3,
  Mesh,
  ShaderMaterial,
  SphereGeometry,
  Vector3,
  Vector4,
} from 'three';
import fragmentShader from '../../shaders/stage/sky.frag';
import vertexShader from '../../shaders/stage/sky.vert';
import skylineFragment from '../../shaders/stage/skyline.frag';
import skylineVertex from '../../shaders/stage/skyline.vert';
import type { Rgb } from '../core/look/sky-model.ts';
import { ridgeTexture } from './ridge-texture.ts';
import type { StageLook } from './stage-look.ts';
import { cloudTexture } from './stage-textures.ts';

const withShare = (out: Vector4, [[r, g, b], share]: readonly [Rgb, number]): Vector4 => out.set(r, g, b, share);

/** Rows of the dome's corners from top to bottom. */
const ROWS = 48;

/** From where to where the skylines' band reaches, as tangents: up to the dome's first row above the horizon. */
const LOWEST = -0.02;
const HIGHEST = Math.tan(Math.PI / ROWS);

/** A dome around the camera: gradient, glow around the sun, thin cloud, stars, and skylines that end the ground. Its colours are the screen's. */
export class Sky extends Mesh<SphereGeometry, ShaderMaterial> {
  /** What the ground needs to fade into it. */
  readonly uniforms = {
    skyHorizon: { value: new Color() },
    skyMiddle: { value: new Color() },
    skyZenith: { value: new Color() },
    skyGlow: { value: new Color() },
    glowDirection: { value: new Vector3(0, 1, 0) },
    skyField: { value: new Vector4() },
  };

  readonly #clouds = cloudTexture();

  readonly #own = {
    cloudMap: { value: this.#clouds },
    cloudColour: { value: new Color() },
    cloudCover: { value: 0.5 },
    starAmount: { value: 0 },
    discColour: { value: new Color() },
    discDirection: { value: new Vector3(0, 1, 0) },
  };

  readonly #lines = {
    cloudMap: { value: this.#clouds },
    ridgeMap: { value: ridgeTexture() },
    skyline: { value: new Vector4() },
    hillColour: { value: [0, 1, 2, 3].map(() => new Vector4()) },
  };

  readonly #band: Mesh<CylinderGeometry, ShaderMaterial>;

  constructor() {
    const material = new ShaderMaterial({
      glslVersion: GLSL3,
      vertexShader,
      fragmentShader,
      side: BackSide,
      depthWrite: false,
      fog: false,
      toneMapped: false,
    });
    super(new SphereGeometry(1, 40, ROWS), material);
    material.uniforms = { ...this.uniforms, ...this.#own };
    const band = new ShaderMaterial({
      glslVersion: GLSL3,
      vertexShader: skylineVertex,
      fragmentShader: skylineFragment,
      side: DoubleSide,
      fog: false,
      toneMapped: false,
    });
    band.uniforms = { ...this.uniforms, ...this.#lines };
    const ring = new CylinderGeometry(1, 1, HIGHEST - LOWEST, 96, 3, true).translate(0, (HIGHEST + LOWEST) / 2, 0);
    this.#band = new Mesh(ring, band);
    this.#band.frustumCulled = false;
    this.#band.renderOrder = 1; // after what stands in front of it: no pixel is shaded twice
    this.#band.raycast = () => {};
    this.add(this.#band);
    this.name = 'sky';
    this.frustumCulled = false;
    this.renderOrder = 2;
    this.raycast = () => {};
  }

  setLook(look: StageLook): void {
    const { uniforms } = this;
    const own = this.#own;
    uniforms.skyHorizon.value.setRGB(...look.horizon);
    uniforms.skyMiddle.value.setRGB(...look.middle);
    uniforms.skyZenith.value.setRGB(...look.zenith);
    uniforms.skyGlow.value.setRGB(...look.glow);
    uniforms.glowDirection.value.set(...look.glowDirection);
    withShare(uniforms.skyField.value, look.field);
    own.cloudColour.value.setRGB(...look.cloud);
    own.cloudCover.value = look.cloudCover;
    own.starAmount.value = look.stars;
    const starry = look.stars > 0;
    if (starry !== 'STARS' in this.material.defines) {
      if (starry) this.material.defines.STARS = true;
      else delete this.material.defines.STARS;
      this.material.needsUpdate = true;
    }
    own.discColour.value.setRGB(...look.disc);
    own.discDirection.value.set(...look.discDirection);
    this.#lines.skyline.value.set(...look.skyline);
    look.hills.forEach((hill, i) => {
      withShare(this.#lines.hillColour.value[i] as Vector4, hill);
    });
  }

  override dispose(): void {
    this.geometry.dispose();
    this.material.dispose();
    this.#band.geometry.dispose();
    this.#band.material.dispose();
    this.#clouds.dispose();
    this.#lines.ridgeMap.value.dispose();
  }
}
