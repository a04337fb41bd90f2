import type { LeafForm } from './blade.ts';
import { BLADE_FORMS } from './blade-forms.ts';
import { COMPOUND_FORMS } from './compound-leaves.ts';
import { hasMargin, type LeafSpec } from './leaf-spec.ts';
import { marginForm } from './margin-form.ts';
import { NEEDLE_FORMS } from './needle-shapes.ts';
import { PAPER_FORMS } from './paper-forms.ts';

export { type LeafSpec, leafSpecOf } from './leaf-spec.ts';

const FORMS: Readonly<Record<number, LeafForm>> = {
  ...PAPER_FORMS,
  ...BLADE_FORMS,
  ...COMPOUND_FORMS,
  ...NEEDLE_FORMS,
};

/** Index is `leaves.shape` of a species, as LEAF_SHAPES of the parameter table names them. Lengths are of the whole: blade, feather, shoot or spray. */
export const LEAF_FORMS: readonly LeafForm[] = Object.values(FORMS);

/** The form of a leaf; LEAF_BEND bends a free outline. Throws RangeError for an unknown shape. */
export function leafForm({ shape, margin }: Pick<LeafSpec, 'shape' | 'margin'>): LeafForm {
  if (hasMargin(margin)) return marginForm(margin);
  const form = FORMS[shape];
  if (!form) throw new RangeError(`leaf shape must be 0 to ${LEAF_FORMS.length - 1}, found ${shape}`);
  return form;
}
