import { type DecodeOptions, decodeLink, encodeLink, type LinkDocument, type LinkFault } from '../core/link/link.ts';

/** At most one writing of the address in so many milliseconds: browsers refuse more than a hundred in half a minute. */
const PACE = 400;

/** Keys of a link that may stand in the query too; others there belong to somebody else. */
const ours =
  /^(s|own|seed|t|paused|rate|cam|levels|leaves|view|theme|arrows|fronts|handle|probe|blow|compare|(b\.)?(wind|name|says|strength|waves|w[1-8]|g([1-9]|1[0-6])|profile|zero|rec|stiff|model|spring|levelhz|leveldamp|sway|p|m|pose|paper))$/;

/** The address of the page and the document, both ways. */
export class Address {
  private timer = 0;
  private next: LinkDocument | null = null;

  /** Reads the part behind `#`, and what of a link stands in the query. */
  read(options: DecodeOptions): { document: LinkDocument; faults: LinkFault[] } {
    const query = [...new URLSearchParams(location.search)].filter(([key]) => ours.test(key));
    const link = [new URLSearchParams(query).toString(), location.hash.replace(/^#/, '')].filter(Boolean).join('&');
    return decodeLink(link, options);
  }

  /** The whole address of a document. */
  of(document: LinkDocument): string {
    const url = new URL(location.href);
    url.search = '';
    url.hash = encodeLink(document);
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
    if (this.next) history.replaceState(null, '', this.of(this.next));
    this.next = null;
  }
}
