import {
  ACESFilmicToneMapping,
  Box3,
  HemisphereLight,
  PCFShadowMap,
  PerspectiveCamera,
  Scene,
  Spherical,
  SRGBColorSpace,
  Vector3,
  WebGLRenderer,
} from 'three';
import type { StageId } from '../core/link/link.ts';
import type { WindSource } from '../gpu/wind-source.ts';
import { ForceField } from './force-field.ts';
import { type Framing, frameTree } from './framing.ts';
import { Ground } from './ground.ts';
import { Meadow } from './meadow.ts';
import { Sky } from './sky.ts';
import { CAMERA_AZIMUTH } from './sky-place.ts';
import { lookAt, type StageLook } from './stage-look.ts';
import { Sun } from './sun.ts';

/** What a stage may be asked for. */
export interface StageOptions {
  /** Texels a side of the shadow map; 0 for no shadows. Default 1024. */
  shadows?: number;
  /** Smooths edges in hardware; on software GL it doubles the cost. Default true. */
  antialias?: boolean;
  /** The picture has an alpha channel: what nothing is drawn on is transparent. Default false. */
  alpha?: boolean;
  /** Keep the drawing after it was shown, so that it can be copied. Default false. */
  preserveDrawingBuffer?: boolean;
}

/** Vertical field of view in degrees, the feel of a 50 mm lens. */
export const FOV = 30;

/** To the side of the sun, so that crowns have a lit and a shaded side. */
export const AZIMUTH = CAMERA_AZIMUTH;

/** Part of the grass that grows, where nobody says. */
const GRASS = 0.36;

/** Least height of the eye above the meadow in metres, and what it gains with the distance beyond that of a whole tree. */
const LOWEST = 0.15;
const RISE = 0.08;

/** What a stage is fitted to before there is a tree. */
export const EMPTY = new Box3(new Vector3(-2, 0, -2), new Vector3(2, 6, 2));

/** A meadow under the sky for one tree: renderer, camera, sun, ground. Who draws it puts the camera; stage.ts adds hands. */
export class BareStage {
  readonly renderer: WebGLRenderer;
  readonly scene = new Scene();
  readonly camera = new PerspectiveCamera(FOV, 1, 0.05, 2000);
  /** What the camera looks at. */
  readonly target = new Vector3();
  readonly sun: Sun;
  readonly hemisphere = new HemisphereLight();
  readonly sky = new Sky();
  /** The wind over the meadow: `blow` fills it. */
  readonly field = new ForceField();
  readonly ground = new Ground(this.field, this.sky.uniforms);
  readonly meadow = new Meadow(this.ground, this.field, this.sky.uniforms);
  /** CSS pixels. */
  protected width = 1;
  protected height = 1;
  readonly #spherical = new Spherical();
  #reach = 6;
  #dark = false;
  #place: { readonly stage: StageId; readonly hour: number | null } = { stage: 'meadow', hour: null };
  #softness = 1;
  #grass = GRASS;
  #grows = true;

  /** Draws on `canvas`. Throws where the browser gives no WebGL2 context. */
  constructor(
    canvas: HTMLCanvasElement,
    { shadows = 1024, antialias = true, alpha = false, preserveDrawingBuffer = false }: StageOptions = {},
  ) {
    this.renderer = new WebGLRenderer({
      canvas,
      antialias,
      alpha,
      preserveDrawingBuffer,
      powerPreference: 'high-performance',
    });
    this.renderer.outputColorSpace = SRGBColorSpace;
    this.renderer.toneMapping = ACESFilmicToneMapping;
    this.renderer.shadowMap.enabled = shadows > 0;
    this.renderer.shadowMap.type = PCFShadowMap;
    this.renderer.shadowMap.autoUpdate = false;
    this.sun = new Sun(shadows || 1);
    this.sun.castShadow = shadows > 0;
    this.scene.add(this.sky, this.ground, this.meadow, this.sun, this.sun.target, this.hemisphere);
    this.#light(lookAt('meadow', null, false));
    this.#fit(EMPTY);
  }

  /** Sizes the picture: CSS pixels, and device pixels to each. */
  resize(width: number, height: number, pixelRatio = 1): void {
    this.width = Math.max(1, Math.round(width));
    this.height = Math.max(1, Math.round(height));
    this.renderer.setPixelRatio(Math.min(2, Math.max(0.25, pixelRatio)));
    this.renderer.setSize(this.width, this.height, false);
    this.shape();
  }

  setDark(dark: boolean): void {
    this.#dark = dark;
    this.relight();
  }

  get place(): { readonly stage: StageId; readonly hour: number | null } {
    return this.#place;
  }

  /** Where the tree stands; `hour` of the day by the sun, 0..24, null: the stage's own. */
  setScene(stage: StageId, hour: number | null): void {
    this.#place = { stage, hour };
    this.relight();
  }

  /** How finely light and grass are drawn: texels a side of the shadow map, part of the grass that grows (0..1). */
  setFineness({ shadows, grass }: { readonly shadows: number; readonly grass: number }): void {
    this.#grass = grass;
    this.#applyGrass();
    if (!this.sun.castShadow) return;
    this.sun.mapSize = shadows;
    this.ground.setShadow(this.sun, this.#softness);
    this.renderer.shadowMap.needsUpdate = true;
  }

  #applyGrass(): void {
    this.meadow.growing = this.#grows ? this.#grass : 0;
  }

  /** The light as it falls. */
  protected look(): StageLook {
    return lookAt(this.#place.stage, this.#place.hour, this.#dark);
  }

  protected relight(): void {
    this.#light(this.look());
  }

  #light(look: StageLook): void {
    const { sun, hemisphere } = this;
    this.sky.setLook(look);
    this.ground.setLook(look);
    sun.color.setRGB(...look.sun);
    sun.intensity = look.sunIntensity;
    sun.shadow.radius = 1.6 * look.softness;
    sun.shineFrom(...look.direction);
    this.#softness = look.softness;
    this.ground.setShadow(sun, look.softness);
    hemisphere.color.setRGB(...look.skyLight);
    hemisphere.groundColor.setRGB(...look.groundLight);
    hemisphere.intensity = look.skyIntensity;
    this.#grows = look.blades > 0;
    this.#applyGrass();
    this.renderer.toneMappingExposure = look.exposure;
    this.renderer.shadowMap.needsUpdate = true;
  }

  /** Fits ground, sun and shadow to what stands on the stage: a box in metres, y up. The camera stays. Returns its reach in metres. */
  setSubject(box: Box3, foot?: number): number {
    return this.#fit(box, foot);
  }

  #fit(box: Box3, foot = 0.02 * (box.max.y - box.min.y)): number {
    const size = box.getSize(new Vector3());
    const crown = Math.max(size.x, size.z) / 2;
    this.#reach = Math.max(size.y, crown, 2);
    this.ground.fit(this.#reach, foot, crown);
    this.sun.fit(box);
    this.ground.setShadow(this.sun, this.#softness);
    const reach = Math.max(size.y, crown * 2, 2);
    this.camera.near = 0.004 * reach;
    this.camera.far = 40 * reach;
    this.camera.updateProjectionMatrix();
    return reach;
  }

  /** Where the camera has to stand to show the whole of a box in metres, y up, in a picture of this size. */
  whole(box: Box3): Framing {
    return frameTree(box, FOV, this.width / this.height, AZIMUTH);
  }

  /** Lets a wind run over the meadow from the next rendering on, as it is at `time` seconds; none does before. */
  blow(source: WindSource, time: number): void {
    this.field.take(source, time);
    this.field.dress(this.ground.material);
    this.field.dress(this.meadow.material);
  }

  /** Draws the whole picture. `shadows`: what casts them has moved since the last time. */
  render(shadows = true): void {
    const { camera, target, renderer } = this;
    const spherical = this.#spherical.setFromVector3(camera.position.sub(target));
    spherical.phi = Math.min(spherical.phi, this.lowest(spherical.radius));
    camera.position.setFromSpherical(spherical.makeSafe()).add(target);
    camera.lookAt(target);
    this.see();
    renderer.shadowMap.needsUpdate ||= shadows;
    renderer.render(this.scene, camera);
  }

  /**
   * The lowest polar angle of a camera that looks at the target from so far: never below the meadow, and from afar well above it, or its far
   * end would be a line.
   */
  protected lowest(distance: number): number {
    const eye = LOWEST + RISE * Math.max(0, distance - 3 * this.#reach);
    const drop = (this.target.y - eye) / Math.max(1e-3, distance);
    return Math.PI / 2 + Math.asin(Math.min(1, Math.max(-1, drop)));
  }

  /** Ground and grass as the camera sees them. */
  protected see(): void {
    const { camera } = this;
    this.ground.see(Math.hypot(camera.position.x, camera.position.z));
    this.meadow.see(camera);
  }

  dispose(): void {
    this.sky.dispose();
    this.ground.dispose();
    this.meadow.dispose();
    this.field.dispose();
    this.sun.dispose();
    this.renderer.dispose();
  }

  /** The camera as wide as the picture. */
  protected shape(): void {
    this.camera.aspect = this.width / this.height;
    this.camera.updateProjectionMatrix();
  }
}
