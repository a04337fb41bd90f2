import type { LinkDocument } from './document.ts';

/** What a link may have and the viewer, which shows one tree in one wind and one thing over it at a time, has not. */
export type ViewerLack = 'compare' | 'arrows' | 'probe';

/** What the viewer leaves out of a document. */
export const viewerLacks = ({ compare, overlays, view, probe }: LinkDocument): ViewerLack[] => [
  ...(compare ? (['compare'] as const) : []),
  ...(overlays.arrows && view !== 'shaded' ? (['arrows'] as const) : []),
  ...(probe === null ? [] : (['probe'] as const)),
];
