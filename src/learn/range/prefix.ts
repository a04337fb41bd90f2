import { grow } from '../../core/grow/grow.ts';
import type { Tree } from '../../core/grow/tree.ts';
import { massesDrawn } from '../../core/lod/masses.ts';
import { spreadOrder } from '../../core/pack/spread.ts';
import type { Species } from '../../core/species/species.ts';
import { type FigureHost, type FigureSpec, numberOf, type Values } from '../figure.ts';
import { PlaneFigure } from '../plane-figure.ts';

/** A mass of the middle picture; the paper takes 4 of leaves, more show better what a mass is. */
const MASS = 16;

const SEED = 4;

/** Pixels below the trees: their names, and the bar of all leaves. */
const BELOW = 84;
const BAR = 40;

/** Where every leaf of a tree is, seen from the side: x, z. */
function leafPlaces({ stems, leaves }: Tree): Float32Array {
  const places = new Float32Array(2 * leaves.count);
  for (let i = 0; i < leaves.count; i++) {
    const stem = leaves.stem[i] as number;
    const [first, end] = [stems.nodeStart[stem] as number, stems.nodeStart[stem + 1] as number];
    const along = Math.min(0.999999, Math.max(0, leaves.z[i] as number)) * (end - 1 - first);
    const node = first + Math.floor(along);
    const part = along - Math.floor(along);
    const at = (k: number): number =>
      (1 - part) * (stems.nodePosition[3 * node + k] as number) +
      part * (stems.nodePosition[3 * node + 3 + k] as number);
    places[2 * i] = at(0);
    places[2 * i + 1] = at(2);
  }
  return places;
}

class Prefix extends PlaneFigure {
  readonly #places: Float32Array;
  readonly #order: Uint32Array;

  constructor(host: FigureHost, aspen: Species) {
    super(host);
    this.#places = leafPlaces(grow(aspen, SEED));
    this.#order = spreadOrder(this.#places.length / 2);
  }

  draw(values: Values): Record<string, string> {
    const c = this.host.colours();
    const p = this.plane;
    const { width } = this.host.size;
    const part = numberOf(values, 'part') / 100;
    const all = this.#places.length / 2;
    const wanted = Math.round(part * all);
    // The paper's loop: of each mass the first so many.
    const each = MASS * part;
    const taken = new Uint8Array(all);
    let masses = 0;
    for (let i = 0; i < all && masses < massesDrawn(all, MASS, each); i++) {
      if (i % MASS < Math.floor(each) || (i % MASS === Math.floor(each) && i / MASS < (each % 1) * (all / MASS))) {
        taken[i] = 1;
        masses++;
      }
    }
    const mine = new Uint8Array(all);
    for (let k = 0; k < wanted; k++) mine[this.#order[k] as number] = 1;
    const panels: readonly [string, (i: number) => boolean][] = [
      ['as they grew', (i) => i < wanted],
      ['masses', (i) => taken[i] === 1],
      ['ours', (i) => mine[i] === 1],
    ];
    panels.forEach(([name, shows], column) => {
      p.begin(
        {
          x: [-4.4, 4.4],
          y: [4, 16.5],
          equal: true,
          margin: { left: 4 + (column * width) / 3, right: 4 + ((2 - column) * width) / 3, top: 8, bottom: BELOW },
        },
        { keep: column > 0 },
      );
      const { context } = p;
      const grown = numberOf(values, 'size');
      // Those that are left grow, so that they cover what all did.
      const size = Math.max(1, 0.12 * p.scale[0] * (1 + grown * (1 / Math.sqrt(Math.max(part, 1e-3)) - 1)));
      context.fillStyle = c.answer;
      context.globalAlpha = 0.55;
      for (let i = 0; i < all; i++) {
        if (!shows(i)) continue;
        const [x, y] = p.toPixel(this.#places[2 * i] as number, this.#places[2 * i + 1] as number);
        context.fillRect(x - size / 2, y - size / 2, size, size);
      }
      context.globalAlpha = 1;
      p.text([0, p.y[0]], name, { align: 'center', baseline: 'top', shift: [0, 6] });
    });
    this.#bar(part);
    return { drawn: wanted.toLocaleString('en'), all: all.toLocaleString('en') };
  }

  handles(values: Values) {
    const part = numberOf(values, 'part');
    return [
      this.plane.handle({
        id: 'part',
        label: 'Leaves drawn',
        at: [part, 0],
        ways: 'across',
        colour: this.host.colours().answer,
        said: `${part} per cent of all`,
        move: (x) => this.host.set('part', x),
      }),
    ];
  }

  /** All leaves as a bar below the trees, in per cent, as far as they are drawn. */
  #bar(part: number): void {
    const { soft, line, answer } = this.host.colours();
    const p = this.plane;
    const top = this.host.size.height - BAR;
    p.begin({ x: [0, 100], y: [-1, 1], margin: { left: 28, right: 28, top, bottom: BAR - 20 } }, { keep: true });
    p.line([0, 0], [100, 0], { colour: line, width: 5 });
    p.line([0, 0], [100 * part, 0], { colour: answer, width: 5 });
    const beneath = { colour: soft, size: 12, baseline: 'top', shift: [0, 10] } as const;
    p.text([0, 0], 'no leaf', { ...beneath, align: 'left' });
    p.text([100, 0], 'all leaves', { ...beneath, align: 'right' });
  }

  text(values: Values): string {
    return `${numberOf(values, 'part')} per cent of an aspen's leaves in three orders: as they grew they cover one side of the crown, in the others all of it.`;
  }
}

/** Any first part of the draw order is spread evenly. */
export const prefix = (aspen: Species): FigureSpec => ({
  id: 'prefix',
  title: 'The first so many',
  aspect: 1.55,
  controls: [
    { id: 'part', label: 'Drawn', unit: '%', min: 1, max: 100, step: 1, value: 25 },
    { id: 'size', label: 'The rest grows to cover as much', min: 0, max: 1, step: 0.05, value: 0 },
  ],
  readouts: [
    { id: 'drawn', label: 'Leaves drawn' },
    { id: 'all', label: 'Of' },
  ],
  open: () => `s=quaking-aspen&seed=${SEED}&blow=0`,
  stage: (host) => new Prefix(host, aspen),
});
