/** Bytes as base64url without padding: letters, digits, - and _, which no address has to escape. */
export function bytesToBase64(bytes: Uint8Array): string {
  let codes = '';
  for (const byte of bytes) codes += String.fromCharCode(byte);
  return btoa(codes).replaceAll('+', '-').replaceAll('/', '_').replaceAll('=', '');
}

/** What `bytesToBase64` wrote, or undefined where it is not that. */
export function bytesFromBase64(base64: string): Uint8Array | undefined {
  if (!/^[\w-]+$/.test(base64)) return undefined;
  try {
    const bytes = atob(base64.replaceAll('-', '+').replaceAll('_', '/'));
    return Uint8Array.from(bytes, (c) => c.charCodeAt(0));
  } catch {
    return undefined;
  }
}

/** UTF-8 text as base64url. */
export const textToBase64 = (text: string): string => bytesToBase64(new TextEncoder().encode(text));

/** What `textToBase64` wrote, or undefined where it is not that. */
export function textFromBase64(base64: string): string | undefined {
  try {
    const bytes = bytesFromBase64(base64);
    return bytes && new TextDecoder('utf-8', { fatal: true }).decode(bytes);
  } catch {
    return undefined;
  }
}
