import { expect, it } from 'vitest';
import { offer, type Port, type Remote, remote } from '../../src/worker/remote.ts';

interface Adder {
  add(a: number, b: number, hear?: (said: string) => void): number;
  fail(): never;
}

/** A service at one end of a channel whose messages arrive at once, and all that was asked of it. */
function channel(): { service: Remote<Adder>; asked: unknown[] } {
  const asked: unknown[] = [];
  const listeners: Record<'here' | 'there', ((event: MessageEvent) => void)[]> = { here: [], there: [] };
  const end = (own: 'here' | 'there', other: 'here' | 'there'): Port => ({
    postMessage(message) {
      const data: unknown = structuredClone(message);
      if (other === 'there') asked.push(data);
      for (const listener of listeners[other]) listener({ data } as MessageEvent);
    },
    addEventListener: (_, listener) => listeners[own].push(listener),
  });
  const adder: Adder = {
    add(a, b, hear) {
      hear?.('adding');
      return a + b;
    },
    fail() {
      throw new RangeError('too much');
    },
  };
  offer(adder, end('there', 'here'));
  return { service: remote<Adder>(end('here', 'there')), asked };
}

it('answers, says meanwhile what it does, and rejects with the name of the error', async () => {
  const { service } = channel();
  const said: string[] = [];
  expect(await service.add(2, 3, (what) => said.push(what))).toBe(5);
  expect(said).toEqual(['adding']);
  await expect(service.fail()).rejects.toMatchObject({ name: 'RangeError', message: 'too much' });
});

it('is no promise: whoever awaits it, or hands it on as an answer, has it at once and asks the other end nothing', async () => {
  const { service, asked } = channel();
  expect((service as { then?: unknown }).then).toBeUndefined();
  expect(await (async () => service)()).toBe(service);
  expect(`${Object.prototype.toString.call(service)}`).toBe('[object Object]');
  expect(asked).toEqual([]);
});

it('rejects what cannot be sent', async () => {
  const { service, asked } = channel();
  const circle = { toJSON: () => 1, inner: { run() {} } } as unknown as number;
  await expect(service.add(circle, 1)).rejects.toMatchObject({ name: 'DataCloneError' });
  expect(asked).toEqual([]);
});
