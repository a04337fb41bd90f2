import { html, type TemplateResult } from 'lit';

/** Drawings of 16 by 16 in the colour of the text; the control around them has the words. */
const paths = {
  play: 'M4.5 2.5v11l9-5.5z',
  pause: 'M4.5 2.5v11M11.5 2.5v11',
  step: 'M3 3v10l6.5-5zM12.5 3v10',
  dice: 'M2.5 2.5h11v11h-11zM5.5 5.5h.01M10.5 5.5h.01M8 8h.01M5.5 10.5h.01M10.5 10.5h.01',
  link: 'M6.5 9.5l3-3M7 4.5l1.2-1.2a3 3 0 014.3 4.3L11 9M9 11.5l-1.2 1.2a3 3 0 01-4.3-4.3L5 7',
  sun: 'M8 5a3 3 0 100 6 3 3 0 000-6zM8 1v1.5M8 13.5V15M1 8h1.5M13.5 8H15M3 3l1 1M12 12l1 1M13 3l-1 1M4 12l-1 1',
  moon: 'M13 9.6A5.6 5.6 0 016.4 3a5.6 5.6 0 106.6 6.6z',
  half: 'M8 2a6 6 0 100 12A6 6 0 008 2zM8 2v12M9.5 4v8M11 5v6M12.5 6.5v3',
  help: 'M5.8 6a2.2 2.2 0 113 2c-.6.3-.8.7-.8 1.5M8 12v.01',
  close: 'M4 4l8 8M12 4l-8 8',
  down: 'M4 6.5l4 4 4-4',
  open: 'M2.5 12.5v-9h4l1.5 2h5.5v7z',
  frame: 'M2.5 5.5v-3h3M10.5 2.5h3v3M13.5 10.5v3h-3M5.5 13.5h-3v-3',
  arrow: 'M2.5 8h11M9.5 4l4 4-4 4',
  back: 'M13 3v10L6.5 8zM3.5 3v10',
  slow: 'M8 3a5.5 5.5 0 105.5 5.5M8 5.5V8.5h2.5M11 3.2l.01 0M12.8 5.4l.01 0',
  gust: 'M2 5.5h7.5a1.9 1.9 0 10-1.8-2.4M2 8.5h10a1.9 1.9 0 11-1.8 2.4M2 11.5h4.5',
  aim: 'M8 4.5a3.5 3.5 0 100 7 3.5 3.5 0 000-7M8 1.5v4M8 10.5v4M1.5 8h4M10.5 8h4',
  loop: 'M3 8a4 4 0 014-4h4.5M9.5 2l2 2-2 2M13 8a4 4 0 01-4 4H4.5M6.5 14l-2-2 2-2',
  grip: 'M6 4h.01M10 4h.01M6 8h.01M10 8h.01M6 12h.01M10 12h.01',
  up: 'M4 9.5l4-4 4 4',
  plus: 'M8 3v10M3 8h10',
  copy: 'M5.5 5.5v-3h8v8h-3M2.5 5.5h8v8h-8z',
  bin: 'M3 4.5h10M6.5 4.5v-2h3v2M4.5 4.5l.5 9h6l.5-9',
  save: 'M8 2v8M5 7.5l3 3 3-3M2.5 13.5h11',
  undo: 'M6 3L2.5 6.5 6 10M3 6.5h6.5a3.5 3.5 0 010 7H7',
  redo: 'M10 3l3.5 3.5L10 10M13 6.5H6.5a3.5 3.5 0 000 7H9',
  history: 'M3 3.5V6h2.5M3.3 6A5.2 5.2 0 118 13.2 5.2 5.2 0 013 9.6M8 5.5V8.3l2 1.4',
  share: 'M8 9.5v-8M5 4.2l3-2.7 3 2.7M4.5 7H3v7h10V7h-1.5',
  export: 'M2.5 9.5v4h11v-4M8 10V2M4.8 5.2L8 2l3.2 3.2',
  leaf: 'M3 13C2.5 6.5 6.5 2.5 13.5 2.5 13.5 9.5 9.5 13.5 4.5 11.5M2.5 13.5L9.5 6.5',
  many: 'M2.5 2.5h4.5v4.5H2.5zM9 2.5h4.5v4.5H9zM2.5 9h4.5v4.5H2.5zM11.2 9v4.5M9 11.2h4.5',
  find: 'M7 2.5a4.5 4.5 0 100 9 4.5 4.5 0 000-9M10.3 10.3l3.2 3.2',
  more: 'M2.5 8a1 1 0 102 0 1 1 0 10-2 0M7 8a1 1 0 102 0 1 1 0 10-2 0M11.5 8a1 1 0 102 0 1 1 0 10-2 0',
  code: 'M5 4.5L1.5 8 5 11.5M11 4.5L14.5 8 11 11.5',
  walk: 'M8 2v12M8 3.5h4.5l1.5 1.6-1.5 1.6H8M8 8H4L2.5 9.6 4 11.2h4',
  reset: 'M3 3v3.5h3.5M3.4 6.5A5 5 0 118 13a5 5 0 01-4.4-2.6',
  eye: 'M1.5 8S4 3.5 8 3.5 14.5 8 14.5 8 12 12.5 8 12.5 1.5 8 1.5 8zM8 6a2 2 0 100 4 2 2 0 000-4',
  lock: 'M4 7.5h8v6H4zM5.5 7.5V5a2.5 2.5 0 015 0v2.5',
  unlock: 'M4 7.5h8v6H4zM5.5 7.5V5a2.5 2.5 0 014.8-1',
  columns: 'M2.5 3h11v10h-11zM6.2 3v10M9.8 3v10',
  probe: 'M8 1.5v6M8 7.5a3 3 0 100 6 3 3 0 000-6M8 10.5h.01',
  paste: 'M5.5 3.5h-2v10h9v-10h-2M5.5 2.5h5v2.5h-5z',
  camera: 'M2 5h3l1.2-2h3.6L11 5h3v8H2zM8 6.6a2.3 2.3 0 100 4.6 2.3 2.3 0 000-4.6',
  scene: 'M1.5 12.5l4-5 2.6 3.2L10.5 8l4 4.5zM11.5 2.5a1.8 1.8 0 100 3.6 1.8 1.8 0 000-3.6',
} as const;

export type Icon = keyof typeof paths;

const filled: ReadonlySet<Icon> = new Set(['play', 'more']);

/** An icon that screen readers pass over. */
export const icon = (name: Icon): TemplateResult => html`<svg class="icon" viewBox="0 0 16 16" aria-hidden="true"
  ><path d=${paths[name]} fill=${filled.has(name) ? 'currentColor' : 'none'}></path
></svg>`;
