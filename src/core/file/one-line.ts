/** Line breaks, other control characters, and marks that turn the direction of writing: they would forge lines and colours of a message. */
const UNSEEN = /[\p{Cc}\u2028\u2029\u200e\u200f\u202a-\u202e\u2066-\u2069\ufeff]/gu;

/** A text from outside as a message shows it: one line of at most `most` characters, with what cannot be seen written as \u001b. */
export function oneLine(text: string, most = 40): string {
  const short = text.length > most ? `${text.slice(0, most)}…` : text;
  return short.replace(UNSEEN, (c) => `\\u${c.charCodeAt(0).toString(16).padStart(4, '0')}`);
}
