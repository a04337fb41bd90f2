import { css } from '@lit/reactive-element';

/** The element's own look. System colours follow the page's `color-scheme`, so that both themes need no second set. */
export const elementStyles = css`
  :host {
    display: block;
    position: relative;
    aspect-ratio: 4 / 3;
    overflow: hidden;
    contain: content;
    isolation: isolate;
    background: var(--wind-tree-background, transparent);
    font: 14px/1.4 system-ui, sans-serif;
  }
  :host([hidden]) {
    display: none;
  }
  canvas,
  .poster,
  .fallback {
    position: absolute;
    inset: 0;
    inline-size: 100%;
    block-size: 100%;
  }
  canvas {
    display: block;
    outline: none;
  }
  canvas.turns {
    cursor: grab;
  }
  canvas.turning {
    cursor: grabbing;
  }
  /* Inside the picture: the host clips what stands out. */
  .ring {
    position: absolute;
    inset: 0;
    pointer-events: none;
  }
  canvas:focus-visible ~ .ring,
  button:focus-visible {
    outline: 3px solid var(--wind-tree-focus-ring, Highlight);
    outline-offset: -3px;
  }
  .poster {
    display: grid;
    grid-template: 100% / 100%;
    background: var(--wind-tree-poster-color, color-mix(in srgb, Canvas 94%, CanvasText));
    transition:
      opacity 200ms,
      visibility 200ms;
  }
  .poster.gone {
    opacity: 0;
    visibility: hidden;
  }
  .poster ::slotted(*),
  .poster img,
  .show {
    grid-area: 1 / 1;
    min-inline-size: 0;
  }
  .poster ::slotted(*),
  .poster img {
    inline-size: 100%;
    block-size: 100%;
    min-block-size: 0;
    object-fit: cover;
  }
  .show {
    place-self: end center;
    margin-block-end: 16px;
  }
  progress {
    position: absolute;
    inset: auto 0 0;
    inline-size: 100%;
    block-size: 4px;
    border: 0;
    appearance: none;
    background: color-mix(in srgb, CanvasText 16%, transparent);
  }
  progress::-webkit-progress-bar {
    background: transparent;
  }
  progress::-webkit-progress-value {
    background: var(--wind-tree-progress-color, #1a7f37);
  }
  progress::-moz-progress-bar {
    background: var(--wind-tree-progress-color, #1a7f37);
  }
  /* At the top: the controls are at the bottom. */
  .message {
    position: absolute;
    inset: 0 0 auto;
    margin: 0;
    padding: 8px 12px;
    color: CanvasText;
    background: color-mix(in srgb, Canvas 92%, transparent);
    overflow-wrap: anywhere;
  }
  .fallback {
    overflow: auto;
  }
  .controls {
    position: absolute;
    inset: auto auto 8px 8px;
  }
  button {
    display: inline-flex;
    align-items: center;
    justify-content: center;
    min-inline-size: 32px;
    min-block-size: 32px;
    padding: 0 8px;
    border: 1px solid color-mix(in srgb, CanvasText 24%, transparent);
    border-radius: 4px;
    font: inherit;
    color: CanvasText;
    background: color-mix(in srgb, Canvas 88%, transparent);
    cursor: pointer;
  }
  button:hover {
    background: Canvas;
  }
  svg {
    inline-size: 16px;
    block-size: 16px;
    fill: currentColor;
  }
  .said {
    position: absolute;
    inline-size: 1px;
    block-size: 1px;
    margin: -1px;
    overflow: hidden;
    clip-path: inset(50%);
    white-space: nowrap;
  }
  /* Whatever a page gives its parts: it is not there. */
  [hidden] {
    display: none !important;
  }
  @media (pointer: coarse) {
    button {
      min-inline-size: 44px;
      min-block-size: 44px;
    }
  }
  @media (prefers-reduced-motion: reduce) {
    .poster {
      transition: none;
    }
  }
  @media print {
    .controls,
    progress {
      display: none;
    }
  }
`;
