import type { Fault } from '../file/fault.ts';
import { parseAnemometer } from './anemometer.ts';
import { parseWind } from './parse-wind.ts';
import type { Wind } from './wind.ts';

export type LoadedWind =
  | { readonly wind: Wind; readonly recordFile: string | null; readonly faults?: undefined }
  | { readonly wind?: undefined; readonly recordFile?: undefined; readonly faults: readonly Fault[] };

/** The wind of a file with the record of the CSV file that it names; faults of the CSV have its name before their path. */
export function parseWindWithRecord(file: unknown, recordText: (recordFile: string) => string): LoadedWind {
  const parsed = parseWind(file);
  if (!parsed.wind || parsed.recordFile === null) return parsed;
  const { wind, recordFile } = parsed;
  const { record, faults } = parseAnemometer(recordText(recordFile), { name: wind.name });
  if (record) return { wind: { ...wind, record }, recordFile };
  return { faults: faults.map((fault) => ({ ...fault, path: `${recordFile}${fault.path && `, ${fault.path}`}` })) };
}
