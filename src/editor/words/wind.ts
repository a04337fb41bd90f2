// What the time bar, the picture and the dials say of winds; the panel's own words are in words/wind-panel.ts and come with it.
export const gustWords = {
  about: 'A gust is a front that crosses the meadow, once or every so often.',
  throw: 'Throw a gust',
  throwTitle: 'From upwind, now',
  aim: 'Aim',
  aimTitle: 'Each click on the ground throws one',
  stopAiming: 'Stop aiming',
  removeAll: 'Remove all',
  most: 'Sixteen is all: one more takes the place of the oldest.',
  gust: (number: number): string => `Gust ${number}`,
  of: (gust: string, what: string): string => `${gust} ${what}`,
  dial: (gust: string): string => `${gust} direction, dial`,
  remove: 'Remove',
  removeGust: (number: number): string => `Remove gust ${number}`,
  mark: (number: number, speed: number, start: number): string =>
    `Gust ${number}, ${speed.toFixed(0)} metres a second, at ${start.toFixed(1)} seconds`,
  markSpoken: (mark: string): string => `${mark}; Delete removes it`,
  markTitle: (mark: string): string => `${mark}. Drag to move, Delete to remove`,
} as const;

export const compareWords = {
  two: 'Two winds',
  line: 'Line between A and B',
  share: (percent: number): string => `A on ${percent} per cent`,
  drag: 'Drag, or use the arrow keys',
} as const;

export const dialWords = {
  degrees: (degrees: number): string => `${degrees} degrees`,
  title: (name: string, degrees: number): string => `${name}: ${degrees}°. Drag, or use the arrow keys`,
} as const;
