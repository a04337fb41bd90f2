/** Whether the page around an element is dark: by its `color-scheme`, and where that allows both, by the reader's system. */
export function isDark(element: Element): boolean {
  const scheme = getComputedStyle(element).colorScheme;
  if (!scheme.includes('dark')) return false;
  return !scheme.includes('light') || matchMedia('(prefers-color-scheme: dark)').matches;
}

/** Tells when the page may have changed its colours, until the returned function is called. */
export function watchScheme(tell: () => void): () => void {
  const system = matchMedia('(prefers-color-scheme: dark)');
  const page = new MutationObserver(tell);
  system.addEventListener('change', tell);
  page.observe(document.documentElement, { attributes: true });
  return () => {
    system.removeEventListener('change', tell);
    page.disconnect();
  };
}
