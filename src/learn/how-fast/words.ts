import type { Kind } from './measured.ts';

const grouped = (x: number): string => String(x).replace(/\B(?=(\d{3})+$)/g, '\u202f');

/** What the measuring part of the lesson says. */
export const words = {
  start: 'Measure this machine',
  again: 'Measure again',
  stop: 'Stop',
  csv: 'Download CSV',
  idle: 'Nothing is measured yet. It takes about twenty seconds with a graphics card and a minute or two without.',
  doing: (kind: Kind, size: number) =>
    kind === 'frames' ? `Drawing ${grouped(size)} vertices …` : `Blowing through ${grouped(size)} branches …`,
  stopped: 'Stopped. What was measured until then stands below.',
  done: (seconds: number) => `Done in ${seconds.toFixed(0)} seconds.`,
  failed: (why: string) => `It did not work: ${why}`,
  noContext: 'this browser gives no WebGL2 context, so there is nothing to measure.',
  noTargets: 'Its graphics cannot write the textures of the wind: the steps are left out.',
  renderer: (name: string) => `Measured on: ${name}`,
  table: 'What your machine does',
  columns: ['what', 'size', 'milliseconds', 'a second', 'median / least'],
  kinds: { frames: 'frame, vertices', steps: 'wind step, branches' } satisfies Record<Kind, string>,
  skipped: (seconds: number) =>
    `left out: it would take about ${seconds < 10 ? seconds.toFixed(1) : seconds.toFixed(0)} s each`,
  size: grouped,
};
