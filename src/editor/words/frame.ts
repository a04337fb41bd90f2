/** The frame of the editor: panels, sheet, messages, hints. */
export const frameWords = {
  grows: 'What grows',
  blows: 'What blows',
  width: 'Width of this panel',
  widthTitle: 'Pull to make the panel wider or narrower; a double click puts it back',
  messages: 'Messages',
  kinds: { error: 'Error:', warning: 'Note:', note: 'Note:' },
  closeMessage: 'Close this message',
  growing: (name: string): string => `Growing ${name}`,
  stop: 'Stop',
  hint: 'Hint',
  throwing: 'Throwing gusts',
  throwHint: 'Click the ground to throw a gust.',
  gotIt: 'Got it',
  showAround: 'Show me around',
  controls: 'Controls',
  sheetHeight: (height: string): string => `Height of the controls: ${height}`,
  heights: { bar: 'closed', third: 'a third', 'two-thirds': 'two thirds', all: 'all' },
  tabs: { grow: 'Grow', wind: 'Wind', studio: 'Studio', time: 'Time', view: 'View' },
  photoFailed: 'Photo mode could not be loaded',
  panelsFailed: 'The panels could not be loaded; reload the page to try again',
  drop: 'Let go to open it: a tree, a species, a wind, a measured wind',
} as const;

/** What a page says that shows only the picture, in a frame of another page. */
export const embedWords = {
  play: 'Play',
  pause: 'Pause',
  made: 'Windgrove',
  open: 'Open this tree in Windgrove',
} as const;
