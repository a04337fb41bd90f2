import { html, type TemplateResult } from 'lit';
import { speedOfForce } from '../../core/wind/speed.ts';
import type { Gust } from '../../core/wind/wind.ts';
import type { Editor } from '../editor.ts';
import { gustWords } from '../words/wind.ts';

/** Seconds that an arrow key moves a gust. */
const NUDGE = 0.1;

/** The gusts that start on a page of the ruler, as marks that are chosen, moved and taken away there. */
export function gustMarks(editor: Editor, gusts: readonly Gust[], start: number, seconds: number): TemplateResult {
  const { actions, session } = editor;
  const chosen = session.getState().gust;
  return html`<div class="gust-marks">${gusts.map((gust, i) => {
    const at = (gust.start - start) / seconds;
    if (at < 0 || at >= 1) return '';
    const long = Math.min(1 - at, (gust.rise + gust.fall) / seconds);
    const mark = gustWords.mark(i + 1, speedOfForce(gust.amplitude), gust.start);
    return html`<button type="button" class="gust-mark" data-drag style="left: ${(100 * at).toFixed(3)}%; --long: ${(100 * long).toFixed(2)}cqw"
      aria-pressed=${i === chosen} aria-label=${gustWords.markSpoken(mark)} title=${gustWords.markTitle(mark)}
      @click=${() => actions.chooseGust(i === chosen ? null : i)} @keydown=${(e: KeyboardEvent) => onKey(e, i, gust)}
      @pointerdown=${(e: PointerEvent) => onPull(e, i)}></button>`;
  })}</div>`;

  function onKey(event: KeyboardEvent, index: number, gust: Gust): void {
    const by = { ArrowLeft: -NUDGE, ArrowRight: NUDGE }[event.key];
    if (event.key === 'Delete' || event.key === 'Backspace') actions.removeGust(index);
    else if (by) actions.setGustStart(index, gust.start + by * (event.shiftKey ? 10 : 1));
    else return;
    event.preventDefault();
  }

  /** Pulls the mark along the ruler; a click is no pull. */
  function onPull(event: PointerEvent, index: number): void {
    if (event.button !== 0) return;
    const mark = event.currentTarget as HTMLElement;
    const { left, width } = mark.parentElement!.getBoundingClientRect();
    const from = event.clientX;
    let pulled = false;
    const controller = new AbortController();
    mark.setPointerCapture(event.pointerId);
    mark.addEventListener(
      'pointermove',
      (e) => {
        pulled ||= Math.abs(e.clientX - from) > 3;
        if (pulled) actions.setGustStart(index, start + Math.min(1, Math.max(0, (e.clientX - left) / width)) * seconds);
      },
      { signal: controller.signal },
    );
    const end = (): void => {
      controller.abort();
      if (!pulled) return;
      // The click at the end of a pull chooses nothing.
      window.addEventListener('click', (e) => e.stopPropagation(), { capture: true, once: true });
      actions.chooseGust(index);
    };
    mark.addEventListener('pointerup', end, { signal: controller.signal });
    mark.addEventListener('pointercancel', end, { signal: controller.signal });
  }
}
