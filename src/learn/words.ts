/** What figures say, beyond what a lesson writes. */
export const words = {
  play: 'Play',
  pause: 'Pause',
  step: 'One step',
  reset: 'Reset',
  link: 'Copy link',
  linked: 'Link copied',
  unlinked: 'The link is in the address bar',
  open: 'Open in editor',
  failed: (why: string): string => `This figure cannot be drawn here: ${why}`,
  noWebGl: 'it needs WebGL 2, which this browser does not give.',
  typed: (label: string): string => `${label}, typed`,
  copy: 'Copy BibTeX',
  copied: 'Copied',
  selected: 'Selected: copy it with your keys',
} as const;
