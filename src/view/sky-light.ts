import {
  CircleGeometry,
  Mesh,
  MeshBasicMaterial,
  PMREMGenerator,
  Scene,
  type WebGLRenderer,
  type WebGLRenderTarget,
} from 'three';
import type { Sky } from './sky.ts';
import type { StageLook } from './stage-look.ts';

/** The sky, and the meadow under it, as an environment map: light from every direction, and what smooth surfaces mirror. */
export class SkyLight {
  readonly #generator: PMREMGenerator;
  readonly #target: Scene;
  readonly #sky: Sky;
  /** A disc of the ground's light below the horizon. */
  readonly #ground = new Mesh(new CircleGeometry(1, 24), new MeshBasicMaterial());
  readonly #renderer: WebGLRenderer;
  #map: WebGLRenderTarget | null = null;
  #look: StageLook | null = null;
  readonly #restored = () => {
    if (this.#look) this.refresh(this.#look);
  };

  /** Lights `target` by `sky`. */
  constructor(renderer: WebGLRenderer, target: Scene, sky: Sky) {
    this.#renderer = renderer;
    this.#generator = new PMREMGenerator(renderer);
    this.#target = target;
    this.#sky = sky;
    this.#ground.rotation.x = -Math.PI / 2;
    this.#ground.position.y = -0.05;
    // A lost context takes the map with it, and it cannot be read back: it is made again.
    renderer.domElement.addEventListener('webglcontextrestored', this.#restored);
  }

  /** Makes the map anew: the colours of the sky have changed. */
  refresh(look: StageLook): void {
    this.#look = look;
    const scene = new Scene();
    const parent = this.#sky.parent;
    this.#ground.material.color.setRGB(...look.groundLight).multiplyScalar(0.5);
    scene.add(this.#sky, this.#ground);
    this.#map?.dispose();
    this.#map = this.#generator.fromScene(scene, 0, 0.01, 10);
    parent?.add(this.#sky);
    this.#target.environment = this.#map.texture;
    this.#target.environmentIntensity = look.skyIntensity * 0.5;
  }

  dispose(): void {
    this.#renderer.domElement.removeEventListener('webglcontextrestored', this.#restored);
    this.#map?.dispose();
    this.#generator.dispose();
    this.#ground.geometry.dispose();
    this.#ground.material.dispose();
    this.#target.environment = null;
  }
}
