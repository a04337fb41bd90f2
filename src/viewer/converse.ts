import { answer, type Settable, type Tree } from './answer.ts';
import { type Host, mayCall, PROTOCOL, readCall, type Told, toldOrigins } from './protocol.ts';

/** Events of the element that the page around the viewer hears of. */
export const TOLD = [
  'load',
  'error',
  'progress',
  'timeupdate',
  'quality-change',
  'camera-change',
  'visibility',
  'statechange',
] as const;

type Post = { postMessage(message: unknown, origin: string): void };

/** Hears calls from the host and tells it what happens; `ready` comes at once. */
export function converse(
  tree: Tree & EventTarget,
  host: Host & { readonly source: Post | null },
  settable: Settable,
): void {
  const { source } = host;
  if (!source) return;
  const tell = (event: string, detail: unknown): void => {
    const told: Told = { windgrove: PROTOCOL, event, detail };
    for (const origin of toldOrigins(host)) source.postMessage(told, origin);
  };
  addEventListener('message', (message) => {
    if (!mayCall(host, message)) return;
    const call = readCall(message.data);
    if (!call) return;
    // A page of no origin, as one from a file, can only be answered by '*'.
    const back = message.origin === 'null' ? '*' : message.origin;
    if ('error' in call) source.postMessage(call, back);
    else void answer(tree, call, settable).then((answered) => source.postMessage(answered, back));
  });
  for (const event of TOLD)
    tree.addEventListener(event, (happened) => tell(event, (happened as CustomEvent).detail ?? null));
  tell('ready', { version: PROTOCOL });
}
