import type { DiskFile, Services } from './doing.ts';
import { fileWords } from './words/files.ts';

/** What browsers that write files in place have besides. */
interface Pickers {
  showSaveFilePicker?(options: object): Promise<FileSystemFileHandle>;
  showOpenFilePicker?(options: object): Promise<FileSystemFileHandle[]>;
}
interface Asking {
  requestPermission?(options: { mode: 'readwrite' }): Promise<PermissionState>;
}

const JSON_KIND = 'application/json';

/** Milliseconds for which a file that is no text stays readable. */
const LARGE_FILE = 60_000;

const OPENED = { [JSON_KIND]: ['.json'], 'text/csv': ['.csv'], 'text/xml': ['.xml'] };

const pickers = (): Pickers => window as Pickers;
const named = (error: unknown, name: string): boolean => error instanceof DOMException && error.name === name;

/** Gives the reader a file among the downloads. */
export function download(name: string, content: string | Blob): void {
  const link = document.createElement('a');
  link.href = URL.createObjectURL(typeof content === 'string' ? new Blob([content], { type: JSON_KIND }) : content);
  link.download = name;
  link.click();
  // The browser has begun to read it by the next task; a large one it may read for a while.
  setTimeout(() => URL.revokeObjectURL(link.href), typeof content === 'string' ? 0 : LARGE_FILE);
}

async function writeTo(handle: FileSystemFileHandle, text: string): Promise<void> {
  const writable = await handle.createWritable();
  await writable.write(text);
  await writable.close();
}

/** Whether the file may be written: one from an earlier visit has to be asked for again. */
async function mayWrite(handle: FileSystemFileHandle & Asking): Promise<boolean> {
  return !handle.requestPermission || (await handle.requestPermission({ mode: 'readwrite' })) === 'granted';
}

/** Files on the reader's disk: written in place where the browser can, among the downloads elsewhere. */
export const pageFiles: Pick<Services, 'write' | 'pick'> = {
  async write({ name, handle }: DiskFile, text: string): Promise<DiskFile | null> {
    if (handle && (await mayWrite(handle))) {
      await writeTo(handle, text);
      return { name: handle.name, handle };
    }
    const { showSaveFilePicker } = pickers();
    if (showSaveFilePicker) {
      try {
        const types = [{ description: fileWords.kinds.project, accept: { [JSON_KIND]: ['.json'] } }];
        const chosen = await showSaveFilePicker.call(window, { suggestedName: name, types });
        await writeTo(chosen, text);
        return { name: chosen.name, handle: chosen };
      } catch (error) {
        if (named(error, 'AbortError')) return null;
        // In a frame of another page nothing can be chosen; downloads still work.
        if (!named(error, 'SecurityError')) throw error;
      }
    }
    download(name, text);
    return { name, handle: null };
  },
  async pick() {
    const { showOpenFilePicker } = pickers();
    if (showOpenFilePicker) {
      try {
        const types = [{ description: fileWords.kinds.any, accept: OPENED }];
        const [handle] = await showOpenFilePicker.call(window, { types });
        return handle ? { file: await handle.getFile(), handle } : null;
      } catch (error) {
        if (named(error, 'AbortError')) return null;
        if (!named(error, 'SecurityError')) throw error;
      }
    }
    return new Promise((done) => {
      const input = document.createElement('input');
      input.type = 'file';
      input.accept = [...Object.keys(OPENED), ...Object.values(OPENED).flat()].join();
      const end = (): void => {
        input.remove();
        done(input.files?.[0] ? { file: input.files[0], handle: null } : null);
      };
      input.addEventListener('change', end);
      input.addEventListener('cancel', end);
      // In the page, so that no browser clears it away while the reader looks for the file.
      input.hidden = true;
      document.body.append(input);
      input.click();
    });
  },
};
