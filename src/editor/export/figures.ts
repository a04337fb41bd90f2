/** A size in bytes as people say it: `3.4 MB`. */
export function sizeText(bytes: number): string {
  if (bytes < 1000) return `${Math.round(bytes)}\u2009B`;
  const units = ['kB', 'MB', 'GB'];
  let value = bytes / 1000;
  let unit = 0;
  while (value >= 999.5 && unit < units.length - 1) {
    value /= 1000;
    unit++;
  }
  return `${value < 10 ? value.toFixed(1) : Math.round(value)}\u2009${units[unit]}`;
}

/** An estimate as a round number: `52 000`, `1.3 million`. */
export function roundCount(count: number): string {
  if (count >= 999_500) return `${(count / 1e6).toFixed(1)} million`;
  const digits = Math.max(1, 10 ** (Math.floor(Math.log10(Math.max(1, count))) - 1));
  return String(Math.round(count / digits) * digits).replace(/\B(?=(\d{3})+$)/g, '\u2009');
}
