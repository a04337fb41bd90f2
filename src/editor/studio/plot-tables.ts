import type { NumberTable } from './csv.ts';
import { decibels, type SpectrumData, type TimeData } from './plot-data.ts';
import { FLOOR } from './spectrum-plot.ts';

/** What the plots over time and the phase portrait show. */
export const timeTable = (data: TimeData): NumberTable => ({
  name: 'probe',
  columns: [
    { name: 'time (s)', values: data.time },
    { name: 'force (m/s)', values: data.force },
    { name: 'force across (m/s)', values: data.forceAcross },
    { name: 'displacement along (m)', values: data.along },
    { name: 'displacement across (m)', values: data.across },
    { name: 'displacement up (m)', values: data.up },
    { name: 'velocity along (m/s)', values: data.velocityAlong },
    { name: 'velocity across (m/s)', values: data.velocityAcross },
  ],
});

/** What the spectrum shows, in decibels, and the densities that they are of. */
export const spectrumTable = (data: SpectrumData): NumberTable => ({
  name: 'spectrum',
  columns: [
    { name: 'frequency (Hz)', values: data.frequency },
    { name: 'force (dB below its peak)', values: decibels(data.force, FLOOR) },
    { name: 'displacement (dB below its peak)', values: decibels(data.displacement, FLOOR) },
    { name: 'force density ((m/s)^2/Hz)', values: data.force },
    { name: 'displacement density (m^2/Hz)', values: data.displacement },
  ],
});

/** Every `every`-th row, the last among them: a table that a person can read. */
export function thinned({ name, columns }: NumberTable, every: number): NumberTable {
  const pick = (values: Float64Array): Float64Array => {
    const first = (values.length - 1) % every;
    return values.filter((_, i) => i % every === first);
  };
  return { name, columns: columns.map((c) => ({ name: c.name, values: pick(c.values) })) };
}
