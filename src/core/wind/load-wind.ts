import { parseWind } from './parse-wind.ts';
import type { LoadedWind } from './wind-with-record.ts';

/**
 * A wind from the text of its file, and from that of the CSV file beside it where it names one; `fetchText` is asked for that alone. What
 * reads such a file is loaded with the first.
 */
export async function loadWind(text: string, fetchText: (recordFile: string) => Promise<string>): Promise<LoadedWind> {
  const parsed = parseWind(text);
  if (!parsed.wind || parsed.recordFile === null) return parsed;
  const [csv, { parseWindWithRecord }] = await Promise.all([
    fetchText(parsed.recordFile),
    import('./wind-with-record.ts'),
  ]);
  return parseWindWithRecord(text, () => csv);
}
