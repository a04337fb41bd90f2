/** The part of a worker, or of a channel's end, that messages need. */
export interface Port {
  postMessage(message: unknown, transfer?: Transferable[]): void;
  addEventListener(type: 'message', listener: (event: MessageEvent) => void): void;
}

/** A service as who asks it has it: every answer is a promise. Its last argument may be a function, which is called with what the service says meanwhile. */
export type Remote<Service> = {
  readonly [Name in keyof Service]: Service[Name] extends (...args: infer Args) => infer Answer
    ? (...args: Args) => Promise<Awaited<Answer>>
    : never;
};

interface Asked {
  readonly id: number;
  readonly name: string;
  readonly args: readonly unknown[];
  /** Who asks hears what is said meanwhile. */
  readonly hears: boolean;
}

/** One of `said`, which others follow, `answer` and `error`. */
interface Told {
  readonly id: number;
  readonly said?: unknown;
  readonly answer?: unknown;
  readonly error?: unknown;
}

/** What goes over with an answer instead of being copied. */
const handedOver = new WeakMap<object, Transferable[]>();

/** Says of an answer which buffers of it are handed over. */
export function handOver<Answer extends object>(answer: Answer, buffers: Transferable[]): Answer {
  handedOver.set(answer, buffers);
  return answer;
}

/** Errors keep their name: an error of a class of its own would arrive as a plain one. */
const plainError = (error: unknown): unknown =>
  error instanceof Error
    ? { name: error.name, message: error.message, stack: error.stack }
    : { message: String(error) };

/** Answers at a port, in a worker its own, what is asked of a service. */
export function offer(service: object, port: Port = globalThis as unknown as Port): void {
  port.addEventListener('message', async ({ data }) => {
    const { id, name, args, hears } = data as Asked;
    const say = (said: unknown): void => port.postMessage({ id, said } satisfies Told);
    try {
      const method = (service as Record<string, (...args: unknown[]) => unknown>)[name]!;
      const answer = await method.call(service, ...args, ...(hears ? [say] : []));
      port.postMessage({ id, answer } satisfies Told, handedOver.get(answer as object) ?? []);
    } catch (error) {
      port.postMessage({ id, error: plainError(error) } satisfies Told);
    }
  });
}

/** The service at the other end of a port. A promise rejects with the service's own error, and stays open where the other end dies. */
export function remote<Service>(port: Port): Remote<Service> {
  const open = new Map<number, (told: Told) => void>();
  let ids = 0;
  port.addEventListener('message', ({ data }) => open.get((data as Told).id)?.(data as Told));
  const ask = (name: string, given: readonly unknown[]): Promise<unknown> =>
    new Promise((keep, breakOff) => {
      const id = ++ids;
      const last = given.at(-1);
      const hear = typeof last === 'function' ? last : null;
      open.set(id, (told) => {
        if ('said' in told) return hear?.(told.said);
        open.delete(id);
        if ('error' in told) breakOff(Object.assign(new Error(), told.error));
        else keep(told.answer);
      });
      const args = given.filter((arg) => typeof arg !== 'function');
      try {
        port.postMessage({ id, name, args, hears: hear !== null } satisfies Asked);
      } catch (error) {
        open.delete(id); // it cannot be sent, and so is never answered
        breakOff(error);
      }
    });
  return new Proxy({} as Remote<Service>, {
    // With a `then` it would pass for a promise: whoever awaits it would ask the other end for that, and wait for ever.
    get: (_, name) =>
      typeof name === 'symbol' || name === 'then' ? undefined : (...args: unknown[]) => ask(name, args),
  });
}
