/** The cards of a grid, in their order. */
const cardsIn = (place: Element): HTMLElement[] => [...place.querySelectorAll<HTMLElement>('.gallery-grid a')];

/** The arrows go from card to card, up and down by rows; home and end to the ends. */
export function byArrows(event: KeyboardEvent): void {
  const grid = event.currentTarget as HTMLElement;
  const cards = cardsIn(grid.parentElement!);
  const at = cards.indexOf(event.target as HTMLElement);
  if (at < 0 || event.ctrlKey || event.metaKey || event.altKey) return;
  const columns = getComputedStyle(grid).gridTemplateColumns.split(' ').length;
  const to = {
    ArrowLeft: at - 1,
    ArrowRight: at + 1,
    ArrowUp: at - columns,
    // A last row that is not full is reached from everywhere above it.
    ArrowDown: at + columns < cards.length ? at + columns : lastRow(at, cards.length, columns),
    Home: 0,
    End: cards.length - 1,
  }[event.key];
  if (to === undefined) return;
  event.preventDefault();
  cards[to]?.focus();
}

const lastRow = (at: number, count: number, columns: number): number =>
  Math.floor(at / columns) < Math.floor((count - 1) / columns) ? count - 1 : at;

/** From the boxes above into the grid: to the card that Tab would reach. */
export function enterGrid(gallery: Element): void {
  cardsIn(gallery)
    .find((card) => card.tabIndex === 0)
    ?.focus();
}
