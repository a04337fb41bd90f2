/** A number with a true minus sign, and never a minus before zeros. */
export const signed = (x: number, digits = 2): string => {
  const text = Math.abs(x).toFixed(digits);
  return x < 0 && Number(text) !== 0 ? `\u2212${text}` : text;
};
