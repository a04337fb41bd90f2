import { viewerLacks } from '../core/link/viewer-parts.ts';
import { LONGEST_PROJECT, PROJECT_ENDING } from '../core/project/limits.ts';
import type { Species } from '../core/species/species.ts';
import type { DiskFile, Doing } from './doing.ts';
import { embedSnippet } from './embed-snippet.ts';
import { FileError } from './file-error.ts';
import { type KeptFile, keptFile } from './kept-file.ts';
import { madeOf, sameMade } from './made.ts';
import type { Readers } from './open-file.ts';
import { textOf } from './public-file.ts';
import { loadSpecies, readSpecies } from './species-source.ts';
import { fileWords } from './words/files.ts';

/** `Old oak` as `old-oak`: the name of a file. */
const slug = (name: string): string =>
  name
    .normalize('NFKD')
    .replace(/\p{M}/gu, '')
    .toLowerCase()
    .replace(/[^\p{L}\p{N}]+/gu, '-')
    .replace(/^-|-$/g, '') || fileWords.untitled;

/** A whole work as a file: save, open, start anew, show in another page. */
export function projectActions(doing: Doing, readers: Readers) {
  const { document, session, services, notify, say } = doing;

  const base = async (): Promise<Species> => {
    const { species, ownSpecies } = document.getState();
    if (ownSpecies !== null) return readSpecies(ownSpecies, fileWords.notSaved);
    const entry = session.getState().species.find((s) => s.id === species);
    if (!entry) throw new FileError(fileWords.notSaved);
    return loadSpecies(entry);
  };
  const treeName = (): string => document.getState().treeName ?? session.getState().tree?.species.name ?? '';
  const tell = (title: string, error: unknown): void => {
    if (error instanceof FileError) notify('error', error.message, error.lines);
    else notify('error', title, [error instanceof Error ? error.message : String(error)]);
  };

  const write = async (to: DiskFile): Promise<void> => {
    try {
      // What a file is made of is loaded with the first file.
      const { projectText } = await import('../core/project/project.ts');
      const now = services.now();
      const text = projectText({
        species: await base(),
        preset: now.ownSpecies === null ? now.species : null,
        document: now,
        snapshots: session.getState().snapshots.map(({ name, when, link }) => ({ name, when, link })),
      });
      const kept = keptFile(to, document, session);
      const written = await services.write(to, text);
      if (!written) return;
      session.setState({ file: { ...kept, ...written } });
      if (written.handle) say(fileWords.saved(written.name));
      else notify('note', fileWords.downloaded(written.name));
    } catch (error) {
      tell(fileWords.notSaved, error);
    }
  };
  const suggested = (): string => session.getState().file?.name ?? `${slug(treeName())}${PROJECT_ENDING}`;

  /** Another work in place of this one: the file goes with the step, there and back. */
  const replaceWork = (show: () => void, next: () => KeptFile | null): void => {
    const { history } = document;
    const before = session.getState().file;
    const index = history.index;
    history.together(show);
    const file = next();
    session.setState({ file });
    if (history.index !== index) history.openedFile(before, file);
  };
  document.history.onFile = (file) => session.setState({ file });
  const isEdited = (): boolean => document.history.canUndo || document.history.canRedo;
  const opening = { ...doing, ...readers, replaceWork, isEdited };
  // What opens files is loaded with the first file.
  const show = async (text: string, file: DiskFile): Promise<void> =>
    (await import('./open-file.ts')).showFile(text, file, opening);

  /** Opens a text, whatever of all kinds it is; `name` stands in messages. */
  const openText = async (text: string, name: string, handle: FileSystemFileHandle | null = null): Promise<void> => {
    try {
      await show(text, { name, handle });
    } catch (error) {
      tell(fileWords.unreadable(name), error);
    }
  };
  const openFile = async (file: File, handle: FileSystemFileHandle | null = null): Promise<void> => {
    try {
      await show(await textOf(file, LONGEST_PROJECT), { name: file.name, handle });
    } catch (error) {
      tell(fileWords.unreadable(file.name), error);
    }
  };

  return {
    save: (): Promise<void> => write({ name: suggested(), handle: session.getState().file?.handle ?? null }),
    saveAs: (): Promise<void> => write({ name: suggested(), handle: null }),
    async open(): Promise<void> {
      const picked = await services.pick();
      if (picked) await openFile(picked.file, picked.handle);
    },
    openFile,
    openText,
    /** The tree of a first visit; what was there is kept as a snapshot. */
    newTree(): void {
      const { theme } = document.getState();
      const first = { ...services.first(), theme };
      if (sameMade(madeOf(first), madeOf(document.getState()))) return;
      const name = readers.keepBefore(fileWords.beforeNew);
      replaceWork(
        () => services.show(first),
        () => null,
      );
      say(name === null ? fileWords.newTree : fileWords.newTreeKept(name));
    },
    /** Copies what shows this tree in another page. */
    async copyEmbed(): Promise<void> {
      const now = services.now();
      const snippet = embedSnippet(services.addressOf(now), fileWords.embedTitle(treeName()));
      const lacks = viewerLacks(now);
      const lines = [...(lacks.length > 0 ? [fileWords.embedLacks(lacks)] : []), ...services.notInLink(now)];
      try {
        await services.copy(snippet);
        notify('note', fileWords.embedCopied, lines);
      } catch {
        notify('note', fileWords.embedShown, [...lines, snippet]);
      }
    },
  };
}
