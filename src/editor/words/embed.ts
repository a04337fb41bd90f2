/** What a page says that shows only the picture, in a frame of another page. */
export const embedWords = {
  play: 'Play',
  pause: 'Pause',
  made: 'Windgrove',
  open: 'Open this tree in Windgrove',
} as const;
