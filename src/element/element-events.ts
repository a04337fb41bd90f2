import type { CameraPose } from '../core/link/document.ts';

/** What kind of thing went wrong. */
export type ErrorType = 'fetch' | 'species' | 'wind' | 'grow' | 'capability' | 'contextlost' | 'attribute';

/** What happened at the element, by the name of the event. */
export interface WindTreeEventDetails {
  load: { readonly species: string; readonly seed: number; readonly triangles: number };
  error: { readonly type: ErrorType; readonly message: string };
  progress: { readonly phase: 'code' | 'species' | 'grow' | 'draw'; readonly progress: number };
  timeupdate: { readonly time: number };
  'quality-change': { readonly level: 'low' | 'medium' | 'high'; readonly scale: number };
  'camera-change': CameraPose & { readonly source: 'user' | 'script' };
  visibility: { readonly visible: boolean };
  statechange: { readonly state: 'idle' | 'loading' | 'ready' | 'error'; readonly paused: boolean };
}

/** Why a tree or wind did not come, as an event tells it. */
export function errorTypeOf(error: unknown, invalid: 'species' | 'wind'): ErrorType {
  const { name, type } = (error ?? {}) as { name?: unknown; type?: unknown };
  if (name === 'UnknownId') return invalid;
  return name === 'LoadError' && type === 'invalid' ? invalid : 'fetch';
}
