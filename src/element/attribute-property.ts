import type { PropertyDeclaration } from 'lit';
import { ATTRIBUTES, type AttributeName, type AttributeRow } from './attributes.ts';

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
    hasChanged: (value, old) => value !== old && JSON.stringify(value) !== JSON.stringify(old),
  };
}
