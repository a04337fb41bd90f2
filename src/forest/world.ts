import { forestDensity } from '../core/forest/density.ts';
import type { ForestDocument } from '../core/forest/forest.ts';
import { forestWind, windSpeedOf } from '../core/forest/forest-wind.ts';
import { type HeightField, heightAt, levelField } from '../core/forest/height-field.ts';
import { scatter } from '../core/forest/scatter.ts';
import { forestField } from '../core/forest/terrain.ts';
import { Clock } from '../view/clock.ts';
import { Forest, type ForestStats } from '../view/forest/forest.ts';
import { ForestStage } from '../view/forest/forest-stage.ts';
import { Flight } from './flight.ts';
import type { Sources } from './sources.ts';
import type { ForestState } from './store.ts';
import { type Wish, wishOf } from './wish.ts';

/** Degrees that the height of the picture shows. */
const FOV = 42;

/** Seconds in which a new wind takes over. */
const FADE = 1.5;

/** Milliseconds for which nothing grows after a change that may be followed by others: sliders are dragged. */
const PATIENCE = 160;

/** Milliseconds of a frame from which a picture that stands still is drawn seldom while its trees grow, and the part of the time that it may then take. */
const LONG = 80;
const PART = 0.2;

/** The picture of the page: stage, forest, eye and clock, which follow the state. */
export class World {
  readonly stage: ForestStage;
  readonly forest = new Forest();
  readonly flight: Flight;
  readonly clock = new Clock();
  /** Trees that found a place; NaN before the first forest. */
  standing = Number.NaN;
  /** Metres a second of the wind as its file has it. */
  ownSpeed = 0;
  /** Told when a forest stands, with how many trees; and when something cannot be loaded. */
  onForest: (document: ForestDocument, standing: number) => void = () => {};
  onError: (error: unknown) => void = () => {};
  readonly #sources: Sources;
  #field: HeightField = levelField(500);
  #wish: Wish | null = null;
  #made: Wish | null = null;
  #timer = 0;
  #turn = 0;
  #blows = '';
  #progress = -1;
  #stale = 4;
  #last = Number.NaN;
  /** When the last picture was drawn, and the longest frame since. */
  #drawn = Number.NaN;
  #longest = 0;

  /** Draws on `canvas`. Throws where the browser gives no WebGL2 context. */
  constructor(canvas: HTMLCanvasElement, sources: Sources) {
    this.stage = new ForestStage(canvas, { antialias: devicePixelRatio < 1.5, preserveDrawingBuffer: false });
    this.stage.camera.fov = FOV;
    this.stage.scene.add(this.forest);
    this.forest.onError = (error) => this.onError(error);
    this.flight = new Flight(canvas);
    this.flight.fov = FOV;
    this.flight.groundAt = (x, y) => heightAt(this.#field, x, y);
    this.#sources = sources;
  }

  get stats(): ForestStats {
    return this.forest.stats();
  }

  /** A forest is being seeded, or the one that stands is still growing. */
  get busy(): boolean {
    return this.#made === null || this.#wish !== this.#made || !this.forest.settled;
  }

  /** A forest is asked for that does not stand yet. */
  get seeding(): boolean {
    return this.#wish !== this.#made;
  }

  get seeded(): boolean {
    return this.#made !== null && this.#wish === this.#made;
  }

  resize(width: number, height: number): void {
    this.stage.resize(width, height, Math.min(2, devicePixelRatio));
    this.#stale = 2;
  }

  /** Something lies over so many pixels at the foot of the picture: the eye looks to the middle of the rest. */
  cover(pixels: number): void {
    this.stage.stage.setInsets({ top: 0, right: 0, bottom: pixels, left: 0 });
    this.#stale = 2;
  }

  setDark(dark: boolean): void {
    this.stage.setDark(dark);
    this.#stale = 2;
  }

  /** Brings the picture to a state; what is grown anew comes a moment later. `jump`: the eye goes to the document's camera. */
  follow(state: ForestState, jump: boolean): void {
    const { document, heightMap, densityMap, playing } = state;
    if (playing !== this.clock.playing) {
      if (playing) this.clock.play();
      else this.clock.pause();
    }
    this.forest.budget = document.budget;
    this.stage.setScene(document.stage, document.hour, document.season);
    void this.#blow(document);
    this.#stale = 2;
    const wish = wishOf(document, heightMap, densityMap);
    if (this.#wish && wish.key === this.#wish.key && wish.ground === this.#wish.ground) {
      if (jump) this.flight.place(document.camera);
      return;
    }
    this.#wish = wish;
    clearTimeout(this.#timer);
    if (jump || !this.#made) void this.#grow(wish, document, state, true);
    else this.#timer = window.setTimeout(() => void this.#grow(wish, document, state, false), PATIENCE);
  }

  async #blow(document: ForestDocument): Promise<void> {
    const said = [document.wind, document.windSpeed, document.windTurn].join();
    if (said === this.#blows) return;
    this.#blows = said;
    try {
      const wind = await this.#sources.windOf(document.wind);
      if (said !== this.#blows) return;
      this.ownSpeed = windSpeedOf(wind);
      this.forest.setWind(forestWind(wind, document.windSpeed, document.windTurn), { fade: FADE });
      this.#stale = 2;
    } catch (error) {
      this.#blows = '';
      this.onError(error);
    }
  }

  async #grow(wish: Wish, document: ForestDocument, state: ForestState, jump: boolean): Promise<void> {
    const turn = ++this.#turn;
    try {
      const species = await this.#sources.speciesOf(document.mix.map((entry) => entry.species));
      if (turn !== this.#turn) return;
      if (wish.ground !== this.#made?.ground) {
        this.#field = forestField(document, state.heightMap);
        this.stage.setField(this.#field);
        this.flight.size = document.size;
      }
      if (jump) this.flight.place(document.camera);
      else this.flight.hold();
      const places = scatter(document, this.#field, forestDensity(document, state.densityMap));
      this.forest.setForest(document, species, this.#field, places);
      this.standing = places.count;
      this.#made = wish;
      this.#progress = -1;
      this.#stale = 2;
      this.onForest(document, places.count);
    } catch (error) {
      // Of what is no longer asked for nobody wants to hear; else what stands stays, and the same may be asked for again.
      if (turn !== this.#turn) return;
      this.#wish = this.#made;
      this.onError(error);
    }
  }

  /** Goes on with what grows and draws a frame, unless nothing has changed since the last; whether it did. `now` in milliseconds. */
  frame(now: number): boolean {
    const passed = Number.isNaN(this.#last) ? 0 : now - this.#last;
    // After a pause nobody is thrown far; slow frames are no pause.
    const seconds = Math.min(0.5, passed / 1000);
    this.#last = now;
    this.#longest = Math.max(this.#longest, passed);
    this.clock.tick(now);
    const moved = this.flight.update(seconds);
    const still = !this.clock.playing && !moved && this.#stale === 0;
    if (still && !this.busy) return false;
    if (this.#stale > 0) this.#stale--;
    const { stage, forest } = this;
    const { x, y, z, yaw, pitch } = this.flight.eye;
    const { camera } = stage;
    camera.position.set(x, z, -y);
    camera.rotation.set((pitch * Math.PI) / 180, ((yaw - 90) * Math.PI) / 180, 0, 'YXZ');
    camera.updateMatrixWorld();
    forest.update(stage.renderer, camera, this.clock.time, now);
    this.#shade();
    // A slow machine gives its time to the trees that are awaited, not to the same picture again; the last one is drawn in any case.
    if (still && this.#stale === 0 && this.#longest > LONG && now - this.#drawn < this.#longest / PART) {
      if (!this.busy) this.#stale = 2;
      return false;
    }
    this.#drawn = now;
    this.#longest = 0;
    stage.setStep(forest.step);
    stage.blow(forest.windSource(), this.clock.time, forest.meanForce);
    stage.render();
    return true;
  }

  /** Crowns shade the ground as their shapes become known, in few steps: each draws the map of the shade anew. */
  #shade(): void {
    const { progress } = this.forest.stats();
    if (progress === this.#progress || (progress < 1 && progress < this.#progress + 0.25)) return;
    this.#progress = progress;
    this.stage.setTrees(this.forest.crowns(), this.forest.litter);
    this.#stale = 2;
  }
}
