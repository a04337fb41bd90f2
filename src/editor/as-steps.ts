import type { History } from './history.ts';

/** The actions, each of them one step of the history however many changes it makes. */
export function asSteps<T extends object>(history: History, actions: T): T {
  const step =
    (act: unknown) =>
    (...given: unknown[]): unknown =>
      history.together(() => Reflect.apply(act as (...given: unknown[]) => unknown, undefined, given));
  const entries = Object.entries(actions).map(([name, act]) => [name, typeof act === 'function' ? step(act) : act]);
  return Object.fromEntries(entries) as T;
}
