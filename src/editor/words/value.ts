/** Values of parameters that are no numbers. */
export const valueWords = {
  noOutline: 'as the leaf shape',
  asSummer: 'as in summer',
  yes: 'on',
  no: 'off',
  absent: 'none',
} as const;
