import type { Kind, Measured } from './measured.ts';

/** Keeps every `[data-yours="KIND-SIZE"]` of the page at what this machine does a second; as it was where that was not measured. */
export function fillOwnCells(measured: Measured): void {
  const cells = [...document.querySelectorAll<HTMLElement>('[data-yours]')].map((cell) => {
    const [kind, size] = (cell.dataset.yours ?? '').split('-');
    return { cell, kind: kind as Kind, size: Number(size), empty: cell.textContent ?? '' };
  });
  measured.watch(() => {
    for (const { cell, kind, size, empty } of cells) {
      const rate = measured.rates(kind).find((each) => each.size === size)?.perSecond;
      cell.textContent = rate === undefined ? empty : rate >= 100 ? rate.toFixed(0) : rate.toPrecision(3);
    }
  });
}
