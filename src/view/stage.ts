import {
  ACESFilmicToneMapping,
  Box3,
  HemisphereLight,
  PCFShadowMap,
  PerspectiveCamera,
  Scene,
  SRGBColorSpace,
  Vector3,
  WebGLRenderer,
} from 'three';
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';
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

/** Pixels of the picture that something else covers: the tree is framed in what is left. */
export interface Insets {
  readonly top: number;
  readonly right: number;
  readonly bottom: number;
  readonly left: number;
}

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

/** How a photograph differs from what stage and camera give. */
export interface Shot {
  /** The light as it is exposed. */
  readonly look: (look: StageLook) => StageLook;
  /** Puts another lens on the camera for one drawing; what it returns takes it off. */
  readonly aim: (stage: Stage) => () => void;
}

/** A part of the picture that is drawn by itself: its left edge and width in CSS pixels, and how far the view's middle is moved right. */
export interface StagePane {
  readonly left: number;
  readonly width: number;
  readonly shift: number;
  /** Called before it is drawn: shows what belongs there. */
  readonly before: () => void;
}

const NO_INSETS: Insets = { top: 0, right: 0, bottom: 0, left: 0 };

/** Vertical field of view in degrees, the feel of a 50 mm lens. */
export const FOV = 30;

/** To the side of the sun, so that crowns have a lit and a shaded side. */
export const AZIMUTH = CAMERA_AZIMUTH;

/** Part of the grass that grows, where nobody says. */
const GRASS = 0.36;

/** How far the camera goes away, in reaches of the tree. */
const FARTHEST = 9;

/** Least height of the eye above the meadow in metres, and what it gains with the distance beyond that of a whole tree. */
const LOWEST = 0.15;
const RISE = 0.08;

/** A meadow under the sky for one tree: renderer, camera, sun, ground, orbit. */
export class Stage {
  readonly renderer: WebGLRenderer;
  readonly scene = new Scene();
  readonly camera = new PerspectiveCamera(FOV, 1, 0.05, 2000);
  readonly controls: OrbitControls;
  readonly sun: Sun;
  readonly hemisphere = new HemisphereLight();
  readonly sky = new Sky();
  /** The wind over the meadow: `blow` fills it. */
  readonly field = new ForceField();
  readonly ground = new Ground(this.field, this.sky.uniforms);
  readonly meadow = new Meadow(this.ground, this.field, this.sky.uniforms);
  readonly #box = new Box3(new Vector3(-2, 0, -2), new Vector3(2, 6, 2));
  #reach = 6;
  #insets = NO_INSETS;
  #width = 1;
  #height = 1;
  #settling = 0;
  #dark = false;
  #place: { readonly stage: StageId; readonly hour: number | null } = { stage: 'meadow', hour: null };
  #softness = 1;
  #grass = GRASS;
  #grows = true;
  #shot: Shot | null = null;

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
    this.controls = new OrbitControls(this.camera, canvas);
    this.controls.enableDamping = true;
    this.controls.dampingFactor = 0.08;
    this.controls.zoomToCursor = true;
    this.controls.screenSpacePanning = true;
    this.controls.addEventListener('change', () => {
      this.#settling = 2;
    });
    this.setDark(false);
    this.frame(this.#box);
  }

  /** Sizes the picture: CSS pixels, and device pixels to each. */
  resize(width: number, height: number, pixelRatio = 1): void {
    this.#width = Math.max(1, Math.round(width));
    this.#height = Math.max(1, Math.round(height));
    this.renderer.setPixelRatio(Math.min(2, Math.max(0.25, pixelRatio)));
    this.renderer.setSize(this.#width, this.#height, false);
    this.#applyInsets();
  }

  /** Keeps the middle of the view clear of what covers the picture's edges. */
  setInsets(insets: Insets): void {
    this.#insets = insets;
    this.#applyInsets();
  }

  setDark(dark: boolean): void {
    this.#dark = dark;
    this.#relight();
  }

  get place(): { readonly stage: StageId; readonly hour: number | null } {
    return this.#place;
  }

  /** Where the tree stands; `hour` of the day by the sun, 0..24, null: the stage's own. */
  setScene(stage: StageId, hour: number | null): void {
    this.#place = { stage, hour };
    this.#relight();
  }

  /** null: neither exposure nor lens of its own. */
  set shot(shot: Shot | null) {
    this.#shot = shot;
    this.#relight();
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

  #relight(): void {
    let look = lookAt(this.#place.stage, this.#place.hour, this.#dark);
    if (this.#shot) look = this.#shot.look(look);
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

  /** Fits ground, sun and shadow to what stands on the stage: a box in metres, y up. The camera stays. */
  setSubject(box: Box3, foot = 0.02 * (box.max.y - box.min.y)): void {
    this.#box.copy(box);
    const size = box.getSize(new Vector3());
    const crown = Math.max(size.x, size.z) / 2;
    this.#reach = Math.max(size.y, crown, 2);
    this.ground.fit(this.#reach, foot, crown);
    this.sun.fit(box);
    this.ground.setShadow(this.sun, this.#softness);
    const reach = Math.max(size.y, crown * 2, 2);
    this.controls.minDistance = 0.02 * reach;
    this.controls.maxDistance = FARTHEST * reach;
    this.camera.near = 0.004 * reach;
    this.camera.far = 40 * reach;
    this.camera.updateProjectionMatrix();
  }

  /** Shows the whole of a box in metres, y up, in a window of any shape, or in each of `columns` equal parts of it. */
  frame(box: Box3, { azimuth = AZIMUTH, columns = 1 }: { azimuth?: number; columns?: number } = {}): Framing {
    this.setSubject(box);
    const { top, right, bottom, left } = this.#insets;
    const clear = Math.max(1, this.#height - top - bottom);
    // The insets shift the middle of the view; what is left of the window has a narrower field of view.
    const part = clear / this.#height;
    const fov = (2 * Math.atan(Math.tan((FOV * Math.PI) / 360) * part) * 180) / Math.PI;
    const wide = Math.max(1, (this.#width - left - right) / columns);
    const framing = frameTree(box, fov, wide / clear, azimuth);
    // A low window, or one of two columns, has the whole tree from very far.
    const distance = framing.position.distanceTo(framing.target);
    this.controls.maxDistance = Math.max(this.controls.maxDistance, 1.1 * distance);
    this.camera.position.copy(framing.position);
    this.controls.target.copy(framing.target);
    this.controls.update();
    return framing;
  }

  /** Lets a wind run over the meadow from the next rendering on, as it is at `time` seconds; none does before. */
  blow(source: WindSource, time: number): void {
    this.field.take(source, time);
    this.field.dress(this.ground.material);
    this.field.dress(this.meadow.material);
  }

  /** The camera still moves by itself: draw again. */
  get moving(): boolean {
    return this.#settling > 0;
  }

  /** Draws, the whole picture or its panes. `shadows`: what casts them has moved since the last time. */
  render(shadows = true, panes: readonly StagePane[] = []): void {
    const { camera, controls, renderer } = this;
    if (this.#settling > 0) this.#settling--;
    // Never below the meadow, and from afar well above it, or its far end would be a line: the lowest polar angle depends on
    // the distance.
    const distance = Math.max(1e-3, camera.position.distanceTo(controls.target));
    const lowest = LOWEST + RISE * Math.max(0, distance - 3 * this.#reach);
    const drop = (controls.target.y - lowest) / distance;
    controls.maxPolarAngle = Math.PI / 2 + Math.asin(Math.min(1, Math.max(-1, drop)));
    controls.update();
    const back = this.#shot?.aim(this);
    this.ground.see(Math.hypot(camera.position.x, camera.position.z));
    this.meadow.see(camera);
    if (panes.length < 2) {
      panes[0]?.before();
      renderer.shadowMap.needsUpdate ||= shadows;
      renderer.render(this.scene, camera);
    } else this.#renderPanes(panes);
    back?.();
  }

  #renderPanes(panes: readonly StagePane[]): void {
    const { renderer, camera } = this;
    const { info } = renderer;
    info.reset();
    info.autoReset = false; // the figures are those of the whole picture
    renderer.setScissorTest(true);
    for (const { left, width, shift, before } of panes) {
      if (width <= 0) continue;
      before();
      this.#applyInsets(shift);
      renderer.setScissor(left, 0, width, this.#height);
      // The same map serves one pane after the other: what casts the shadows is not the same in both.
      renderer.shadowMap.needsUpdate = true;
      renderer.render(this.scene, camera);
    }
    this.#divide(panes[1]?.left ?? 0);
    renderer.setScissorTest(false);
    info.autoReset = true;
    this.#applyInsets();
  }

  /** A line between two panes: dark within light, so that it shows on sky and leaves alike. */
  #divide(x: number): void {
    const { renderer } = this;
    if (x <= 0 || x >= this.#width) return;
    for (const [colour, half] of [
      ['#fbfaf6', 1.5],
      ['#1d2021', 0.5],
    ] as const) {
      renderer.setScissor(x - half, 0, 2 * half, this.#height);
      renderer.setClearColor(colour, 1);
      renderer.clear(true, false, false);
    }
  }

  dispose(): void {
    this.controls.dispose();
    this.sky.dispose();
    this.ground.dispose();
    this.meadow.dispose();
    this.field.dispose();
    this.sun.dispose();
    this.renderer.dispose();
  }

  /** `shift`: how far right of the middle of what is clear the middle of the view lies, CSS pixels. */
  #applyInsets(shift = 0): void {
    const { top, right, bottom, left } = this.#insets;
    const { camera } = this;
    camera.aspect = this.#width / this.#height;
    if (top || right || bottom || left || shift) {
      camera.setViewOffset(
        this.#width,
        this.#height,
        (right - left) / 2 - shift,
        (bottom - top) / 2,
        this.#width,
        this.#height,
      );
    } else {
      camera.clearViewOffset();
    }
    camera.updateProjectionMatrix();
  }
}
