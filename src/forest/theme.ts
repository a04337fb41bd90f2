/** Keeps `data-theme` of the page as the reader's system has it; tells `onDark` at once and on each change. */
export function followSystemTheme(onDark: (dark: boolean) => void): void {
  const system = matchMedia('(prefers-color-scheme: dark)');
  const apply = (): void => {
    document.documentElement.dataset.theme = system.matches ? 'dark' : 'light';
    onDark(system.matches);
  };
  system.addEventListener('change', apply);
  apply();
}
