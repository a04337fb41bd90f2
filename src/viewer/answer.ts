import type { Answer, Call } from './protocol.ts';
import { PROTOCOL } from './protocol.ts';

/** What of `<wind-tree>` the messages reach. */
export interface Tree {
  play(): unknown;
  pause(): unknown;
  seek(seconds: number): unknown;
  step(steps?: number): unknown;
  getState(): unknown;
  setState(state: never): unknown;
  toBlob(options?: never): Promise<Blob>;
  exportGLB(options?: never): Promise<unknown>;
  setAttribute(name: string, value: string): void;
  removeAttribute(name: string): void;
}

/** Attributes that a message may set: what the element reads, and none that a page could be harmed by. */
export type Settable = ReadonlySet<string>;

const finite = (value: unknown, what: string): number => {
  if (typeof value === 'number' && Number.isFinite(value)) return value;
  throw new TypeError(`${what} has to be a number.`);
};

const record = (value: unknown, what: string): Readonly<Record<string, unknown>> => {
  if (typeof value === 'object' && value !== null && !Array.isArray(value)) return value as Record<string, unknown>;
  throw new TypeError(`${what} has to be an object.`);
};

/** `{season: 'autumn', paused: true, time: null}`: null and false take an attribute away, true is one without a value. */
function set(tree: Tree, given: unknown, settable: Settable): void {
  const entries = Object.entries(record(given, 'What is set'));
  const unknown = entries.filter(([name]) => !settable.has(name)).map(([name]) => name);
  if (unknown.length > 0)
    throw new TypeError(`There is no attribute ${unknown.join(', ')}; there are ${[...settable].join(', ')}.`);
  for (const [name, value] of entries) {
    if (value === null || value === false) tree.removeAttribute(name);
    else if (value === true) tree.setAttribute(name, '');
    else if (typeof value === 'string' || typeof value === 'number') tree.setAttribute(name, String(value));
    else throw new TypeError(`${name} has to be a text, a number, true, false or null.`);
  }
}

/** Does what a call asks; `host`: who asks may see the state of the tree, and nothing else of the page. */
export async function answer(tree: Tree, { id, call, args }: Call, settable: Settable): Promise<Answer> {
  const work = async (): Promise<unknown> => {
    switch (call) {
      case 'play':
        await tree.play();
        return null;
      case 'pause':
        await tree.pause();
        return null;
      case 'seek':
        await tree.seek(finite(args[0], 'The time'));
        return null;
      case 'step':
        await tree.step(args[0] === undefined ? 1 : finite(args[0], 'The number of steps'));
        return null;
      case 'set':
        set(tree, args[0], settable);
        return null;
      case 'getState':
        return tree.getState();
      case 'setState':
        await tree.setState(record(args[0], 'A state') as never);
        return null;
      case 'toBlob':
        return tree.toBlob(...(args.slice(0, 1) as never[]));
      case 'exportGLB':
        return tree.exportGLB(...(args.slice(0, 1) as never[]));
    }
  };
  try {
    return { windgrove: PROTOCOL, id, result: await work() };
  } catch (error) {
    return { windgrove: PROTOCOL, id, error: error instanceof Error ? error.message : String(error) };
  }
}
