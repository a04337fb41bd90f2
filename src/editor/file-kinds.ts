import { isArbaro, isEzTree } from '../core/io/imported.ts';
import { isProjectText } from '../core/project/limits.ts';

/** A file of a wind says so in its first lines, whatever else is wrong with it. */
export const isWindText = (text: string): boolean => /"format"\s*:\s*"windgrove-wind"/.test(text);

/** Whether a text says of itself that it is something to open: what is pasted by the way is not. */
export const isFileText = (text: string): boolean =>
  isWindText(text) ||
  isProjectText(text) ||
  /"format"\s*:\s*"windgrove-species"/.test(text) ||
  isArbaro(text) ||
  isEzTree(text);
