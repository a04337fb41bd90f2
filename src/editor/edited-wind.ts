import { roundWind } from '../core/link/link.ts';
import type { Wind } from '../core/wind/wind.ts';
import type { DocumentStore } from './document-store.ts';
import type { SessionStore, Side } from './session.ts';

/** A wind of the document, and what it began as. */
export interface EditedWind {
  readonly side: Side;
  readonly preset: string;
  readonly wind: Wind;
}

/** The wind that the mixer shows and changes: B where two are compared and B is chosen. */
export function editedWind(document: DocumentStore, session: SessionStore): EditedWind {
  const { preset, wind, compare } = document.getState();
  if (compare && session.getState().side === 'B') return { side: 'B', preset: compare.preset, wind: compare.wind };
  return { side: 'A', preset, wind };
}

/** Changes that wind; the document keeps it as a link does. */
export function putWind(document: DocumentStore, session: SessionStore, change: Partial<Wind>, preset?: string): void {
  const edited = editedWind(document, session);
  const wind = roundWind({ ...edited.wind, ...change });
  const whole = { wind, preset: preset ?? edited.preset };
  const { compare } = document.getState();
  if (edited.side === 'B' && compare) document.setState({ compare: { ...compare, ...whole } });
  else document.setState(whole);
}
