import { deflateSync, Inflate, strFromU8, strToU8 } from 'fflate';
import { bytesFromBase64, bytesToBase64 } from './text.ts';

/** Bytes that a packed link may hold: a link of a few kilobytes can unpack to gigabytes. */
const MOST = 2_000_000;
/** Bytes that are unpacked at a time: a thousand times as many may come out. */
const PART = 512;

/** A link made short: base64url of its deflated UTF-8. */
export const packLink = (link: string): string => bytesToBase64(deflateSync(strToU8(link), { level: 9 }));

/** What `packLink` was given, or undefined where this is not its work, or is longer than any link. Never throws. */
export function unpackLink(packed: string): string | undefined {
  const bytes = bytesFromBase64(packed);
  if (!bytes) return undefined;
  const parts: Uint8Array[] = [];
  let length = 0;
  let ended = false;
  try {
    const inflate = new Inflate((part, last) => {
      parts.push(part);
      length += part.length;
      ended ||= last;
    });
    for (let at = 0; at < bytes.length && length <= MOST; at += PART) {
      inflate.push(bytes.subarray(at, at + PART), at + PART >= bytes.length);
    }
  } catch {
    return undefined;
  }
  if (!ended || length > MOST) return undefined;
  const whole = new Uint8Array(length);
  let at = 0;
  for (const part of parts) {
    whole.set(part, at);
    at += part.length;
  }
  return strFromU8(whole);
}
