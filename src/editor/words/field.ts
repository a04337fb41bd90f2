/** A number beside a slider. */
export const fieldWords = {
  /** Its box, where the slider has the name already. */
  number: (name: string, unit: string): string => `${name}, ${unit || 'typed'}`,
} as const;
