import type { PictureEvents } from '../view/picture/picture.ts';
import type { Actions } from './actions.ts';
import type { SessionStore } from './session.ts';
import type { Studio } from './studio/studio.ts';

const LOST = 'The graphics card was taken away; the picture comes back with it';

/** What the reader does in the picture itself, as actions. */
export function sceneEvents(
  actions: Actions,
  session: SessionStore,
  invalidate: () => void,
  studio: () => Pick<Studio, 'store'>,
): PictureEvents {
  return {
    onChange: invalidate,
    onCamera: actions.setCamera,
    onLost(lost) {
      if (lost) actions.notify('warning', LOST);
      else actions.retract(LOST);
      invalidate();
    },
    onHandle(direction, strength, done) {
      actions.hideHint();
      actions.setBlowing(true);
      actions.turnWind(direction, strength);
      if (done) actions.say(`Wind at ${Math.round(100 * strength)} per cent`);
    },
    // Who looks at no plot walks around the tree and means no branch.
    onPickBranch(piece) {
      if (studio().store.getState().open) actions.setProbe(piece);
    },
    // Every click on the ground is told; outside of the mode it means nothing.
    onThrow(x, y) {
      if (session.getState().throwing) actions.throwGust({ x, y });
    },
    onWipe: (at) => actions.setCompareAt(at),
  };
}
