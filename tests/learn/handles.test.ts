import { expect, test } from 'vitest';
import { parseSpecies } from '../../src/core/species/parse.ts';
import { allowed, defaultsOf, type Value, type Values } from '../../src/learn/controls.ts';
import type { Colours, FigureHost, FigureSpec, Handle } from '../../src/learn/figure.ts';
import { pressed } from '../../src/learn/handle.ts';
import { NOISE_FIGURE } from '../../src/learn/how-fast/figure-noise.ts';
import { QUEUE_FIGURE } from '../../src/learn/how-fast/figure-queue.ts';
import { attachment } from '../../src/learn/ping-pong/attachment.ts';
import { bending } from '../../src/learn/ping-pong/bending.ts';
import { lagged } from '../../src/learn/ping-pong/lagged.ts';
import { passes } from '../../src/learn/ping-pong/passes.ts';
import { hillside } from '../../src/learn/range/hillside.ts';
import { prefix } from '../../src/learn/range/prefix.ts';
import { rules } from '../../src/learn/range/rules.ts';
import { sharpness } from '../../src/learn/sum-of-sines/sharpness.ts';
import { spectrum } from '../../src/learn/sum-of-sines/spectrum.ts';
import { upwind } from '../../src/learn/sum-of-sines/upwind.ts';
import { attraction } from '../../src/learn/weber-penn/attraction.ts';
import { children } from '../../src/learn/weber-penn/children.ts';
import { curve } from '../../src/learn/weber-penn/curve.ts';
import { leaves } from '../../src/learn/weber-penn/leaves.ts';
import { parts } from '../../src/learn/weber-penn/parts.ts';
import { pruning } from '../../src/learn/weber-penn/pruning.ts';
import { radius } from '../../src/learn/weber-penn/radius.ts';
import { shapes } from '../../src/learn/weber-penn/shapes.ts';
import { splits } from '../../src/learn/weber-penn/splits.ts';
import { natural } from '../../src/learn/wind-models/natural.ts';
import { resonance } from '../../src/learn/wind-models/resonance.ts';
import { step } from '../../src/learn/wind-models/step.ts';
import { sway } from '../../src/learn/wind-models/sway.ts';
import { three } from '../../src/learn/wind-models/three.ts';
import { textOf } from '../house/tree-files.ts';

const aspen = parseSpecies(textOf('public/species/quaking-aspen.json')).species!;

/** A context that takes every stroke and keeps none. */
const blind = (): CanvasRenderingContext2D =>
  new Proxy({} as CanvasRenderingContext2D, {
    get: (kept, name) =>
      Reflect.get(kept, name) ??
      (name === 'measureText' ? () => ({ actualBoundingBoxLeft: 0, actualBoundingBoxRight: 0 }) : () => blind()),
  });

/** A figure as in its page, without the page. */
function mounted({ controls, dragged = [], stage, begin = 0 }: FigureSpec) {
  const kept = [...controls, ...dragged];
  let values: Values = defaultsOf(kept);
  let drawn = false;
  const context = blind();
  const host: FigureHost = {
    canvas: { getContext: () => context, dataset: {}, addEventListener: () => {} } as unknown as HTMLCanvasElement,
    size: { width: 760, height: 500 },
    pixelRatio: 1,
    dark: false,
    // As in a drag, once all is laid out.
    get held() {
      return drawn;
    },
    values: () => values,
    set(id: string, value: Value) {
      const control = kept.find((each) => each.id === id);
      if (!control) throw new Error(`no value '${id}'`);
      const next = allowed(control, value);
      if (next !== undefined && next !== values[id]) values = { ...values, [id]: next };
    },
    redraw: () => {},
    colours: () => new Proxy({}, { get: () => '#000' }) as Colours,
  };
  const shown = stage(host);
  const handles = (): readonly Handle[] => {
    shown.draw(values, begin);
    drawn = true;
    return shown.handles?.(values) ?? [];
  };
  return {
    kept,
    handles,
    state: () => values,
    restore(before: Values) {
      values = before;
    },
  };
}

/** All that are drawn on paper alone: no scene, and no picture made of pixels. */
const FIGURES: readonly FigureSpec[] = [
  ...[parts, splits, shapes, children, leaves, pruning].map((of) => of(aspen)),
  ...[curve, radius, attraction],
  ...[upwind, sharpness, spectrum],
  ...[attachment, bending, lagged, passes],
  ...[three, sway, step, natural, resonance],
  ...[rules, prefix(aspen), hillside],
  ...[QUEUE_FIGURE, NOISE_FIGURE],
];

test.each(FIGURES.map((spec) => [spec.id, spec] as const))(
  'what is dragged in figure %s stays where it is let go, and each arrow key that has room moves it',
  (_, spec) => {
    const { kept, handles, state, restore } = mounted(spec);
    const first = handles();
    expect(first.length).toBeGreaterThan(0);
    for (const { id, ways = 'both', ...rest } of first) {
      const now = (): Handle => handles().find((each) => each.id === id)!;
      const before = state();
      rest.move(rest.x, rest.y);
      // Taken and let go where it is, it moves nothing by more than a step.
      for (const control of kept)
        if ('min' in control)
          expect(Math.abs(Number(state()[control.id]) - Number(before[control.id]))).toBeLessThan(1.01 * control.step);
      restore(before);
      const keys = [
        ...(ways === 'up' ? [] : (['ArrowLeft', 'ArrowRight'] as const)),
        ...(ways === 'across' ? [] : (['ArrowUp', 'ArrowDown'] as const)),
      ];
      let moved = 0;
      for (const key of keys) {
        restore(before);
        const { x, y } = now();
        pressed(now(), key, 1, state);
        if (state() === before) continue;
        const after = now();
        const [dx, dy] = [after.x - x, after.y - y];
        const [way, aside] = key === 'ArrowLeft' || key === 'ArrowRight' ? [dx, dy] : [dy, dx];
        if (!rest.turn) expect(Math.sign(way), `${id} ${key}`).toBe(key === 'ArrowLeft' || key === 'ArrowUp' ? -1 : 1);
        expect(Math.hypot(way, aside), `${id} ${key}`).toBeGreaterThan(0.1);
        moved++;
      }
      expect(moved, id).toBeGreaterThan(0);
      restore(before);
    }
  },
);
