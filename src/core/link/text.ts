/** UTF-8 text as base64url without padding: letters, digits, - and _, which no address has to escape. */
export function textToBase64(text: string): string {
  let bytes = '';
  for (const byte of new TextEncoder().encode(text)) bytes += String.fromCharCode(byte);
  return btoa(bytes).replaceAll('+', '-').replaceAll('/', '_').replaceAll('=', '');
}

/** What `textToBase64` wrote, or undefined where it is not that. */
export function textFromBase64(base64: string): string | undefined {
  if (!/^[\w-]+$/.test(base64)) return undefined;
  try {
    const bytes = atob(base64.replaceAll('-', '+').replaceAll('_', '/'));
    return new TextDecoder('utf-8', { fatal: true }).decode(Uint8Array.from(bytes, (c) => c.charCodeAt(0)));
  } catch {
    return undefined;
  }
}
