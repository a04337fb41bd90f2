import { isArbaro, isEzTree } from '../core/io/imported.ts';
import { isProjectText } from '../core/project/limits.ts';
import type { ParsedRecord } from './actions-files.ts';
import type { DiskFile, Doing } from './doing.ts';
import { FileError } from './file-error.ts';
import { isWindText } from './file-kinds.ts';
import { type KeptFile, keptFile } from './kept-file.ts';
import { readSpecies } from './species-source.ts';
import { fileWords } from './words/files.ts';

/** Those actions that take a text of one kind. */
export interface Readers {
  openWind(text: string, name: string): boolean;
  openRecord(parsed: ParsedRecord, name: string): boolean;
  openSpecies(text: string): void;
  setSeed(seed: number): void;
  /** Keeps what is shown as a snapshot of this name. */
  keepBefore(name: string): string | null;
}

/** What opening a file needs. */
export interface Opening extends Doing, Readers {
  isEdited(): boolean;
  /** Shows another work; its file goes with the step. */
  replaceWork(show: () => void, next: () => KeptFile | null): void;
}

/**
 * Opens what the reader gives, whichever the file says that it is: a project, a species, a wind, a measured wind, or a tree of another
 * program. One step of the history. Throws a FileError where it cannot be read.
 */
export async function showFile(text: string, file: DiskFile, opening: Opening): Promise<void> {
  const { name } = file;
  if (isProjectText(text)) await showProject(text, file, opening);
  else if (isWindText(text)) opening.document.history.together(() => opening.openWind(text, name));
  else if (/\.csv$/i.test(name)) {
    const { parseAnemometer } = await import('../core/wind/anemometer.ts');
    const parsed = parseAnemometer(text, { name });
    opening.document.history.together(() => opening.openRecord(parsed, name));
  } else if (isArbaro(text) || isEzTree(text)) await showImported(text, name, opening);
  else {
    readSpecies(text, fileWords.notOpened(name));
    opening.openSpecies(text);
  }
}

async function showProject(text: string, file: DiskFile, opening: Opening): Promise<void> {
  const { document, session, services, say } = opening;
  const { documentOfProject, readProject } = await import('./read-project.ts');
  const project = readProject(text, fileWords.notOpened(file.name));
  const { theme } = document.getState();
  const shown = await documentOfProject(project, session.getState(), theme);
  if (opening.isEdited()) opening.keepBefore(fileWords.beforeFile(file.name));
  const { snapshots } = session.getState();
  const when = services.when().toString(36);
  const more = project.snapshots
    .filter(({ name, link }) => !snapshots.some((s) => s.name === name && s.link === link))
    .map((s, i) => ({ ...s, id: `${when}-file-${i}`, document: null, thumbnail: null }));
  opening.replaceWork(
    () => services.show(shown),
    () => {
      session.setState({ snapshots: [...more, ...snapshots] });
      return keptFile(file, document, session);
    },
  );
  say(fileWords.opened(file.name));
}

async function showImported(text: string, name: string, opening: Opening): Promise<void> {
  // Who never opens such a file never loads what reads it.
  const read = isArbaro(text)
    ? (await import('../core/io/arbaro.ts')).parseArbaro
    : (await import('../core/io/ez-tree.ts')).parseEzTree;
  const imported = read(text);
  if (!imported.species) throw FileError.of(fileWords.notOpened(name), imported.faults);
  const { species, seed, notes } = imported;
  opening.document.history.together(() => {
    opening.openSpecies(JSON.stringify(species, null, 2));
    if (seed !== undefined) opening.setSeed(seed);
  });
  if (notes.length > 0) opening.notify('note', fileWords.imported(name), notes);
  opening.say(fileWords.opened(name));
}
