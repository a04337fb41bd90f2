import { capabilitiesOf, probePage } from '../../gpu/capabilities.ts';
import { LivePicture } from './live-picture.ts';
import type { Picture, PictureEvents } from './picture.ts';

/** A picture, and what it lacks. */
export interface OpenedPicture {
  readonly picture: Picture;
  /** `still`: nothing moves by itself, there is no WebGL2; `slow`: the wind is computed on the CPU. */
  readonly lack: 'none' | 'slow' | 'still';
  /** Why, in a sentence; empty where nothing is lacking. */
  readonly reason: string;
}

/** The best picture that this browser can show, in `host`. */
export async function openPicture(host: HTMLElement, events: PictureEvents): Promise<OpenedPicture> {
  try {
    const picture = labelled(new LivePicture(host, events));
    const { degradation, reason } = capabilitiesOf(picture.renderer);
    return { picture, lack: degradation === 'none' ? 'none' : 'slow', reason };
  } catch (error) {
    const { reason } = probePage();
    host.replaceChildren();
    // Hardly any browser needs it: the others do not wait for it.
    const { DrawnPicture } = await import('./drawn-picture.ts');
    return {
      picture: labelled(new DrawnPicture(host, events)),
      lack: 'still',
      reason:
        reason || `The graphics of this browser failed: ${error instanceof Error ? error.message : String(error)}`,
    };
  }
}

/** Before a tree stands there is nothing else to say of the picture. */
function labelled<P extends Picture>(picture: P): P {
  picture.canvas.setAttribute('role', 'img');
  picture.canvas.setAttribute('aria-label', 'The tree');
  return picture;
}
