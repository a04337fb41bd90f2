import { capabilitiesOf, probePage } from '../gpu/capabilities.ts';
import type { Actions } from './actions.ts';
import { LivePicture } from './live-picture.ts';
import type { Picture, PictureEvents } from './picture.ts';
import type { SessionStore } from './session.ts';
import { StillPicture } from './still-picture.ts';

/** The best picture that this browser can show, with a message where that is less than the whole. */
export function openPicture(
  host: HTMLElement,
  session: SessionStore,
  actions: Actions,
  events: PictureEvents,
): Picture {
  try {
    const picture = labelled(new LivePicture(host, events));
    const { degradation, reason } = capabilitiesOf(picture.renderer);
    if (degradation !== 'none') actions.notify('warning', 'The wind is slower here than it could be', [reason]);
    return picture;
  } catch (error) {
    const { reason } = probePage();
    session.setState({ still: true });
    actions.notify('warning', 'This is a still picture', [
      reason || `The graphics of this browser failed: ${error instanceof Error ? error.message : String(error)}`,
      'The tree is drawn once for each change. Another browser, or graphics acceleration switched on, shows it in the wind.',
    ]);
    host.replaceChildren();
    return labelled(new StillPicture(host, events));
  }
}

/** Before a tree stands there is nothing else to say of the picture. */
function labelled<P extends Picture>(picture: P): P {
  picture.canvas.setAttribute('role', 'img');
  picture.canvas.setAttribute('aria-label', 'The tree');
  return picture;
}
