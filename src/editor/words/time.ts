/** The time bar, and the loops that it makes. */
export const timeWords = {
  time: 'Time',
  timeNumber: 'Time, seconds',
  spoken: (seconds: number): string => `${seconds.toFixed(2)} seconds`,
  back: 'Step back',
  backTitle: 'One step of 1/60 s back',
  step: 'Single step',
  stepTitle: 'One step of 1/60 s',
  play: 'Play',
  pause: 'Pause',
  slow: '¼×, slow motion',
  slowTitle: 'Slow motion: a quarter of real time',
  speed: 'Speed',
  speedName: 'Speed of time',
  catching: 'The branches catch up',
  catchingUp: (part: number): string => `Branches catch up, ${Math.round(100 * part)} %`,
} as const;

export const loopWords = {
  loop: 'Loop',
  title: 'Make the wind come around every so many seconds',
  every: 'Make it loop every',
  make: 'Make loop',
  done: (change: number): string =>
    `Done: no wave became more than ${(100 * change).toFixed(change < 0.1 ? 1 : 0)} % faster or slower.`,
  seam: {
    gusts: 'It has a seam: there are more gusts than a loop can hold.',
    record: 'It has a seam: the measured wind is longer than the loop.',
    sway: 'It has a seam: the model sway has a period of its own, 4096 s.',
  },
  never: 'Now it does not come around within ten minutes.',
  still: 'Now nothing in it moves.',
  now: (seconds: number): string => `Now it comes around every ${seconds.toFixed(2)} s.`,
  how: 'Each wave’s speed is nudged until it makes whole turns; its crests stay where they are.',
} as const;

export const statisticsWords = {
  title: 'Statistics',
  height: 'Height',
  stems: 'Stems',
  pieces: 'Pieces',
  leaves: 'Leaves',
  triangles: 'Triangles',
  drawCalls: 'Draw calls',
  grow: 'Grow',
  wind: 'Wind pass',
  frame: 'Frame',
} as const;
