import { comesFrom } from './anemometer.ts';
import type { WindRecord } from './wind.ts';

/**
 * The record as a CSV file that `parseAnemometer` reads: seconds, metres a second to the centimetre, and degrees clockwise from north that the
 * wind comes from, to the tenth. `remarks` stand behind # at its head.
 */
export function recordCsv({ step, speed, direction }: WindRecord, remarks: readonly string[] = []): string {
  const lines = speed.map((v, i) => {
    const from = Number(comesFrom(direction[i]).toFixed(1)) % 360;
    return `${Number((i * step).toFixed(3))},${Number(v.toFixed(2))},${from}`;
  });
  return `${[...remarks.map((remark) => `# ${remark}`), 'time (s),speed (m/s),direction (deg)', ...lines].join('\n')}\n`;
}
