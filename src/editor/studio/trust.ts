import type { Studio, StudioHost } from './studio.ts';

/** Milliseconds from one look at the GPU's piece to the next. */
const EVERY = 1000;

/** Once a second, while the drawer is open, holds the GPU's own piece against the one that is plotted. */
export function followTrust(studio: Studio, editor: StudioHost): void {
  let last = 0;
  let asked = false;
  editor.onFrame((time) => {
    const { open, place, catchingUp } = studio.store.getState();
    const now = performance.now();
    if (!open || !place || asked || catchingUp !== null || now - last < EVERY) return;
    const recorder = studio.recorder('a');
    const end = recorder?.probe.endAt(time);
    if (!end) return;
    last = now;
    asked = true;
    void studio.picture
      .readPiece(place.piece)
      .then((pose) => {
        if (!pose || recorder !== studio.recorder('a')) return;
        const difference = Math.hypot(pose[12]! - end[0], pose[13]! - end[1], pose[14]! - end[2]);
        studio.store.setState({ trust: { difference, time } });
      })
      .catch(() => {
        // No tree, or the GPU is gone: there is nothing to compare, and the next look may find it.
      })
      .finally(() => {
        asked = false;
      });
  });
}
