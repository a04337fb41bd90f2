import { FileError } from './file-error.ts';
import { messageWords } from './words/messages.ts';

/** Where a file of `public/` lies, wherever the page does. */
export const publicUrl = (path: string): URL => new URL(path, document.baseURI);

/** The text of a file of `public/`; throws a FileError that names `what` and says why. */
export async function fetchText(path: string, what: string): Promise<string> {
  const url = publicUrl(path);
  const response = await fetch(url).catch((error: unknown) => {
    throw new FileError(messageWords.notLoaded(what), [
      messageWords.why(url.pathname, String(error)),
      messageWords.connection,
    ]);
  });
  if (!response.ok)
    throw new FileError(messageWords.notLoaded(what), [
      messageWords.server(url.pathname, `${response.status} ${response.statusText}`),
    ]);
  return response.text();
}

/** The text of a file that the reader gave, unless it is longer than `longest` bytes. */
export async function textOf(file: File, longest: number): Promise<string> {
  if (file.size > longest)
    throw new FileError(messageWords.notOpened(file.name), [messageWords.tooLong(file.size, longest)]);
  return file.text();
}
