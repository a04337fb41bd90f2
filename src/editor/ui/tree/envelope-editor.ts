import { html, nothing, svg, type TemplateResult } from 'lit';
import { envelopeRatio } from '../../../core/grow/stem-shape.ts';
import type { PruningParameters } from '../../../core/species/species.ts';
import { treeWords } from '../../words/tree.ts';
import type { Context } from './context.ts';
import { curveBox, drawnTree, mapping, mirrored } from './curve-box.ts';
import { curvePoint } from './curve-point.ts';

const STEPS = 40;
const MOST_POWER = 10;
/** Part of the way from an end of the envelope to its peak at which the point of a power sits. */
const MIDDLE = 0.5;

const hundredth = (value: number): number => Number(value.toFixed(2));
const within = (value: number, min: number, max: number): number => Math.min(max, Math.max(min, value));

/** The power with which the envelope has the radius `r` (a part of its width) half way to the peak. */
export const powerThrough = (r: number): number =>
  hundredth(within(Math.log(within(r, 1e-4, 1)) / Math.log(MIDDLE), 0, MOST_POWER));

/** Radii and heights of the envelope, in parts of the size, from its bottom to its top. */
export function envelopeOutline(pruning: PruningParameters, baseSize: number): (readonly [number, number])[] {
  return Array.from({ length: STEPS + 1 }, (_, i) => {
    // Denser at both ends, where full envelopes are round.
    const up = (1 - Math.cos((Math.PI * i) / STEPS)) / 2;
    return [pruning.width * envelopeRatio(1 - up, pruning), baseSize + up * (1 - baseSize)] as const;
  });
}

/** The pruning envelope over the tree: points for its widest place and for both its curves. */
export function envelopeEditor(c: Context): TemplateResult {
  const { pruning, tree: form } = c.species;
  const words = treeWords.envelope;
  const tree = c.silhouette();
  const { width, widthPeak, powerLow, powerHigh } = pruning;
  const m = mapping(Math.max(1, tree?.top ?? 1), c.stretch('envelope', Math.max(width, tree?.radius ?? 0) * 1.15));
  const height = (up: number): number => form.baseSize + up * (1 - form.baseSize);
  const upOf = (z: number): number => (z - form.baseSize) / (1 - form.baseSize);
  const setAll = (values: Readonly<Record<string, number>>): void => c.setAll(values);
  const lowAt = MIDDLE * widthPeak;
  const highAt = 1 - MIDDLE * (1 - widthPeak);
  const radiusAt = (up: number): number => width * envelopeRatio(1 - up, pruning);
  return html`${curveBox(
    words.picture,
    svg`${tree ? drawnTree(tree, m) : nothing}
      <path class="curve-line" ?data-off=${pruning.ratio === 0} d=${mirrored(envelopeOutline(pruning, form.baseSize), m)}></path>
      ${curvePoint({
        id: 'envelope-high',
        name: words.high,
        x: m.x(radiusAt(highAt)),
        y: m.y(height(highAt)),
        min: 0,
        max: MOST_POWER,
        now: powerHigh,
        spoken: words.power(powerHigh),
        onDrag: (x, y) => setAll({ 'pruning.powerHigh': powerThrough(m.back(x, y).x / (width || 1)) }),
        onKey: (right, up) =>
          setAll({ 'pruning.powerHigh': hundredth(within(powerHigh - 0.02 * (right + up), 0, MOST_POWER)) }),
      })}
      ${curvePoint({
        id: 'envelope-width',
        name: words.width,
        x: m.x(width),
        y: m.y(height(widthPeak)),
        min: 0,
        max: 5,
        now: width,
        spoken: words.widthValue(width, widthPeak),
        onDrag: (x, y) => {
          const at = m.back(x, y);
          setAll({
            'pruning.width': hundredth(within(at.x, 0, 5)),
            'pruning.widthPeak': hundredth(within(upOf(at.z), 0, 1)),
          });
        },
        onKey: (right, up) =>
          setAll({
            'pruning.width': hundredth(within(width + 0.01 * right, 0, 5)),
            'pruning.widthPeak': hundredth(within(widthPeak + 0.01 * up, 0, 1)),
          }),
      })}
      ${curvePoint({
        id: 'envelope-low',
        name: words.low,
        x: m.x(radiusAt(lowAt)),
        y: m.y(height(lowAt)),
        min: 0,
        max: MOST_POWER,
        now: powerLow,
        spoken: words.power(powerLow),
        onDrag: (x, y) => setAll({ 'pruning.powerLow': powerThrough(m.back(x, y).x / (width || 1)) }),
        onKey: (right, up) =>
          setAll({ 'pruning.powerLow': hundredth(within(powerLow - 0.02 * (right + up), 0, MOST_POWER)) }),
      })}`,
  )}
  <p class="note">${words.note}</p>
  ${
    pruning.ratio === 0
      ? html`<button type="button" class="quiet draw-curve" @click=${() => c.set('pruning.ratio', 1)}>${words.start}</button>`
      : nothing
  }`;
}
