import { svg, type TemplateResult } from 'lit';

/** A point of a curve that is dragged, or moved by the arrow keys. */
export interface CurvePoint {
  readonly id: string;
  readonly name: string;
  /** Where it is in the drawing. */
  readonly x: number;
  readonly y: number;
  readonly min: number;
  readonly max: number;
  readonly now: number;
  readonly spoken: string;
  /** Dragged to this point of the drawing. */
  readonly onDrag: (x: number, y: number) => void;
  /** Arrow keys: steps to the right and upwards, ten at a time with Shift. */
  readonly onKey: (right: number, up: number) => void;
  readonly onReset?: () => void;
}

const COARSE = 10;

/** How far the point was beside the finger when it was taken, so that it does not jump under it. */
const taken = { x: 0, y: 0 };

/** The place of an event in the drawing. */
function placeOf(event: PointerEvent): { readonly x: number; readonly y: number } {
  const drawing = (event.currentTarget as SVGElement).ownerSVGElement!;
  const { left, top, width, height } = drawing.getBoundingClientRect();
  const { viewBox } = drawing;
  return {
    x: ((event.clientX - left) / width) * viewBox.baseVal.width,
    y: ((event.clientY - top) / height) * viewBox.baseVal.height,
  };
}

export function curvePoint(p: CurvePoint): TemplateResult {
  const start = (event: PointerEvent): void => {
    if (event.button !== 0) return;
    const { x, y } = placeOf(event);
    taken.x = p.x - x;
    taken.y = p.y - y;
    (event.currentTarget as SVGElement).setPointerCapture(event.pointerId);
  };
  const move = (event: PointerEvent): void => {
    if (!(event.currentTarget as SVGElement).hasPointerCapture(event.pointerId)) return;
    const { x, y } = placeOf(event);
    p.onDrag(x + taken.x, y + taken.y);
  };
  const key = (event: KeyboardEvent): void => {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    const ways: Record<string, readonly [number, number]> = {
      ArrowRight: [1, 0],
      ArrowLeft: [-1, 0],
      ArrowUp: [0, 1],
      ArrowDown: [0, -1],
    };
    const way = ways[event.key];
    if (!way) return;
    event.preventDefault();
    const by = event.shiftKey ? COARSE : 1;
    p.onKey(way[0] * by, way[1] * by);
  };
  return svg`<g class="point" id=${p.id} role="slider" tabindex="0" data-drag aria-label=${p.name} aria-valuemin=${p.min} aria-valuemax=${p.max}
      aria-valuenow=${p.now} aria-valuetext=${p.spoken} transform="translate(${p.x.toFixed(1)} ${p.y.toFixed(1)})"
      @pointerdown=${start} @pointermove=${move} @keydown=${key} @dblclick=${() => p.onReset?.()}>
      <circle class="aim" r="15"></circle><circle class="dot" r="6"></circle><title>${p.name}: ${p.spoken}</title></g>`;
}
