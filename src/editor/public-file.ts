import { FileError } from './file-error.ts';

/** Where a file of `public/` lies, wherever the page does. */
export const publicUrl = (path: string): URL => new URL(path, document.baseURI);

/** The text of a file of `public/`; throws a FileError that names `what` and says why. */
export async function fetchText(path: string, what: string): Promise<string> {
  const url = publicUrl(path);
  const response = await fetch(url).catch((error: unknown) => {
    throw new FileError(`${what} could not be loaded`, [
      `${url.pathname}: ${String(error)}`,
      'Is the connection up? Reload the page to try again.',
    ]);
  });
  if (!response.ok)
    throw new FileError(`${what} could not be loaded`, [
      `${url.pathname}: the server says ${response.status} ${response.statusText}`,
    ]);
  return response.text();
}

/** The text of a file that the reader gave, unless it is longer than `longest` bytes. */
export async function textOf(file: File, longest: number): Promise<string> {
  if (file.size > longest)
    throw new FileError(`${file.name} was not opened`, [`It has ${file.size} bytes; at most ${longest} are read.`]);
  return file.text();
}
