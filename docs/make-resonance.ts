// `npx tsx docs/make-resonance.ts`: docs/resonance.svg, how the springs of the wind pass answer a sine of every frequency (dots, the
// steps themselves) beside the theory of the damped oscillator (lines). Prints the largest difference.
import { writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { measuredResponse, springResponse } from '../src/core/wind/spring-response.ts';

/** A branch of the aspen: 0.5 Hz is its trunk. */
const HERTZ = 0.5;
const OMEGA = 2 * Math.PI * HERTZ;
const DAMPINGS = [
  { ratio: 0.06, dash: '' },
  { ratio: 0.12, dash: '7 3' },
  { ratio: 0.3, dash: '2 3' },
];
const [LOW, HIGH] = [0.1, 2];
const DOTS = 25;

const frequencies = (count: number): number[] =>
  Array.from({ length: count }, (_, i) => LOW * (HIGH / LOW) ** (i / (count - 1)));

const width = 720;
const left = 64;
const right = 16;
const plots = [
  {
    top: 64,
    height: 204,
    low: 0,
    high: 9,
    ticks: [0, 1, 3, 5, 7, 9],
    label: 'bend, of that in steady wind',
    of: 'amplitude',
  },
  { top: 308, height: 130, low: -180, high: 0, ticks: [0, -45, -90, -135, -180], label: 'phase, degrees', of: 'phase' },
] as const;
const height = 500;

const x = (hertz: number): number => left + ((width - left - right) * Math.log(hertz / LOW)) / Math.log(HIGH / LOW);
const shown = (response: { amplitude: number; phase: number }, of: 'amplitude' | 'phase'): number =>
  of === 'amplitude' ? response.amplitude : (response.phase * 180) / Math.PI;
/** Least squares give a phase within half a turn either way; this one always lags. */
const lagging = (degrees: number): number => (degrees > 1 ? degrees - 360 : degrees);

let worst = 0;
const parts: string[] = [];
for (const plot of plots) {
  const y = (value: number): number => plot.top + plot.height * (1 - (value - plot.low) / (plot.high - plot.low));
  for (const tick of plot.ticks) {
    parts.push(`<path class="grid" d="M${left},${y(tick)}H${width - right}"/>`);
    parts.push(
      `<text class="tick" x="${left - 8}" y="${y(tick) + 4}" text-anchor="end">${String(tick).replace('-', '−')}</text>`,
    );
  }
  for (const hertz of [0.1, 0.2, 0.5, 1, 2]) {
    parts.push(`<path class="grid" d="M${x(hertz)},${plot.top}V${plot.top + plot.height}"/>`);
  }
  parts.push(`<text class="name" x="${left}" y="${plot.top - 10}">${plot.label}</text>`);
  for (const { ratio, dash } of DAMPINGS) {
    const line = frequencies(240).map(
      (f) => `${x(f).toFixed(1)},${y(shown(springResponse(OMEGA, ratio, f), plot.of)).toFixed(1)}`,
    );
    parts.push(`<path class="theory" stroke-dasharray="${dash}" d="M${line.join(' ')}"/>`);
    for (const f of frequencies(DOTS)) {
      const measured = measuredResponse(OMEGA, ratio, f);
      const theory = springResponse(OMEGA, ratio, f);
      worst = Math.max(worst, Math.abs(measured.amplitude / theory.amplitude - 1));
      const value = plot.of === 'phase' ? lagging(shown(measured, plot.of)) : shown(measured, plot.of);
      parts.push(`<circle cx="${x(f).toFixed(1)}" cy="${y(value).toFixed(1)}" r="2.6"/>`);
    }
    if (plot.of === 'amplitude') {
      const peak = y(springResponse(OMEGA, ratio, HERTZ).amplitude);
      // Beside its peak; the flat one has room beneath it alone.
      const place = ratio < 0.2 ? `x="${x(HERTZ) + 14}" y="${peak + 4}"` : `x="${x(HERTZ) - 8}" y="${peak + 24}"`;
      parts.push(`<text class="tick" ${place} ${ratio < 0.2 ? '' : 'text-anchor="end"'}>damping ${ratio}</text>`);
    }
  }
}
for (const hertz of [0.1, 0.2, 0.5, 1, 2]) {
  parts.push(`<text class="tick" x="${x(hertz)}" y="458" text-anchor="middle">${hertz}</text>`);
}
parts.push(
  `<text class="name" x="${x(HIGH)}" y="480" text-anchor="end">frequency of the wind, hertz (natural: ${HERTZ})</text>`,
);

const svg = `<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 ${width} ${height}" role="img" aria-label="Resonance of a branch: measured dots lie on the lines of theory">
<style>
  .paper { fill: #fbfaf6 } text { font: 12px system-ui, sans-serif; fill: #1d2021 } .name { font-weight: 600 }
  .grid { stroke: #1d202118; fill: none } .theory { stroke: #6e7781; stroke-width: 1.5; fill: none } circle { fill: #1a7f37 }
</style>
<rect class="paper" width="${width}" height="${height}"/>
<text class="name" x="${left}" y="20">A branch answers a sine of wind: lines are theory, dots the steps of 1/60 s</text>
${parts.join('\n')}
</svg>
`;
writeFileSync(join(import.meta.dirname, 'resonance.svg'), svg);
console.log(`docs/resonance.svg; measured amplitudes differ from the theory by ${(100 * worst).toFixed(2)} % at most`);
