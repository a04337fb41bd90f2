import { power, sinTurns } from '../../core/math/trig.ts';
import { phaseAt } from '../../core/wind/force.ts';
import type { Wave } from '../../core/wind/wind.ts';

/** Seconds that a trace shows before and after now. */
const BEFORE = 5;
const AFTER = 3;
/** Pixels from one point of the line to the next. */
const STEP = 2;

/** The colours of a trace, as the canvas takes them. */
export interface TraceColours {
  readonly line: string;
  readonly area: string;
  readonly quiet: string;
}

/** Part of its peak with which a wave pushes at the foot of the tree. */
export const pushAt = (wave: Wave, time: number, paper: boolean): number =>
  power(0.5 + 0.5 * sinTurns(-phaseAt(wave, time, paper)), wave.sharpness);

/** Draws what one wave does around `time` at the foot of the tree; `share`: its peak, as a part of the loudest wave's. */
export function drawTrace(
  canvas: HTMLCanvasElement,
  wave: Wave,
  time: number,
  look: { readonly share: number; readonly heard: boolean; readonly paper: boolean; readonly colours: TraceColours },
): void {
  const context = canvas.getContext('2d');
  if (!context) return;
  const { width, height } = canvas;
  const { share, heard, paper, colours } = look;
  const dot = Math.max(2, height / 11);
  const low = height - dot;
  const high = dot;
  // A wave that hardly pushes is seen to be there: the line leaves the ground by a pixel or two.
  const y = (t: number): number => low - (low - high) * share * pushAt(wave, t, paper);
  context.clearRect(0, 0, width, height);
  context.beginPath();
  context.moveTo(0, low);
  for (let x = 0; x <= width; x += STEP) context.lineTo(x, y(time - BEFORE + (x / width) * (BEFORE + AFTER)));
  context.strokeStyle = heard ? colours.line : colours.quiet;
  context.lineWidth = Math.max(1, height / 28);
  context.stroke();
  const now = (BEFORE / (BEFORE + AFTER)) * width;
  context.lineTo(width, low);
  context.closePath();
  if (heard) {
    context.fillStyle = colours.area;
    context.fill();
  }
  context.beginPath();
  context.arc(now, y(time), dot, 0, 2 * Math.PI);
  context.fillStyle = heard ? colours.line : colours.quiet;
  context.fill();
}
