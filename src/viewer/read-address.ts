import { nearest } from '../core/file/nearest.ts';
import { isLinkKey } from '../core/link/link.ts';
import { ATTRIBUTES } from '../element/attributes.ts';

/** Attributes of the element that are only there or not. */
const SWITCHES: readonly string[] = ['camera-controls', 'paused'];

/** The element's attributes that an address may name. */
export const VIEWER_ATTRIBUTES: ReadonlySet<string> = new Set([...Object.keys(ATTRIBUTES), ...SWITCHES, 'alt']);

/** What only a link of the editor has: by these it is told from attributes, with which it shares `seed`, `wind`, `season`, ... */
const LINK_MARKS: readonly string[] = ['s', 'own', 'file', 'z'];

const OFF = /^(?:off|false|0)$/i;

/** What the address of the viewer asks for. */
export interface ViewerAddress {
  /** Attributes of the element; those that are only there or not have the value ''. */
  readonly attributes: ReadonlyMap<string, string>;
  /** A link of the editor, or null: the attributes say all. */
  readonly link: string | null;
  /** Origins that may call; none: any page around the viewer. */
  readonly origins: readonly string[];
  /** Sentences about keys that nobody reads. */
  readonly faults: readonly string[];
}

const originOf = (text: string): string | null => {
  try {
    const { origin } = new URL(text);
    return origin === 'null' ? null : origin;
  } catch {
    return null;
  }
};

/**
 * Reads what stands behind `?` and `#` of the viewer's address: attributes of the element by their names, or a link of the editor.
 *
 * Beside a link, an attribute that no link has, as `camera-controls` or `wind-speed`, holds as well. Never throws.
 */
export function readAddress(search: string, hash: string): ViewerAddress {
  const pairs = [...new URLSearchParams(search), ...new URLSearchParams(hash.replace(/^#/, ''))];
  const isLink = pairs.some(([key]) => LINK_MARKS.includes(key));
  // The reader may look around unless the address says that they may not.
  const attributes = new Map<string, string>([['camera-controls', '']]);
  const origins: string[] = [];
  const faults: string[] = [];
  const link = new URLSearchParams();
  for (const [key, value] of pairs) {
    if (key === 'origin') {
      const origin = originOf(value);
      if (origin) origins.push(origin);
      else faults.push(`origin: found "${value}"; allowed is an origin as https://example.org.`);
    } else if (key === 'embed') {
      // Of links from the time when the editor itself stood in frames.
    } else if (isLink && isLinkKey(key)) link.append(key, value);
    else if (SWITCHES.includes(key)) {
      if (OFF.test(value)) attributes.delete(key);
      else attributes.set(key, '');
    } else if (VIEWER_ATTRIBUTES.has(key)) attributes.set(key, value);
    else {
      const near = nearest(key, [...VIEWER_ATTRIBUTES]);
      faults.push(`"${key}" is no attribute of wind-tree${near ? `; was ${near} meant?` : '.'}`);
    }
  }
  // A slip in the list of who may call must not let everybody in.
  if (origins.length === 0 && pairs.some(([key]) => key === 'origin')) origins.push('null');
  return { attributes, link: isLink ? link.toString() : null, origins, faults };
}
