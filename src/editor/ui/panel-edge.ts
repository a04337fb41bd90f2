import { html, type TemplateResult } from 'lit';
import type { Editor } from '../editor.ts';
import { frameWords } from '../words/frame.ts';

/** Pixels: the least and the most that the left panel can be wide, what it is at first, and the step of an arrow key. */
const LEAST = 280;
const MOST = 640;
const AT_FIRST = 328;
const AT_FIRST_SMALL = 320;
const STEP = 16;
/** The tree keeps at least so much between the panels. */
const TREE = 240;
const RIGHT = 304;

const most = (): number => Math.max(LEAST, Math.min(MOST, window.innerWidth - RIGHT - TREE));
const within = (width: number): number => Math.round(Math.min(most(), Math.max(LEAST, width)));

/** Width of the left panel now: as it was pulled, as far as the window has room. */
export const growWidth = (editor: Editor): number =>
  within(editor.preferences.growWidth ?? (window.innerWidth < 1200 ? AT_FIRST_SMALL : AT_FIRST));

/** The right edge of the left panel, to pull. */
export function panelEdge(editor: Editor, onWidth: () => void): TemplateResult {
  const size = (width: number | null): void => {
    editor.actions.setGrowWidth(width === null ? null : within(width));
    onWidth();
  };
  const place = (event: PointerEvent): number =>
    event.clientX - (event.currentTarget as HTMLElement).closest('.side')!.getBoundingClientRect().left;
  const hold = (event: PointerEvent): void => {
    if (event.button === 0) (event.currentTarget as HTMLElement).setPointerCapture(event.pointerId);
  };
  const pull = (event: PointerEvent): void => {
    if ((event.currentTarget as HTMLElement).hasPointerCapture(event.pointerId)) size(place(event));
  };
  const onKey = (event: KeyboardEvent): void => {
    const towards = { ArrowRight: 1, ArrowLeft: -1 }[event.key];
    if (!towards) return;
    event.preventDefault();
    size(growWidth(editor) + towards * STEP);
  };
  return html`<div class="panel-edge" role="separator" tabindex="0" aria-orientation="vertical" aria-label=${frameWords.width}
    aria-controls="grow-body" aria-valuemin=${LEAST} aria-valuemax=${most()} aria-valuenow=${growWidth(editor)}
    title=${frameWords.widthTitle} @pointerdown=${hold} @pointermove=${pull} @keydown=${onKey} @dblclick=${() => size(null)}></div>`;
}
