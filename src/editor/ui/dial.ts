import { html, type TemplateResult } from 'lit';
import { dialWords } from '../words/wind.ts';

/** A direction over the ground as a compass that is turned: 0° points right, 90° up, which is away in the first view. */
export interface Dial {
  readonly id: string;
  readonly name: string;
  /** Degrees, 0 to 360. */
  readonly value: number;
  readonly disabled?: boolean;
  readonly onInput: (degrees: number) => void;
}

/** Degrees of an arrow key, with Shift, and of a page key. */
const STEP = 1;
const COARSE = 10;
const PAGE = 45;
/** Degrees to which a drag with Shift snaps. */
const SNAP = 15;

const within = (degrees: number): number => ((degrees % 360) + 360) % 360;

/** Dragged anywhere on and around it, moved by arrows, with Shift in larger steps. */
export function dial({ id, name, value, disabled = false, onInput }: Dial): TemplateResult {
  const turnTo = (event: PointerEvent): void => {
    const face = event.currentTarget as HTMLElement;
    if (!face.hasPointerCapture(event.pointerId)) return;
    const { left, top, width, height } = face.getBoundingClientRect();
    const x = event.clientX - left - width / 2;
    const y = top + height / 2 - event.clientY;
    if (Math.hypot(x, y) < 3) return; // the middle points nowhere
    const degrees = (Math.atan2(y, x) * 180) / Math.PI;
    onInput(within(event.shiftKey ? Math.round(degrees / SNAP) * SNAP : Math.round(degrees)));
  };
  const start = (event: PointerEvent): void => {
    if (disabled || event.button !== 0) return;
    const face = event.currentTarget as HTMLElement;
    face.setPointerCapture(event.pointerId);
    turnTo(event);
  };
  const onKey = (event: KeyboardEvent): void => {
    const by = event.shiftKey ? COARSE : STEP;
    const moves: Record<string, number> = {
      ArrowUp: value + by,
      ArrowRight: value + by,
      ArrowDown: value - by,
      ArrowLeft: value - by,
      PageUp: value + PAGE,
      PageDown: value - PAGE,
      Home: 0,
    };
    const next = moves[event.key];
    if (next === undefined || disabled || event.ctrlKey || event.metaKey || event.altKey) return;
    event.preventDefault();
    onInput(within(next));
  };
  return html`<span class="dial" id=${id} role="slider" tabindex=${disabled ? -1 : 0} aria-label=${name} aria-disabled=${disabled}
    aria-valuemin="0" aria-valuemax="360" aria-valuenow=${value} aria-valuetext=${dialWords.degrees(value)}
    title=${dialWords.title(name, value)} style="--turn: ${-value}deg"
    @pointerdown=${start} @pointermove=${turnTo} @keydown=${onKey}><svg viewBox="0 0 32 32" aria-hidden="true">
    <circle cx="16" cy="16" r="13"></circle><path class="tick" d="M29 16h-3M16 3v3M3 16h3M16 29v-3"></path>
    <path class="hand" d="M7 16h16M18.5 11.5L23 16l-4.5 4.5"></path></svg></span>`;
}
