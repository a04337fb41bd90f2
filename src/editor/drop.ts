import { frameWords } from './words/frame.ts';

/** Takes files that are dropped anywhere on the page. */
export function listenToDrops(onFile: (file: File) => void): void {
  const root = document.documentElement;
  const hasFile = (event: DragEvent): boolean => event.dataTransfer?.types.includes('Files') ?? false;
  window.addEventListener('dragover', (event) => {
    if (!hasFile(event)) return;
    event.preventDefault();
    root.dataset.drop = frameWords.drop;
    root.classList.add('dropping');
  });
  window.addEventListener('dragleave', (event) => {
    if (!event.relatedTarget) root.classList.remove('dropping');
  });
  window.addEventListener('drop', (event) => {
    root.classList.remove('dropping');
    if (!hasFile(event)) return;
    event.preventDefault();
    const file = event.dataTransfer?.files[0];
    if (file) onFile(file);
  });
}
