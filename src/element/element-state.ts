import type { CameraPose } from '../core/link/document.ts';
import { CAMERA_NUMBERS } from '../core/link/numbers.ts';
import { ATTRIBUTES, type AttributeName } from './attributes.ts';

/** What `getState` gives and `setState` takes: plain JSON. Properties as the element has them; physical ones as in attributes. */
export interface ElementState {
  readonly [property: string]: unknown;
  /** Seconds. */
  readonly time?: number;
  readonly paused?: boolean;
  /** null: as `cameraOrbit` says. */
  readonly camera?: CameraPose | null;
}

/** Names of attributes by property; `time` is the clock's. */
export const STATE_ATTRIBUTES: readonly AttributeName[] = (Object.keys(ATTRIBUTES) as AttributeName[]).filter(
  (name) => name !== 'time',
);

/** A camera of a state from outside, or undefined where it is none. */
export function cameraOf(value: unknown): CameraPose | undefined {
  if (typeof value !== 'object' || value === null) return undefined;
  const { azimuth, elevation, distance, target } = value as Record<string, unknown>;
  if (!Array.isArray(target) || target.length !== 3) return undefined;
  const numbers = [azimuth, elevation, distance, ...target];
  const fits = numbers.every((number, i) => {
    const rule = CAMERA_NUMBERS[i]!;
    return typeof number === 'number' && number >= rule.min && number <= rule.max;
  });
  if (!fits) return undefined;
  const [a, e, d, x, y, z] = numbers as [number, number, number, number, number, number];
  return { azimuth: a, elevation: e, distance: d, target: [x, y, z] };
}

/** The properties of an element that a state holds beside those of ATTRIBUTES. */
interface Stateful {
  alt: string | null;
  cameraControls: boolean;
  paused: boolean;
  time: number;
  play(): void;
  pause(): void;
}

/** All that is seen of an element as plain JSON; `camera`: where the reader or a script has put it. */
export function stateOf(element: Stateful, camera: CameraPose | null): ElementState {
  const properties = STATE_ATTRIBUTES.map((name) => ATTRIBUTES[name].property);
  const { alt, cameraControls, paused, time } = element;
  const own = element as unknown as Record<string, unknown>;
  return { ...Object.fromEntries(properties.map((key) => [key, own[key]])), alt, cameraControls, paused, time, camera };
}

/** Gives an element what a state has, the camera apart; what may not be the element itself turns down. */
export function applyState(element: Stateful, state: ElementState): void {
  for (const name of STATE_ATTRIBUTES) {
    const { property } = ATTRIBUTES[name];
    if (property in state) (element as unknown as Record<string, unknown>)[property] = state[property];
  }
  if (typeof state.alt === 'string' || state.alt === null) element.alt = state.alt;
  if (typeof state.cameraControls === 'boolean') element.cameraControls = state.cameraControls;
  if (typeof state.time === 'number') element.time = state.time;
  if (state.paused === true) element.pause();
  else if (state.paused === false) element.play();
}
