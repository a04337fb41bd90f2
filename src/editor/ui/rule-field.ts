import type { TemplateResult } from 'lit';
import type { SliderRule } from '../../core/link/rule.ts';
import { numberField } from './number-field.ts';

/** A number of the document by its rule. */
export const ruleField = (
  rule: SliderRule,
  field: {
    readonly id: string;
    readonly label: string;
    readonly name?: string;
    readonly value: number;
    readonly reset?: number;
    readonly disabled?: boolean;
    readonly onInput: (value: number) => void;
  },
): TemplateResult =>
  numberField({
    unit: rule.unit,
    min: rule.min,
    max: rule.max,
    slider: rule.slider,
    step: rule.slider.step,
    decimals: rule.decimals,
    help: rule.help,
    ...field,
  });
