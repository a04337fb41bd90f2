/** The version of the messages: stands in each of them, and tells them from those of other programs. */
export const PROTOCOL = 1;

/** What a page may ask of the viewer in its frame. */
export const CALLS = ['play', 'pause', 'seek', 'step', 'set', 'getState', 'setState', 'toBlob', 'exportGLB'] as const;
export type CallName = (typeof CALLS)[number];

/** A call as it came: `id` is given back with the answer. */
export interface Call {
  readonly windgrove: typeof PROTOCOL;
  readonly id: number | string;
  readonly call: CallName;
  readonly args: readonly unknown[];
}

/** The answer to a call. */
export type Answer =
  | { readonly windgrove: typeof PROTOCOL; readonly id: Call['id']; readonly result: unknown }
  | { readonly windgrove: typeof PROTOCOL; readonly id: Call['id']; readonly error: string };

/** Something that happened in the viewer, told to the page around it. */
export interface Told {
  readonly windgrove: typeof PROTOCOL;
  readonly event: string;
  readonly detail: unknown;
}

const isId = (id: unknown): id is Call['id'] => typeof id === 'number' || (typeof id === 'string' && id.length <= 100);

/**
 * What a message asks for. null: it is none of ours, and nobody answers. With `error`: it is one of ours, and there is something wrong with it.
 *
 * Never throws: anybody may send anything.
 */
export function readCall(data: unknown): Call | Extract<Answer, { error: string }> | null {
  if (typeof data !== 'object' || data === null) return null;
  const { windgrove, id, call, args = [] } = data as Record<string, unknown>;
  if (windgrove !== PROTOCOL || !isId(id) || call === undefined) return null;
  const name = CALLS.find((each) => each === call);
  const wrong = (error: string) => ({ windgrove: PROTOCOL, id, error }) as const;
  if (!name)
    return wrong(`The viewer has no call ${JSON.stringify(String(call).slice(0, 40))}; it has ${CALLS.join(', ')}.`);
  if (!Array.isArray(args)) return wrong('args has to be a list.');
  return { windgrove: PROTOCOL, id, call: name, args };
}

/**
 * Who may speak to the viewer: the page around it, or the one that opened it; where the address names origins (`origin=https://a.example`), only those.
 */
export interface Host {
  readonly source: unknown;
  readonly origins: readonly string[];
}

export const mayCall = (host: Host, message: { readonly source: unknown; readonly origin: string }): boolean =>
  message.source !== null &&
  message.source === host.source &&
  (host.origins.length === 0 || host.origins.includes(message.origin));

/** To which origins events go: those that are named, else whoever frames the viewer; what they hold is what that page sees anyway. */
export const toldOrigins = ({ origins }: Host): readonly string[] => (origins.length === 0 ? ['*'] : origins);
