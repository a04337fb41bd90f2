import type { LinkDocument } from '../core/link/link.ts';
import type { Address } from './address.ts';
import type { Services } from './doing.ts';
import { download, pageFiles } from './page-files.ts';
import type { Notice } from './session.ts';
import { fileWords } from './words/files.ts';

type Given = 'now' | 'first' | 'read' | 'show' | 'thumbnail' | 'cancelGrowing';

/** What the page does for the actions: clipboard, files, address. */
export function pageServices(
  page: Pick<Services, Given> & {
    readonly address: Address;
    notify(kind: Notice['kind'], title: string, lines?: readonly string[]): void;
    /** Whether a record ships, so that a link can name it. */
    ships(record: string): boolean;
  },
): Services {
  const { address, now, first, read, show, thumbnail, cancelGrowing } = page;
  const copy = (text: string): Promise<void> => navigator.clipboard.writeText(text);
  const notInLink = (document: LinkDocument): string[] =>
    [document.wind.record, document.compare?.wind.record]
      .filter((r) => r && !page.ships(r.name))
      .map((r) => fileWords.notInLink(r!.name));
  return {
    ...pageFiles,
    now,
    first,
    read,
    show,
    thumbnail,
    cancelGrowing,
    copy,
    when: Date.now,
    addressOf: (document) => address.of(document),
    notInLink,
    save: download,
    async share() {
      const document = now();
      address.write(document);
      address.flush();
      const lines = notInLink(document);
      try {
        await copy(location.href);
        page.notify('note', fileWords.linkCopied, lines);
      } catch {
        page.notify('note', fileWords.linkShown, [location.href, ...lines]);
      }
    },
  };
}
