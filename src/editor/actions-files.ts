import { OWN_WIND, roundWind } from '../core/link/link.ts';
import type { parseAnemometer } from '../core/wind/anemometer.ts';
import { LONGEST_WIND, parseWind } from '../core/wind/parse-wind.ts';
import type { Wind } from '../core/wind/wind.ts';
import { windText } from '../core/wind/wind-file.ts';
import type { Doing } from './doing.ts';
import { editedWind, putWind } from './edited-wind.ts';
import { FileError } from './file-error.ts';
import { messageWords, windMessages } from './words/messages.ts';

/** The wind that a text is; throws a FileError under `title`. */
export function readWind(text: string, title: string): Wind {
  const parsed = parseWind(text);
  if (!parsed.wind) throw FileError.of(title, parsed.faults);
  if (parsed.recordFile !== null) throw new FileError(title, [windMessages.recordMissing(parsed.recordFile)]);
  return parsed.wind;
}

/** What the file of an anemometer was read as. */
export type ParsedRecord = ReturnType<typeof parseAnemometer>;

/** `Gusty afternoon` as `gusty-afternoon`: the name of a file. */
const fileName = (name: string): string =>
  name
    .toLowerCase()
    .replace(/[^a-z0-9]+/g, '-')
    .replace(/^-|-$/g, '') || 'wind';

/** A wind as text and file, both ways. */
export function fileActions({ document, session, services, set, say, notify }: Doing) {
  const take = (text: string, title: string): boolean => {
    try {
      const wind = roundWind(readWind(text, title));
      putWind(document, session, wind, OWN_WIND);
      session.setState({ gust: null });
      if (!document.getState().blowing) set({ blowing: true });
      say(windMessages.blows(wind.name));
      return true;
    } catch (error) {
      if (!(error instanceof FileError)) throw error;
      notify('error', error.message, error.lines);
      return false;
    }
  };
  const text = (): string => windText(editedWind(document, session).wind);

  return {
    /** Takes a wind that was copied as JSON; where it is none, one message says why and nothing changes. */
    pasteWind: (pasted: string) => take(pasted, windMessages.pasted),
    /** Takes the text of a file. */
    openWind: (opened: string, name: string) => take(opened, messageWords.notOpened(name)),
    /** Takes a measured wind: it blows in place of the waves. */
    openRecord(parsed: ParsedRecord, name: string): boolean {
      if (!parsed.record) {
        const { message, lines } = FileError.of(messageWords.notOpened(name), parsed.faults);
        notify('error', message, lines);
        return false;
      }
      const { record, notes } = parsed;
      const silent = editedWind(document, session).wind.waves.map((wave) => ({ ...wave, on: false }));
      putWind(document, session, { record, waves: silent });
      if (!document.getState().blowing) set({ blowing: true });
      notify('note', windMessages.recordBlows(name), notes);
      return true;
    },
    async copyWind(): Promise<void> {
      try {
        await services.copy(text());
        notify('note', windMessages.copied);
      } catch {
        notify('warning', windMessages.notCopied);
      }
    },
    saveWind: () => services.save(`${fileName(editedWind(document, session).wind.name)}.json`, text()),
    longestWind: LONGEST_WIND,
  };
}
