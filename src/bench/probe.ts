import { WebGLRenderer } from 'three';

/** Asks a context for something and gives it back; null where there is none. */
export function probe<T>(ask: (renderer: WebGLRenderer) => T): T | null {
  try {
    const renderer = new WebGLRenderer({ canvas: document.createElement('canvas') });
    const answer = ask(renderer);
    renderer.forceContextLoss();
    renderer.dispose();
    return answer;
  } catch {
    return null;
  }
}
