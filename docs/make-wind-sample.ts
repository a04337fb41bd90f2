// npx tsx docs/make-wind-sample.ts: writes public/winds/kaimal-sample.csv, the wind that the preset "recorded" plays.
import { writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { blowsTo } from '../src/core/wind/anemometer.ts';
import { type KaimalWind, kaimalRecord } from '../src/core/wind/kaimal.ts';
import { recordCsv } from '../src/core/wind/record-csv.ts';

const MINUTES = 10;

/** A fresh, gusty west-south-west wind over fields, as a mast of ten metres measures it five times a second. */
const WIND: KaimalWind = {
  meanSpeed: 6.5,
  intensity: 0.28,
  height: 10,
  seconds: 60 * MINUTES,
  step: 0.2,
  seed: 1972,
  direction: blowsTo(255),
};

const csv = recordCsv(kaimalRecord(WIND), [
  'Synthetic wind with the Kaimal spectrum, made by docs/make-wind-sample.ts; not a measurement.',
  `Mean ${WIND.meanSpeed} m/s, turbulence intensity ${WIND.intensity}, height ${WIND.height} m, seed ${WIND.seed}.`,
  'The direction is the one that the wind comes from, clockwise from north.',
]);
writeFileSync(join(import.meta.dirname, '../public/winds/kaimal-sample.csv'), csv);
