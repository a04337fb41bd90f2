import type { PictureEvents } from '../view/picture/picture.ts';
import type { Actions } from './actions.ts';
import type { DocumentStore } from './document-store.ts';
import type { SessionStore } from './session.ts';
import { stemHandles } from './stem-handles.ts';
import type { Studio } from './studio/studio.ts';
import { messageWords } from './words/messages.ts';

/** What the reader does in the picture itself, as actions. */
export function sceneEvents(
  document: DocumentStore,
  actions: Actions,
  session: SessionStore,
  invalidate: () => void,
  studio: () => Pick<Studio, 'store'>,
): PictureEvents {
  return {
    onChange: invalidate,
    onCamera: actions.setCamera,
    onLost(lost) {
      if (lost) actions.notify('warning', messageWords.graphicsLost);
      else actions.retract(messageWords.graphicsLost);
      invalidate();
    },
    onHandle(direction, strength, done) {
      actions.hideHint();
      actions.hold();
      actions.setBlowing(true);
      actions.turnWind(direction, strength);
      if (!done) return;
      actions.release();
      actions.say(messageWords.windAt(Math.round(100 * strength)));
    },
    onHoverStem: actions.hoverStem,
    onPickStem(stem, piece) {
      actions.selectStem(stem);
      // Who looks at no plot means the stem alone.
      if (piece !== null && studio().store.getState().open) actions.setProbe(piece);
    },
    onStemHandle: stemHandles(document, session, actions),
    // Every click on the ground is told; outside of the mode it means nothing.
    onThrow(x, y) {
      if (session.getState().throwing) actions.throwGust({ x, y });
    },
    onWipe(at, done) {
      actions.hold();
      actions.setCompareAt(at);
      if (done) actions.release();
    },
  };
}
