import { MessageChannel } from 'node:worker_threads';
import type { WorkerLike } from '../../src/worker/client.ts';
import { offer } from '../../src/worker/remote.ts';

/** A worker's service behind a channel in this thread: messages are cloned and transferred as between threads. */
export class FakeWorker implements WorkerLike {
  terminated = false;
  asked = 0;
  private readonly channel = new MessageChannel();
  private readonly near = this.channel.port1 as unknown as MessagePort;
  private readonly listeners: ((event: Event) => void)[] = [];

  constructor(service: object) {
    const far = this.channel.port2 as unknown as MessagePort;
    offer(service, far);
    far.start();
    this.near.start();
  }

  postMessage(message: unknown, transfer: unknown = []): void {
    this.asked++;
    this.near.postMessage(message, transfer as Transferable[]);
  }
  addEventListener(type: string, listener: unknown): void {
    if (type === 'error') this.listeners.push(listener as (event: Event) => void);
    else this.near.addEventListener(type, listener as EventListener);
  }
  terminate(): void {
    this.terminated = true;
    this.near.close();
  }
  fail(message: string): void {
    for (const listener of this.listeners) listener(Object.assign(new Event('error'), { message }));
  }
}
