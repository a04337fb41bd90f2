import type { GrownTree } from './protocol.ts';

/** Asks for what is newest; returns at once. */
export type Ask<Request> = (request: Request) => void;

/**
 * Grows while the user drags: one request at a time, always with the newest wish, so that trees follow the drag as fast as
 * they grow instead of superseding each other until the hand rests. Requests that came in between are left out.
 *
 * `grow` makes one tree; `show` gets each tree that is made and `fail` each error. Between two calls of `show` no tree is
 * lost: the last request is always answered by one of them.
 */
export function liveGrower<Request>(
  grow: (request: Request) => Promise<GrownTree>,
  show: (tree: GrownTree, request: Request) => void,
  fail: (error: unknown, request: Request) => void,
): Ask<Request> {
  let newest: { request: Request } | null = null;
  let running = false;
  const work = async (): Promise<void> => {
    running = true;
    while (newest) {
      const { request } = newest;
      newest = null;
      try {
        show(await grow(request), request);
      } catch (error) {
        fail(error, request);
      }
    }
    running = false;
  };
  return (request) => {
    newest = { request };
    if (!running) void work();
  };
}
