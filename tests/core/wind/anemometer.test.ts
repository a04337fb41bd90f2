import fc from 'fast-check';
import { describe, expect, test } from 'vitest';
import { faultText } from '../../../src/core/file/fault.ts';
import { blowsTo, comesFrom, parseAnemometer } from '../../../src/core/wind/anemometer.ts';
import { stampSeconds } from '../../../src/core/wind/anemometer-cells.ts';
import { recordCsv } from '../../../src/core/wind/record-csv.ts';

const lines = (...rows: string[]): string => `${rows.join('\n')}\n`;
const read = (text: string) => {
  const { record, notes, faults } = parseAnemometer(text, { name: 'mast' });
  if (!record) throw new Error(faults.map(faultText).join('\n'));
  return { record, notes };
};
const faultsOf = (text: string): string[] => (parseAnemometer(text, { name: 'mast' }).faults ?? []).map(faultText);
const speeds = (text: string): number[] => read(text).record.speed;
const HEAD = 'time (s),speed (m/s),direction (deg)';

describe('the wind comes from where meteorologists say, and blows towards where trees lean', () => {
  test.each([
    [270, 0, 'a west wind blows to the east, x'],
    [180, 90, 'a south wind blows to the north, y'],
    [90, 180, 'an east wind blows to the west'],
    [0, 270, 'a north wind blows to the south'],
    [225, 45, 'a south-west wind blows to the north-east'],
  ])('%d degrees: %d, %s', (from, towards) => {
    const radians = blowsTo(from);
    expect(Math.cos(radians)).toBeCloseTo(Math.cos((towards * Math.PI) / 180), 12);
    expect(Math.sin(radians)).toBeCloseTo(Math.sin((towards * Math.PI) / 180), 12);
    expect(comesFrom(radians)).toBeCloseTo(from, 9);
  });
});

test('a plain file: seconds, metres a second, degrees', () => {
  const { record, notes } = read(lines(HEAD, '0,4,270', '0.5,5.5,180', '1,3,270'));
  expect(notes).toEqual([]);
  expect(record).toEqual({ name: 'mast', step: 0.5, speed: [4, 5.5, 3], direction: [0, Math.PI / 2, 0] });
});

describe('headers', () => {
  test.each([
    ['t,v', [10]],
    ['Time [s],Wind speed [m/s]', [10]],
    ['seconds,speed_ms', [10]],
    ['timestamp,wind_speed_kmh', [10 / 3.6]],
    ['time,WindSpeed (km/h)', [10 / 3.6]],
    ['time,Speed (knots)', [(10 * 1852) / 3600]],
    ['time,ws_kt', [(10 * 1852) / 3600]],
    ['time,speed mph', [4.4704]],
    ['time (min),speed (m/s)', [10, 60]],
    ['time_ms,u', [10, 0.1]],
  ])('%s', (header, [speed, step = 1]) => {
    const times = header.includes('_ms,u') ? [0, 100] : [0, 1];
    const { record } = read(lines(header, `${times[0]},10`, `${times[1]},10`));
    expect(record.speed[0]).toBeCloseTo(speed, 9);
    expect(record.step).toBeCloseTo(step, 9);
  });

  test('columns stand in any order; gusts and temperatures beside them are left alone', () => {
    const text = lines(
      'T (C);gust speed (m/s);wind direction (°);wind speed (m/s);Date',
      '9;12;270;4;2024-05-31T12:00:00Z',
      '9;13;270;5;2024-05-31T12:00:01Z',
    );
    expect(read(text).record).toMatchObject({ step: 1, speed: [4, 5], direction: [0, 0] });
  });

  test('what is taken for granted is told', () => {
    const { record, notes } = read(lines('time,speed', '0,4', '1,5'));
    expect(record.direction).toEqual([0, 0]);
    expect(notes).toEqual([
      'The header gives no unit of the speed: taken as metres a second.',
      'There is no column of directions: all of it blows the same way.',
    ]);
    const options = { name: 'mast', direction: 1 };
    expect(parseAnemometer(lines('t (s),v (m/s)', '0,4', '1,5'), options).record?.direction).toEqual([1, 1]);
  });

  test.each([
    [
      '0,4\n1,5\n',
      [
        'line 1: found the header "0, 4"; allowed: a column of times',
        'line 1: found the header "0, 4"; allowed: a column of speeds',
      ],
    ],
    [
      '\n# remark\ntime (s),sped\n0,4\n',
      ['line 3: found the header "time (s), sped"; allowed: a column of speeds, headed as "speed (m/s)"'],
    ],
    ['# nothing but this\n', ['The file: found nothing but empty lines and remarks; allowed: ']],
    ['', ['The file: found an empty file; allowed: ']],
  ])('%j', (text, expected) => {
    expect(faultsOf(text)).toEqual(expected.map((start) => expect.stringContaining(start)));
  });
});

describe('separators and decimals', () => {
  const expected = { step: 0.2, speed: [4.25, 5.5] };
  test.each([
    ['commas', lines(HEAD, '0,4.25,270', '0.2,5.5,270')],
    ['semicolons and decimal commas', lines('time (s);speed (m/s);direction (deg)', '0;4,25;270', '0,2;5,5;270')],
    ['tabs', lines('time (s)\tspeed (m/s)', '0\t4.25', '0,2\t5,5')],
    ['quotes around decimal commas', lines(HEAD, '"0","4,25",270', '"0,2","5,5",270')],
    ['Windows line ends and a byte order mark', `\ufeff${HEAD}\r\n0,4.25,270\r\n0.2,5.5,270\r\n`],
    ['remarks and empty lines', lines('# mast 4', '', HEAD, '0,4.25,270', '', '# noon', '0.2,5.5,270', '')],
  ])('%s', (_, text) => {
    expect(read(text).record).toMatchObject(expected);
  });

  test('decimal commas between commas are a fault that says what to do', () => {
    expect(faultsOf(lines('time (s),speed (m/s)', '0,4,25', '0,2,5,5'))).toEqual([
      'line 2: found 3 values; allowed: 2, as the header has; numbers with decimal commas need semicolons or tabs between them.',
      'line 3: found 4 values; allowed: 2, as the header has; numbers with decimal commas need semicolons or tabs between them.',
    ]);
  });
});

describe('time stamps', () => {
  test('are the same wherever they are read, and count leap days and zones', () => {
    const seconds = (a: string, b: string): number => stampSeconds(b)! - stampSeconds(a)!;
    expect(seconds('2024-02-28T23:59:59.5Z', '2024-03-01T00:00:00Z')).toBe(86_400.5);
    expect(seconds('2023-02-28 23:59', '2023-03-01 00:00')).toBe(60);
    expect(seconds('1999-12-31T23:59:59Z', '2000-01-01T00:00:00,250Z')).toBe(1.25);
    expect(seconds('2024-05-31T12:00:00+02:00', '2024-05-31T12:00:00Z')).toBe(7200);
    expect(seconds('2024-05-31T12:00:00-0330', '2024-05-31T12:00:00')).toBe(-12_600);
    for (const wrong of ['2024-13-01T00:00', '31.05.2024 12:00', '2024-05-31', '12:00', ''])
      expect(stampSeconds(wrong)).toBeUndefined();
  });

  test('agree with those of the engine', () => {
    const range = { min: new Date('1900-01-01T00:00:00Z'), max: new Date('2199-12-31T00:00:00Z'), noInvalidDate: true };
    fc.assert(
      fc.property(fc.date(range), (date) => {
        const epoch = Date.UTC(2000, 0, 1);
        expect(stampSeconds(date.toISOString())).toBeCloseTo((date.getTime() - epoch) / 1000, 3);
      }),
    );
  });

  test('make steps, with their fractions', () => {
    const text = lines(
      'timestamp,speed (m/s)',
      '2024-05-31T23:59:59.8Z,4',
      '2024-06-01T00:00:00.0Z,5',
      '2024-06-01T00:00:00.2Z,6',
    );
    expect(read(text).record).toMatchObject({ step: 0.2, speed: [4, 5, 6] });
  });

  test('must not be mixed with seconds', () => {
    expect(faultsOf(lines('time,speed', '2024-05-31T12:00:00,4', '1,5'))).toEqual([
      'line 3, time: found the text "1"; allowed: a time stamp as 2024-05-31T12:00:00.2.',
    ]);
    expect(faultsOf(lines('time,speed', '0,4', '12:00,5'))).toEqual([
      'line 3, time: found the text "12:00"; allowed: a number of seconds, as 12.5.',
    ]);
  });
});

describe('gaps, missing values and uneven steps', () => {
  test('missing values are filled in and told by line; 999 seconds are none', () => {
    const rows = ['998,4,270', '999,NaN,270', '1000,6,', '1001,7,999', '1002,,', '1003,9,270'];
    const { record, notes } = read(lines(HEAD, ...rows));
    expect(record.speed).toEqual([4, 5, 6, 7, 8, 9]);
    expect(record.direction).toEqual([0, 0, 0, 0, 0, 0]);
    expect(notes).toEqual([
      ...[3, 4, 5, 6].map((line) => `Line ${line} has no value: filled in between its neighbours.`),
    ]);
  });

  test('a vane in a calm has no direction and misses none', () => {
    const { record, notes } = read(lines(HEAD, '0,4,180', '1,0,', '2,3,270'));
    expect(record.direction).toEqual([Math.PI / 2, Math.PI / 2, 0]);
    expect(notes).toEqual([]);
  });

  test('directions turn by the shorter way through north', () => {
    const { record } = read(lines(HEAD, '0,4,350', '2,4,10', '3,4,10', '4,4,30'));
    expect(record.direction.map((d) => Math.round(comesFrom(d)) % 360)).toEqual([350, 0, 10, 10, 30]);
  });

  test('uneven steps are resampled to the usual one', () => {
    const { record, notes } = read(
      lines('time (s),speed (m/s),direction', '0,0,270', '1,1,270', '2.5,2.5,270', '3,3,270', '4,4,270', '5,5,270'),
    );
    expect(record).toMatchObject({ step: 1, speed: [0, 1, 2, 3, 4, 5] });
    expect(notes).toEqual(['Its steps are uneven: resampled to one of 1 seconds.']);
  });

  test('a long gap is a fault', () => {
    expect(faultsOf(lines('time,speed', '0,4', '1,4', '2,4', '95,4'))).toEqual([
      'line 5, time: found a gap of 93 seconds; allowed: at most 10 seconds from sample to sample.',
    ]);
    expect(read(lines('time,speed', '0,4', '60,4', '120,4', '700,4')).record.speed).toHaveLength(12);
  });

  test('thousands of notes are a few and a number', () => {
    const rows = Array.from({ length: 101 }, (_, i) => `${i},${i % 2 ? '' : 3}`);
    const { notes, record } = read(lines('time (s),speed (m/s)', ...rows));
    expect(record.speed).toHaveLength(101);
    expect(notes.filter((note) => note.startsWith('Line'))).toHaveLength(12);
    expect(notes).toContain('38 more lines like these.');
  });
});

describe('what is wrong in a line', () => {
  test.each([
    ['1,fast,270', 'line 3, speed: found the text "fast"; allowed: a number from 0 to 100, or nothing.'],
    ['1,-2,270', 'line 3, speed: found the text "-2"; allowed: a number from 0 to 100, or nothing.'],
    ['1,140,270', 'line 3, speed: found the text "140"; allowed: a number from 0 to 100, or nothing.'],
    ['1,4,NW', 'line 3, direction: found the text "NW"; allowed: a number from -360 to 360 degrees, or nothing.'],
    ['1,4,400', 'line 3, direction: found the text "400"; allowed: a number from -360 to 360 degrees, or nothing.'],
    ['noon,4,270', 'line 3, time: found the text "noon"; allowed: a number of seconds, as 12.5.'],
    [',4,270', 'line 3, time: found the text ""; allowed: a number of seconds, as 12.5.'],
    ['0,4,270', 'line 3, time: found the text "0"; allowed: a time after that of the line before.'],
  ])('%s', (row, fault) => {
    expect(faultsOf(lines(HEAD, '0,4,270', row, '2,4,270'))).toEqual([fault]);
  });

  test('a line number counts empty lines, remarks and lines within quotes', () => {
    expect(faultsOf(lines('# a', '', 'time,speed,note', '0,4,"two', 'lines"', '1,x,'))).toEqual([
      expect.stringMatching(/^line 6, speed: found the text "x"/),
    ]);
  });

  test('of hundreds of faults forty are listed', () => {
    expect(faultsOf(lines('time,speed', ...Array.from({ length: 300 }, (_, i) => `${i},?x`)))).toHaveLength(40);
  });

  test.each([
    [lines('time,speed', '0,4'), 'The file: found 1 samples; allowed: at least 2.'],
    [
      lines('time,speed', '0,4', '0.001,4'),
      'time: found a step of 0.001 seconds; allowed: a step from 0.01 to 600 seconds.',
    ],
    [
      lines('time,speed', ...Array.from({ length: 36_001 }, (_, i) => `${i},4`)),
      'The file: found 36001 samples; allowed: at most 36000: a shorter part, or averages over a longer step.',
    ],
  ])('%.30j', (text, fault) => {
    expect(faultsOf(text)).toEqual([fault]);
  });
});

test('a record written as CSV reads back', () => {
  const record = {
    name: 'mast',
    step: 0.25,
    speed: [0, 4.25, 31.5],
    direction: [0, 90, -135].map((d) => (d * Math.PI) / 180),
  };
  const { record: again, notes } = read(recordCsv(record, ['a remark']));
  expect(notes).toEqual([]);
  expect(again).toMatchObject({ name: 'mast', step: 0.25, speed: record.speed });
  again.direction.forEach((d, i) => {
    expect(Math.cos(d - record.direction[i])).toBeCloseTo(1, 9);
  });
});

test('no input makes it throw, and no record has a hole', () => {
  const cell = fc.oneof(
    fc.integer({ min: -5, max: 30 }).map(String),
    fc.constantFrom('', 'NaN', '4,5', '"', '2024-05-31T12:00:00', '#', '\r'),
  );
  const row = fc.array(cell, { maxLength: 4 }).map((cells) => cells.join(','));
  fc.assert(
    fc.property(fc.array(row, { maxLength: 12 }), fc.constantFrom(`${HEAD}\n`, 't;v\n', ''), (rows, head) => {
      const { record } = parseAnemometer(head + rows.join('\n'), { name: 'mast' });
      for (const values of record ? [record.speed, record.direction] : []) {
        expect(values.length).toBeGreaterThan(1);
        expect(values.every(Number.isFinite)).toBe(true);
      }
    }),
    { numRuns: 500 },
  );
  expect(speeds(lines(HEAD, '0,4,270', '1,4,270'))).toEqual([4, 4]);
});
