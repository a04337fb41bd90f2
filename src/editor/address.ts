import {
  type DecodeOptions,
  decodeLink,
  encodeLink,
  isLinkKey,
  type LinkDocument,
  type LinkFault,
} from '../core/link/link.ts';

/** At most one writing of the address in so many milliseconds: browsers refuse more than a hundred in half a minute. */
const PACE = 400;

/** What in an address opens the gallery, or the page of a species in it. */
const GALLERY = /(?:^|&)gallery(?:=([^&]*))?(?=&|$)/;

/** The address of the page and the document, both ways. */
export class Address {
  private timer = 0;
  private next: LinkDocument | null = null;
  private isHeld = false;
  private written = '';
  /** The page stands in another page: its address says so, and goes on saying so. */
  readonly embed = new URLSearchParams(location.hash.slice(1)).get('embed') === '1';

  /** The link of the address: the part behind `#`, and what of a link stands in the query; '' where there is none. */
  private get link(): string {
    const query = [...new URLSearchParams(location.search)].filter(([key]) => isLinkKey(key));
    const hash = location.hash
      .replace(/^#/, '')
      .replace(/(^|&)embed=1(?=&|$)/, '')
      .replace(GALLERY, '');
    return [new URLSearchParams(query).toString(), hash].filter(Boolean).join('&');
  }

  /** The species whose page of the gallery the address asks for; '': for all of them; null: for no gallery. */
  get gallery(): string | null {
    const found = GALLERY.exec(location.hash.slice(1));
    return found && !this.embed ? (found[1] ?? '') : null;
  }

  /** Nothing is written from now on: what stands there is not the document's. */
  hold(): void {
    this.isHeld = true;
  }

  /** What stands there is a document's again; what waited to be written meanwhile is not. */
  release(): void {
    this.isHeld = false;
    this.next = null;
  }

  /** A document of now in an entry of its own of the browser's history. */
  push(document: LinkDocument): void {
    this.release();
    this.written = this.of(document);
    history.pushState(null, '', this.written);
  }

  /** The address says what the page wrote there last. */
  get isWritten(): boolean {
    return location.href === this.written;
  }

  /** Whether the address asks for anything. */
  get asks(): boolean {
    return this.link !== '';
  }

  read(options: DecodeOptions): { document: LinkDocument; faults: LinkFault[] } {
    return decodeLink(this.link, options);
  }

  /** The whole address of a document. */
  of(document: LinkDocument): string {
    const url = new URL(location.href);
    url.search = '';
    url.hash = `${encodeLink(document)}${this.embed ? '&embed=1' : ''}`;
    return url.href;
  }

  /** Writes the document into the address, soon. */
  write(document: LinkDocument): void {
    this.next = document;
    this.timer ||= window.setTimeout(() => this.flush(), PACE);
  }

  /** Writes what waits to be written. */
  flush(): void {
    window.clearTimeout(this.timer);
    this.timer = 0;
    if (this.isHeld) return;
    if (this.next) {
      this.written = this.of(this.next);
      history.replaceState(history.state, '', this.written);
    }
    this.next = null;
  }
}
