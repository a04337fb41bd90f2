import type { LinkDocument } from '../core/link/link.ts';
import type { Address } from './address.ts';
import type { Services } from './doing.ts';
import type { Notice } from './session.ts';

/** What the page does for the actions: clipboard, files, address. `now` is the document at this moment. */
export function pageServices(page: {
  readonly address: Address;
  now(): LinkDocument;
  notify(kind: Notice['kind'], title: string, lines?: readonly string[]): void;
  cancelGrowing(): void;
  /** Whether a record ships, so that a link can name it. */
  ships(record: string): boolean;
}): Services {
  const copy = (text: string): Promise<void> => navigator.clipboard.writeText(text);
  return {
    copy,
    cancelGrowing: page.cancelGrowing,
    save(name, text) {
      const link = document.createElement('a');
      link.href = URL.createObjectURL(new Blob([text], { type: 'application/json' }));
      link.download = name;
      link.click();
      // The browser has begun to read it by the next task.
      setTimeout(() => URL.revokeObjectURL(link.href));
    },
    async share() {
      const document = page.now();
      page.address.write(document);
      page.address.flush();
      const own = [document.wind.record, document.compare?.wind.record].filter((r) => r && !page.ships(r.name));
      const lines = own.map((r) => `${r!.name} is not in it: a measured wind of your own is too long for a link.`);
      try {
        await copy(location.href);
        page.notify('note', 'The link to this picture is copied', lines);
      } catch {
        page.notify('note', 'The browser does not let this page copy; the link is in the address bar', [
          location.href,
          ...lines,
        ]);
      }
    },
  };
}
