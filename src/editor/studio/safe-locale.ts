/**
 * Gives the page a language that `Intl` knows where the browser names none: uPlot asks for number formats in the browser's
 * language as soon as it is loaded, and some (a Linux without a locale says `en-US@posix`) would have it throw.
 */
export function mendLocale(): void {
  try {
    new Intl.NumberFormat(navigator.language);
  } catch {
    Object.defineProperty(navigator, 'language', { value: 'en', configurable: true });
  }
}
