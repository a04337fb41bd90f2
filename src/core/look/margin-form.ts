import { LEAF_BEND, type LeafForm } from './blade.ts';
import { marginOutline } from './margin-outline.ts';
import { simple } from './simple-leaf.ts';

/** The form of a leaf of a free outline, which LEAF_BEND bends. `margin`: its half widths. */
export const marginForm = (margin: readonly number[]): LeafForm =>
  simple(marginOutline(margin), 'pinnate', { bend: LEAF_BEND });
