import { type DocumentStore, watch } from './document-store.ts';

/** Keeps `data-theme` of the page as the document and the reader's system say; tells `onDark` at once and on each change. */
export function followTheme(document: DocumentStore, onDark: (dark: boolean) => void): void {
  const system = matchMedia('(prefers-color-scheme: dark)');
  const apply = (): void => {
    const { theme } = document.getState();
    const dark = theme === 'dark' || (theme === 'auto' && system.matches);
    window.document.documentElement.dataset.theme = dark ? 'dark' : 'light';
    onDark(dark);
  };
  system.addEventListener('change', apply);
  watch(document, (d) => d.theme, apply);
  apply();
}
