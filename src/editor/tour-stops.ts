import type { Editor } from './editor.ts';
import type { Panel } from './session.ts';
import { showPanel } from './ui/show-panel.ts';
import { tourWords } from './words/tour.ts';

/** A stop of the tour. */
export interface TourStop {
  readonly id: keyof typeof tourWords.stops;
  readonly text: string;
  /** What is pointed at. */
  readonly at: string;
  /** The panel that must stand open. */
  readonly panel?: Panel;
  readonly side?: 'top' | 'bottom' | 'left' | 'right';
}

const wide: readonly Omit<TourStop, 'text'>[] = [
  { id: 'picture', at: '.picture' },
  { id: 'grow', at: '.side.grow', panel: 'grow', side: 'right' },
  { id: 'undo', at: '.tool-group.steps', side: 'bottom' },
  { id: 'wind', at: '.side.blow', panel: 'wind', side: 'left' },
  { id: 'time', at: '.bottom', side: 'top' },
  { id: 'take', at: '.tool-group.whole-tree', side: 'bottom' },
  { id: 'find', at: '.tool-group.finding', side: 'bottom' },
];
/** One sheet holds all panels, and one menu what does not fit the bar. */
const narrow: readonly Omit<TourStop, 'text'>[] = [
  { id: 'picture', at: '.picture' },
  { id: 'grow', at: '.sheet', panel: 'grow', side: 'top' },
  { id: 'undo', at: '.top .steps', side: 'bottom' },
  { id: 'wind', at: '.sheet', panel: 'wind', side: 'top' },
  { id: 'time', at: '.sheet', panel: 'time', side: 'top' },
  { id: 'take', at: '.top [popovertarget="more-menu"]', side: 'bottom' },
];

/** The stops that this window has. */
export function tourStops(editor: Editor): TourStop[] {
  const isNarrow = editor.session.getState().narrow;
  return (isNarrow ? narrow : wide).map((stop) => ({
    ...stop,
    text: tourWords.stops[stop.id][isNarrow ? 'narrow' : 'wide'],
  }));
}

/** Opens what a stop speaks of. */
export async function prepareStop(editor: Editor, { panel }: TourStop): Promise<void> {
  const { narrow: isNarrow, detent } = editor.session.getState();
  // A sheet that is pulled up hides what the tour says, and the tree.
  if (isNarrow && detent !== 'third') editor.actions.setDetent('third');
  if (panel) await showPanel(editor, panel);
}
