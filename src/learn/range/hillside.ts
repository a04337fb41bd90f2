import { calibratedRange } from '../../core/lod/calibrated-range.ts';
import { STEM_FORM } from '../../core/lod/draw-counts.ts';
import { fractions } from '../../core/lod/fractions.ts';
import { hashPcg, hashUnit } from '../../core/math/hash.ts';
import { type FigureSpec, numberOf, type Values } from '../figure.ts';
import { PlaneFigure } from '../plane-figure.ts';

/** Stems and leaves of the paper's aspen, as Table 2 tells them. */
const ASPEN = { main: 30, other: 739, leaves: 13_312 } as const;
const TRIANGLES_OF_LEAF = 4;
const FARTHEST = 1500;
/** Metres from the eye to where the edge of the view is taken hold of: there even the widest is on the sheet. */
const GRIP = 650;
/** A picture is so much wider than high. */
const WIDER = 16 / 9;
const DEGREES = 180 / Math.PI;

/** Half of the angle that a picture sees across, radians, by its field of view up and down, degrees; and back. */
const acrossOf = (fov: number): number => Math.atan(Math.tan(fov / 2 / DEGREES) * WIDER);
const fovOf = (across: number): number => 2 * DEGREES * Math.atan(Math.tan(across) / WIDER);

/** Triangles, lines and points of one aspen at a calibrated range. */
function elements(r2: number): number {
  const { trunk, main, other, leaves } = fractions(r2);
  const stems = (count: number, { lines, bands, sectors }: (typeof STEM_FORM)['main'], f: typeof main): number =>
    count * (2 * bands * sectors * f.polygons + lines * f.thin);
  return (
    stems(1, STEM_FORM.trunk, trunk) +
    stems(ASPEN.main, STEM_FORM.main, main) +
    stems(ASPEN.other, STEM_FORM.other, other) +
    ASPEN.leaves * (TRIANGLES_OF_LEAF * leaves.polygons + Math.max(leaves.thin, 1 / 8))
  );
}

class Hillside extends PlaneFigure {
  draw(values: Values): Record<string, string> {
    const c = this.host.colours();
    const p = this.plane;
    const [trees, fov, rows] = ['trees', 'fov', 'rows'].map((id) => numberOf(values, id)) as [number, number, number];
    p.begin({ x: [-60, FARTHEST], y: [-520, 520], equal: true });
    const half = acrossOf(fov);
    const [cos, sin] = [Math.cos(half), Math.sin(half)];
    for (const range of [100, 300, 800]) {
      const arc = Array.from({ length: 41 }, (_, i): readonly [number, number] => {
        const a = half * (i / 20 - 1);
        return [range * Math.cos(a), range * Math.sin(a)];
      });
      p.polyline(arc, { colour: c.line, width: 1, dash: [4, 4] });
    }
    for (const sign of [-1, 1]) p.line([0, 0], [FARTHEST * cos, sign * FARTHEST * sin], { colour: c.line, width: 1 });
    let drawn = 0;
    let near = 0;
    const full = elements(0);
    for (let i = 0; i < trees; i++) {
      // Even over the area of the wedge.
      const range = Math.max(12, FARTHEST * Math.sqrt(hashUnit(hashPcg(2 * i + 1))));
      const angle = half * (2 * hashUnit(hashPcg(2 * i)) - 1);
      const cost = elements(calibratedRange(range, rows, fov));
      drawn += cost;
      if (range < 300) near += cost;
      const part = Math.sqrt(cost / full);
      p.dot([range * Math.cos(angle), range * Math.sin(angle)], 1 + 6 * part, {
        colour: cost > full / 2 ? c.answer : c.level1,
        alpha: 0.35 + 0.5 * part,
      });
    }
    for (const range of [100, 300, 800]) {
      const r2 = calibratedRange(range, rows, fov);
      // Below the wedge, where no trees stand.
      const below = Math.max(-range * sin, p.y[0]);
      p.text([range * cos, below], this.host.size.width < 480 ? `${range} m` : `${range} m, r₂ ${r2.toFixed(0)}`, {
        size: 12,
        colour: c.soft,
        align: 'center',
        shift: [0, below > p.y[0] ? 16 : -4],
      });
    }
    p.dot([0, 0], 5, { colour: c.ink });
    const millions = (n: number): string => (n / 1e6).toFixed(n < 1e7 ? 2 : 0);
    return {
      full: millions(full * trees),
      drawn: millions(drawn),
      part: `${((100 * drawn) / (full * trees)).toFixed(1)} %`,
      near: `${((100 * near) / drawn).toFixed(0)} %`,
    };
  }

  handles(values: Values) {
    const fov = numberOf(values, 'fov');
    const half = acrossOf(fov);
    return [
      this.plane.handle({
        id: 'fov',
        label: 'Edge of the view',
        at: [GRIP * Math.cos(half), GRIP * Math.sin(half)],
        said: `field of view ${fov} degrees`,
        move: (x, y) => this.host.set('fov', fovOf(Math.atan2(Math.max(0, y), Math.max(1, x)))),
        turn: (steps) => this.host.set('fov', fov + steps),
      }),
    ];
  }

  text(values: Values): string {
    return `${numberOf(values, 'trees')} aspens in view seen from above; the farther a tree, the smaller its dot, by what is drawn of it.`;
  }
}

/** What a forest costs by the rules. */
export const hillside: FigureSpec = {
  id: 'hillside',
  title: 'A forest from above',
  aspect: 1.5,
  controls: [
    { id: 'trees', label: 'Trees in view', min: 50, max: 5000, step: 50, value: 1000 },
    { id: 'fov', label: 'Field of view, vertical', unit: '°', min: 5, max: 60, step: 1, value: 30 },
    { id: 'rows', label: 'Rows of pixels', min: 240, max: 2160, step: 20, value: 1080 },
  ],
  readouts: [
    { id: 'full', label: 'All elements', unit: 'million' },
    { id: 'drawn', label: 'Drawn', unit: 'million' },
    { id: 'part', label: 'That is' },
    { id: 'near', label: 'Of these, nearer than 300 m' },
  ],
  page: {
    name: 'Open such a forest',
    address: (values) => `forest.html#season=summer&mix=quaking-aspen:1&trees=${numberOf(values, 'trees')}`,
  },
  stage: (host) => new Hillside(host),
};
