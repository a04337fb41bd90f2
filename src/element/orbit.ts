import type { CameraPose } from '../core/link/document.ts';
import type { CameraOrbit } from './attribute-rules.ts';

/** Degrees above and below the horizon that the eye may reach; the ground stops it before the lower one. */
const HIGHEST = 88;
const LOWEST = -20;

/** How near and how far it may go, as parts of the distance that shows the whole tree. */
const NEAREST = 0.08;
const FARTHEST = 2.5;

/** Milliseconds of a frame on most screens, and the part of the way that is left after one. */
const FRAME = 1000 / 60;
const LEFT = 0.84;

/** What is no longer seen to move: degrees, and parts of the distance. */
const STILL = 0.02;

const clamp = (value: number, min: number, max: number): number => Math.min(max, Math.max(min, value));

/** A camera about a tree: where it is to be, and where it is on its way there. */
export class Orbit {
  /** Without a jump from one turn to the next. */
  #goal: CameraPose = { azimuth: 0, elevation: 0, distance: 10, target: [0, 3, 0] };
  #shown = this.#goal;
  /** The whole tree. */
  #whole = this.#goal;
  #wish: CameraOrbit | null = null;
  #free = false;
  /** There was a tree before. */
  #framed = false;

  /** As it is drawn. */
  get pose(): CameraPose {
    return { ...this.#shown, azimuth: ((this.#shown.azimuth % 360) + 360) % 360 };
  }

  /** Where it is going; null while it stands where the attribute, or the tree's frame, has it. */
  get own(): CameraPose | null {
    return this.#free ? { ...this.#goal, azimuth: ((this.#goal.azimuth % 360) + 360) % 360 } : null;
  }

  get moving(): boolean {
    return this.#shown !== this.#goal;
  }

  /** The view of the whole tree is another: of another size, or another tree. What a person has chosen stays. */
  frame(whole: CameraPose): void {
    const first = this.#whole.distance;
    this.#whole = whole;
    const framed = this.#framed;
    this.#framed = true;
    if (this.#free) {
      if (!framed) return;
      // As much of the tree as before.
      const distance = (this.#goal.distance * whole.distance) / first;
      this.#jump({ ...this.#goal, distance, target: whole.target });
    } else this.#jump(this.#wished());
  }

  /** Stands where the attribute says, null: where all is seen; `glide`: on its way there it is seen. */
  wish(orbit: CameraOrbit | null, glide: boolean): void {
    this.#wish = orbit;
    this.#free = false;
    const goal = this.#wished();
    // The short way around.
    const turns = Math.round((this.#shown.azimuth - goal.azimuth) / 360);
    if (glide) this.#goal = { ...goal, azimuth: goal.azimuth + 360 * turns };
    else this.#jump(goal);
  }

  /** Stands at a pose. */
  place(pose: CameraPose): void {
    this.#free = true;
    this.#jump(pose);
  }

  /** Turns by degrees: to the right, and up. */
  turn(azimuth: number, elevation: number, glide: boolean): void {
    const goal = this.#goal;
    this.#take({ ...goal, azimuth: goal.azimuth + azimuth, elevation: goal.elevation + elevation }, glide);
  }

  /** Goes nearer (below 1) or farther away by a factor. */
  zoom(factor: number, glide: boolean): void {
    this.#take({ ...this.#goal, distance: this.#goal.distance * factor }, glide);
  }

  /** Goes on by `passed` milliseconds; tells whether it moved. */
  step(passed: number): boolean {
    if (!this.moving) return false;
    const left = LEFT ** clamp(passed / FRAME, 0, 30);
    const [from, to] = [this.#shown, this.#goal];
    const mix = (a: number, b: number): number => b + (a - b) * left;
    const next: CameraPose = {
      azimuth: mix(from.azimuth, to.azimuth),
      elevation: mix(from.elevation, to.elevation),
      distance: mix(from.distance, to.distance),
      target: [0, 1, 2].map((i) => mix(from.target[i]!, to.target[i]!)) as [number, number, number],
    };
    const away = Math.max(
      Math.abs(next.azimuth - to.azimuth),
      Math.abs(next.elevation - to.elevation),
      (100 * Math.abs(next.distance - to.distance)) / to.distance,
    );
    this.#shown = away < STILL ? to : next;
    return true;
  }

  /** The ground has stopped the eye at this elevation. */
  stoppedAt(elevation: number): void {
    if (elevation <= this.#shown.elevation + 1e-3) return;
    const arrived = !this.moving;
    this.#shown = { ...this.#shown, elevation };
    this.#goal = arrived ? this.#shown : { ...this.#goal, elevation: Math.max(elevation, this.#goal.elevation) };
  }

  #wished(): CameraPose {
    const { azimuth, polar, distance } = this.#wish ?? { azimuth: null, polar: null, distance: null };
    const whole = this.#whole;
    return {
      azimuth: azimuth ?? whole.azimuth,
      elevation: polar === null ? whole.elevation : 90 - polar,
      distance: distance ?? whole.distance,
      target: whole.target,
    };
  }

  #take(pose: CameraPose, glide: boolean): void {
    this.#free = true;
    const { distance } = this.#whole;
    const goal: CameraPose = {
      ...pose,
      elevation: clamp(pose.elevation, LOWEST, HIGHEST),
      distance: clamp(pose.distance, NEAREST * distance, FARTHEST * distance),
    };
    if (glide) this.#goal = goal;
    else this.#jump(goal);
  }

  #jump(pose: CameraPose): void {
    this.#goal = pose;
    this.#shown = pose;
  }
}
