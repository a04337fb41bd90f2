import type { PiecePlace } from '../../core/wind/probe-place.ts';
import type { ProbeSummary } from '../../core/wind/probe-summary.ts';
import { beaufortOf } from '../../core/wind/speed.ts';
import type { Trust } from '../studio/studio-state.ts';
import { lengthText, smallLengthText, threeDigits } from '../studio/units.ts';

/** What the stems of each level are called; deeper ones use the last. */
const STEMS = ['the trunk', 'a limb', 'a branch', 'a twig'] as const;

/** `a limb (level 1), 4.2 m up`. */
export function placeText({ level, z1, height }: PiecePlace): string {
  const stem = STEMS[Math.min(level, STEMS.length - 1)]!;
  const where = z1 > 0.999 ? 'the end of ' : `${Math.round(100 * z1)}\u2009% along `;
  return `${where}${stem}, ${height.toFixed(1)}\u2009m up`;
}

const hertz = (frequency: number | null): string => (frequency === null ? 'none' : `${threeDigits(frequency)} Hz`);

const seconds = (value: number): string => `${Math.round(value)} second${Math.round(value) === 1 ? '' : 's'}`;

/** A summary in whole sentences, for readers who do not see the plots. */
export function summaryText(summary: ProbeSummary, natural: number | null): string {
  const { wind, displacement, velocity, frequency } = summary;
  const sentences = [
    `The last ${seconds(summary.seconds)}: the wind at the probe has a mean of ${threeDigits(wind.mean)} m/s (${beaufortOf(wind.mean).name.toLowerCase()}) and reaches ${threeDigits(wind.greatest)} m/s.`,
    `The branch leans ${lengthText(displacement.mean)} along the wind on average and gets at most ${lengthText(displacement.greatest)} away from its rest, at up to ${lengthText(velocity.greatest)}/s.`,
    `The force is strongest at ${hertz(frequency.wind)}, the displacement at ${hertz(frequency.displacement)}.`,
  ];
  if (natural !== null) sentences.push(`The branch by itself swings at ${hertz(natural)}.`);
  return sentences.join(' ');
}

/** How far the plotted numbers can be trusted. */
export const trustText = (trust: Trust | null): string =>
  trust === null
    ? 'Not yet held against the tree on the GPU.'
    : `At ${trust.time.toFixed(2)}\u2009s the GPU had the branch\u2019s end ${smallLengthText(trust.difference)} from where these plots say.`;
