import { combine, hashUnit } from '../src/core/math/hash.ts';
import { createWindState, windStateAt } from '../src/core/wind/fade.ts';
import { windForce } from '../src/core/wind/force.ts';
import type { Wind } from '../src/core/wind/wind.ts';

/** Size in pixels; the field takes the upper part, a metre a pixel, and what the tree feels over time the lower. */
const WIDTH = 72;
const HEIGHT = 48;
const FIELD = 34;
/** Seconds of the lower part. */
const SECONDS = 40;
/** Height at which the wind is drawn: that of a crown. */
const CROWN = 8;

const COLUMNS = 9;
const ROWS = 5;

const digits = (value: number): string => String(Number(value.toFixed(1)));

/** Length in pixels of a streak of this force in metres: a light air has to be seen beside a storm. */
const lengthOf = (force: number): number => 18 * force ** 0.6;

/** The wind's own force at a place of the picture (metres from the tree, y up) and a time. */
function fieldOf(wind: Wind): (x: number, y: number, time: number) => [number, number] {
  const state = createWindState();
  let filled = Number.NaN;
  return (x, y, time) => {
    if (time !== filled) windStateAt(wind, time, undefined, state);
    filled = time;
    return windForce(state, x, y, CROWN);
  };
}

type Field = ReturnType<typeof fieldOf>;

/** Where streaks start: a grid, shaken so that no rows are seen. */
const places = Array.from({ length: COLUMNS * ROWS }, (_, i) => {
  const shaken = (name: number): number => 0.2 + 0.6 * hashUnit(combine(i, name));
  return {
    i,
    x: (((i % COLUMNS) + shaken(1)) / COLUMNS - 0.5) * WIDTH,
    y: ((Math.floor(i / COLUMNS) + shaken(2)) / ROWS - 0.5) * FIELD,
  };
});

/** The time at which the field differs most from place to place: a front is then in the picture. */
function tellingTime(field: Field): number {
  let best = { time: 0, spread: -1 };
  for (let time = 0; time < SECONDS; time += 0.5) {
    const forces = places.map(({ x, y }) => Math.hypot(...field(x, y, time)));
    const mean = forces.reduce((sum, f) => sum + f, 0) / forces.length;
    const spread = forces.reduce((sum, f) => sum + (f - mean) ** 2, 0);
    if (spread > best.spread) best = { time, spread };
  }
  return best.time;
}

const toPicture = (x: number, y: number): string => `${digits(WIDTH / 2 + x)} ${digits(FIELD / 2 - y)}`;

/** A line along the wind through a place, as long and as bold as the wind is strong there. */
function streak(field: Field, time: number, { x, y }: { x: number; y: number }): string {
  const [fx, fy] = field(x, y, time);
  const force = Math.hypot(fx, fy);
  const length = lengthOf(force);
  const steps = 4;
  let at = { x, y };
  const points = [toPicture(x, y)];
  for (let i = 0; i < steps && length > 0.5; i++) {
    const [dx, dy] = field(at.x, at.y, time);
    const f = Math.hypot(dx, dy) || 1;
    at = { x: at.x + (dx / f) * (length / steps), y: at.y + (dy / f) * (length / steps) };
    points.push(toPicture(at.x, at.y));
  }
  return line(points, 0.9 + 0.7 * force, 0.5 + Math.min(0.5, 0.8 * force));
}

/** A stem that nods as Weber & Penn's do: two sines of its own. */
function stalk({ sway }: Wind, { i, x, y }: { i: number; x: number; y: number }): string {
  const turns = hashUnit(combine(i, 3));
  const lean =
    (0.02 * sway.speed * Math.sin(2 * Math.PI * turns) + 0.04 * sway.gust * Math.sin(1.4 * Math.PI * turns)) * 3;
  const points = [toPicture(x, y - 3), toPicture(x + lean, y), toPicture(x + 3 * lean, y + 3)];
  return line(points, 1, 0.7);
}

const line = (points: readonly string[], width: number, opacity: number): string =>
  points.length === 1
    ? `<path d="M${points[0]}h0" stroke-width="1.2" opacity="0.4"/>`
    : `<path d="M${points[0]}L${points.slice(1).join(' ')}" stroke-width="${digits(width)}" opacity="${digits(opacity)}"/>`;

/** What the tree feels over time, as a line above a ground line. */
function trace(field: Field): string {
  const [low, high] = [HEIGHT - 1.5, FIELD + 1];
  const points = Array.from({ length: WIDTH - 1 }, (_, i) => {
    const force = Math.hypot(...field(0, 0, (i / (WIDTH - 2)) * SECONDS));
    return `${i + 1 - 0.5} ${digits(low - (low - high) * Math.min(1, Math.sqrt(force / 1.6)))}`;
  });
  return `<path d="M0.5 ${low}H${WIDTH - 0.5}" stroke-width="0.5" opacity="0.4"/><path d="M${points[0]}L${points.slice(1).join(' ')}" stroke-width="1"/>`;
}

/** A small picture of a wind as SVG, drawn from its own field: streaks over the meadow from above, and 40 seconds at the tree. */
export function windThumbnail(wind: Wind): string {
  const field = fieldOf(wind);
  const time = tellingTime(field);
  const marks = places.map((place) => (wind.model === 'sway' ? stalk(wind, place) : streak(field, time, place)));
  // The blue of the force (art direction), by the theme of the page around; whoever draws it inline gives its own colour.
  const style = ':root{color:#1f6feb}@media(prefers-color-scheme:dark){:root{color:#6cb2ff}}';
  return [
    `<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 ${WIDTH} ${HEIGHT}" fill="none" stroke="currentColor" stroke-linecap="round" stroke-linejoin="round">`,
    `<style>${style}</style>`,
    ...marks,
    trace(field),
    '</svg>',
    '',
  ].join('\n');
}
