import { BackSide, Color, type DataTexture, GLSL3, Mesh, ShaderMaterial, SphereGeometry, Vector3 } from 'three';
import fragmentShader from '../../shaders/stage/sky.frag';
import vertexShader from '../../shaders/stage/sky.vert';
import type { StageLook } from './stage-look.ts';
import { cloudTexture } from './stage-textures.ts';

/** A colour as the screen shows it: the sky is not lit and not tone mapped, so its shader works in sRGB. */
const onScreen = (hex: string, out: Color): Color => out.set(hex).convertLinearToSRGB();

/** A dome of sky around the camera: gradient, haze around the sun, thin cloud. */
export class Sky extends Mesh<SphereGeometry, ShaderMaterial> {
  readonly #clouds: DataTexture;

  constructor() {
    const clouds = cloudTexture();
    const material = new ShaderMaterial({
      glslVersion: GLSL3,
      vertexShader,
      fragmentShader,
      side: BackSide,
      depthWrite: false,
      fog: false,
      toneMapped: false,
      uniforms: {
        skyHorizon: { value: new Color() },
        skyMiddle: { value: new Color() },
        skyZenith: { value: new Color() },
        skySun: { value: new Color() },
        cloudColour: { value: new Color() },
        cloudCover: { value: 0.5 },
        cloudMap: { value: clouds },
        sunDirection: { value: new Vector3(0, 1, 0) },
      },
    });
    super(new SphereGeometry(1, 36, 48), material);
    this.#clouds = clouds;
    this.name = 'sky';
    this.frustumCulled = false;
    this.renderOrder = 1; // after what stands in front of it: no pixel is shaded twice
    this.raycast = () => {};
  }

  setLook(look: StageLook, sunDirection: Vector3): void {
    const { uniforms } = this.material;
    onScreen(look.horizon, uniforms.skyHorizon.value);
    onScreen(look.middle, uniforms.skyMiddle.value);
    onScreen(look.zenith, uniforms.skyZenith.value);
    onScreen(look.haze, uniforms.skySun.value);
    onScreen(look.cloud, uniforms.cloudColour.value);
    uniforms.cloudCover.value = look.cloudCover;
    uniforms.sunDirection.value.copy(sunDirection).normalize();
  }

  override dispose(): void {
    this.geometry.dispose();
    this.material.dispose();
    this.#clouds.dispose();
  }
}
