import type { LinkDocument } from '../core/link/link.ts';
import type { Wind } from '../core/wind/wind.ts';
import type { Clock } from '../view/clock.ts';
import type { Picture } from '../view/picture/picture.ts';
import type { Editor } from './editor.ts';

/** Seconds that a change of the wind takes while time runs. */
const FADE = 0.8;

/** The wind that blows: none where it is switched off. */
const blowingWind = (d: LinkDocument): Wind => (d.blowing ? d.wind : { ...d.wind, strength: 0 });

/**
 * Hands every change of the document on to the picture, and nothing that did not change; then calls `onChange`.
 *
 * A change of the wind fades while time runs and is there at once while it stands, so that what is seen is what the link
 * gives. Returns what hands on the whole document as it is, the time included: for a document that came from a link.
 */
export function followDocument(
  { document }: Editor,
  clock: Clock,
  picture: Picture,
  onChange: (changed: { grow: boolean }) => void,
): () => void {
  document.subscribe((now, before) => {
    if (now.wind !== before.wind || now.blowing !== before.blowing || (now.paused && !before.paused)) {
      picture.setWind(blowingWind(now), now.paused ? 0 : FADE);
    }
    if (now.camera !== before.camera) picture.setCamera(now.camera);
    if (now.view !== before.view || now.levelsShown !== before.levelsShown || now.showLeaves !== before.showLeaves) {
      picture.show(now);
    }
    onChange({
      grow: now.species !== before.species || now.ownSpecies !== before.ownSpecies || now.seed !== before.seed,
    });
  });
  return () => {
    const now = document.getState();
    clock.seek(now.time);
    clock.rate = now.rate;
    if (now.paused) clock.pause();
    else clock.play();
    picture.setWind(blowingWind(now), 0);
    picture.setCamera(now.camera);
    picture.show(now);
    onChange({ grow: false });
  };
}
