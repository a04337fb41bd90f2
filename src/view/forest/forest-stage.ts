import { FogExp2, type PerspectiveCamera, type Scene, Vector3, type WebGLRenderer } from 'three';
import { type HeightField, heightAt, levelField } from '../../core/forest/height-field.ts';
import type { StageId } from '../../core/link/document.ts';
import type { Season } from '../../core/species/season.ts';
import type { WindSource } from '../../gpu/wind-source.ts';
import type { Meadow } from '../meadow.ts';
import { Stage, type StageOptions } from '../stage.ts';
import { lookAt, type StageLook } from '../stage-look.ts';
import { STAGE_TABLE } from '../stage-table.ts';
import { FOREST_STEPS, type ForestStep } from './budget.ts';
import { forestMeadow } from './forest-meadow.ts';
import { GroundShade, type ShadeTree } from './ground-shade.ts';
import { AIRY, hazeColour, hazeDensity } from './haze.ts';
import { groundInSeason } from './season-ground.ts';
import { Terrain } from './terrain.ts';
import { followViewer } from './viewer-sun.ts';

/** Water and dust in the studio's air: none is seen. */
const mistOf = (stage: StageId): number => (stage === 'studio' ? 0.3 : STAGE_TABLE[stage].mist);

const ahead = new Vector3();

/** Sky, sun, haze and hills for a forest: a stage whose ground is a terrain and whose shadows follow the viewer. The camera is the caller's. */
export class ForestStage {
  readonly stage: Stage;
  readonly terrain: Terrain;
  readonly meadow: Meadow;
  readonly #shade = new GroundShade();
  readonly #fog = new FogExp2('#ffffff', 0.001);
  #field: HeightField = levelField(200);
  #trees: readonly ShadeTree[] = [];
  #shadeStale = true;
  #place: { readonly stage: StageId; readonly hour: number | null } = { stage: 'meadow', hour: null };
  #season: Season = 'summer';
  #dark = false;
  #look: StageLook = lookAt('meadow', null, false);
  #step: ForestStep = FOREST_STEPS[0] as ForestStep;
  #frame = 0;
  #size: [number, number, number] = [1, 1, 1];

  /** Draws on `canvas`. Throws where the browser gives no WebGL2 context. */
  constructor(canvas: HTMLCanvasElement, options: StageOptions = {}) {
    this.stage = new Stage(canvas, options);
    const { ground, meadow, field, sky, scene, controls, sun } = this.stage;
    controls.enabled = false;
    ground.visible = false;
    meadow.visible = false;
    this.terrain = new Terrain(ground, field, sky.uniforms);
    this.meadow = forestMeadow(this.terrain, field, sky.uniforms);
    this.terrain.setShade(this.#shade.texture);
    scene.add(this.terrain, this.meadow);
    scene.fog = this.#fog;
    sun.shadow.autoUpdate = true;
    // Sky and ground take their colours from the same look as the haze.
    this.stage.shot = { look: (look) => groundInSeason(look, this.#season), aim: () => () => {} };
    this.setField(this.#field);
  }

  get renderer(): WebGLRenderer {
    return this.stage.renderer;
  }

  get scene(): Scene {
    return this.stage.scene;
  }

  get camera(): PerspectiveCamera {
    return this.stage.camera;
  }

  /** Colours and light as they are. */
  get look(): StageLook {
    return this.#look;
  }

  /** Sizes the picture: CSS pixels, and device pixels to each; the budget's step may take some of these back. */
  resize(width: number, height: number, pixelRatio = 1): void {
    this.#size = [width, height, pixelRatio];
    this.stage.resize(width, height, pixelRatio * this.#step.resolution);
  }

  /** Takes the ground that the forest stands on. */
  setField(field: HeightField): void {
    this.#field = field;
    this.terrain.setField(field);
    const { camera } = this;
    camera.near = 0.25;
    camera.far = 6 * field.size;
    camera.updateProjectionMatrix();
    this.#relight();
  }

  /** The trees that shade the ground where no shadow map reaches, and the colour of what they drop, as the screen has it (0..1). */
  setTrees(trees: readonly ShadeTree[], litter?: readonly [number, number, number]): void {
    this.#trees = trees;
    this.#shadeStale = true;
    if (litter) this.terrain.setLitter(...litter);
  }

  /** `hour` of the day by the sun, 0..24, null: the stage's own; `season` of the ground. */
  setScene(stage: StageId, hour: number | null, season: Season = 'summer'): void {
    this.#place = { stage, hour };
    this.#season = season;
    this.#relight();
  }

  setDark(dark: boolean): void {
    this.#dark = dark;
    this.#relight();
  }

  /** Draws as a step of the budget allows. */
  setStep(step: ForestStep): void {
    if (step === this.#step) return;
    const sharper = step.resolution !== this.#step.resolution;
    this.#step = step;
    this.meadow.growing = this.#look.blades > 0 ? step.grass : 0;
    const { sun } = this.stage;
    if (sun.castShadow && sun.shadow.mapSize.x !== step.shadowTexels) {
      sun.shadow.mapSize.setScalar(step.shadowTexels);
      sun.shadow.map?.dispose();
      sun.shadow.map = null;
    }
    if (sharper) this.resize(...this.#size);
  }

  /** Lets a wind of a mean force in metres run over the ground from the next rendering on, as it is at `time` seconds. */
  blow(source: WindSource, time: number, meanForce: number): void {
    this.stage.blow(source, time);
    this.terrain.meanForce = meanForce;
    this.stage.field.dress(this.terrain.material);
    this.stage.field.dress(this.meadow.material);
  }

  /** Height of the ground under a place of the world (y up), metres. */
  groundAt(x: number, z: number): number {
    return heightAt(this.#field, x, -z);
  }

  /** Draws what the camera sees. `moved`: trees or viewer did since the last time, so shadows are drawn anew when their turn has come. */
  render(moved = true): void {
    const { camera, renderer, scene, stage } = this;
    camera.updateMatrixWorld();
    if (this.#shadeStale) {
      this.#shadeStale = false;
      const [x, y, z] = this.#look.direction;
      this.#shade.draw(renderer, this.#field, this.#trees, [x, -z, y]);
    }
    this.terrain.see(camera);
    const { x, y, z } = camera.position;
    this.meadow.see(camera, Math.max(0.3, y - this.groundAt(x, z)));
    this.meadow.visible = this.#step.grass > 0 && y - this.groundAt(x, z) < 40;
    hazeColour(this.#look, camera, this.#fog.color);
    this.#follow();
    if (moved) this.#frame++;
    renderer.shadowMap.needsUpdate ||= moved && this.#frame % this.#step.shadowPeriod === 0;
    stage.renderer.render(scene, camera);
  }

  dispose(): void {
    this.terrain.dispose();
    this.meadow.dispose();
    this.#shade.dispose();
    this.stage.dispose();
  }

  /** Lays the shadow map before the viewer; it stays where it is until shadows are drawn anew. */
  #follow(): void {
    const { camera, stage } = this;
    if (!stage.sun.castShadow) return;
    const reach = this.#step.shadowReach;
    camera.getWorldDirection(ahead);
    const level = Math.hypot(ahead.x, ahead.z) || 1;
    const x = camera.position.x + (ahead.x / level) * 0.62 * reach;
    const z = camera.position.z + (ahead.z / level) * 0.62 * reach;
    const relief = (this.terrain.maps?.high ?? 0) - (this.terrain.maps?.low ?? 0);
    followViewer(stage.sun, camera, reach, this.groundAt(x, z), Math.min(relief, 2 * reach));
  }

  #relight(): void {
    const { stage, hour } = this.#place;
    this.stage.setDark(this.#dark);
    this.stage.setScene(stage, hour);
    this.#look = groundInSeason(lookAt(stage, hour, this.#dark), this.#season);
    // Ground and sky meet in the same colour, and the trees' fog has it too.
    this.stage.sky.uniforms.skyField.value.w *= AIRY;
    this.terrain.setLook(this.#look);
    const density = hazeDensity(this.#field.size, mistOf(stage));
    this.#fog.density = density;
    this.terrain.haze = density;
    this.meadow.growing = this.#look.blades > 0 ? this.#step.grass : 0;
    this.#shadeStale = true;
  }
}
