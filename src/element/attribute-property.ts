import type { PropertyDeclaration } from '@lit/reactive-element';
import { ATTRIBUTES, type AttributeName, type AttributeRow } from './attributes.ts';

/** Of all that attributes hold only the camera's orbit is an object: another one of the same numbers is no change. */
const isOrbit = (value: unknown): boolean => typeof value === 'object' && value !== null && 'polar' in value;

/**
 * How Lit reads and writes an attribute of the table. A text that is none goes on as it stands: the element finds it, says so, and puts
 * the old value back.
 */
export function attributeProperty(name: AttributeName): PropertyDeclaration {
  const { rule, usual } = ATTRIBUTES[name] as AttributeRow;
  return {
    attribute: name,
    // The clock's own time is no attribute's.
    reflect: name !== 'time',
    converter: {
      fromAttribute: (text) => (text === null ? usual : (rule.read(text) ?? text)),
      toAttribute: (value) => (value === null || value === usual ? null : rule.write(value)),
    },
    hasChanged: (value, old) => value !== old && !(isOrbit(value) && JSON.stringify(value) === JSON.stringify(old)),
  };
}
