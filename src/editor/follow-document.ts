import type { LinkDocument } from '../core/link/link.ts';
import type { Wind } from '../core/wind/wind.ts';
import type { Clock } from '../view/clock.ts';
import type { Editor } from './editor.ts';
import { fadeOf } from './fade.ts';

/** The wind that blows: none where it is switched off. */
const blowing = (d: LinkDocument, wind: Wind): Wind => (d.blowing ? wind : { ...wind, strength: 0 });

/** What of the session is drawn in the scene. */
const IN_SCENE = [
  'highlight',
  'throwing',
  'handling',
  'stem',
  'hoveredStem',
  'envelopeShown',
  'channel',
  'photo',
] as const;

/** What the picture draws beside A: nothing, or B. */
const beside = (d: LinkDocument) =>
  d.compare && { wind: blowing(d, d.compare.wind), layout: d.compare.layout, at: d.compare.at };

/**
 * Hands every change of the document on to the picture, and nothing that did not change; then calls `onChange`.
 *
 * A change of the wind fades while time runs and is there at once while it stands, so that what is seen is what the link
 * gives. Returns what hands on the whole document as it is, the time included: for a document that came from a link.
 */
export function followDocument(
  { document, session, picture, studio }: Editor,
  clock: Clock,
  onChange: (changed: { grow: boolean }) => void,
): () => void {
  const overlays = (): void => {
    const { overlays, probe } = document.getState();
    const { highlight, throwing, handling, stem, hoveredStem, envelopeShown, channel, tree, photo } =
      session.getState();
    const { open, place } = studio.store.getState();
    // Whoever looks at the studio sees what it listens to, chosen or not.
    const shown = open && place ? place.piece : probe;
    const envelope = envelopeShown && tree ? tree.species.pruning : null;
    // A photograph shows what blows, not what it is held by.
    const handle = overlays.handle && !photo;
    const inScene = { handle, stem, hoveredStem, handles: stem !== null, envelope, channel };
    picture.setOverlays({ ...overlays, ...inScene, probe: shown, highlight, throwing, handling });
  };
  document.subscribe((now, before) => {
    const stopped = now.paused && !before.paused;
    const switched = now.blowing !== before.blowing;
    if (now.wind !== before.wind || switched || stopped) {
      picture.setWind(blowing(now, now.wind), now.paused ? 0 : fadeOf(now.wind, before.wind));
    }
    if (now.compare !== before.compare || (now.compare && (switched || stopped))) {
      const fade = now.compare && before.compare && !now.paused ? fadeOf(now.compare.wind, before.compare.wind) : 0;
      picture.setCompare(beside(now), fade);
    }
    if (now.season !== before.season) picture.setSeason(now.season);
    if (now.stage !== before.stage || now.hour !== before.hour) picture.setStage(now.stage, now.hour);
    if (now.camera !== before.camera) picture.setCamera(now.camera);
    if (now.overlays !== before.overlays || now.probe !== before.probe) overlays();
    if (now.view !== before.view || now.levelsShown !== before.levelsShown || now.showLeaves !== before.showLeaves) {
      picture.show(now);
    }
    onChange({
      grow: (['species', 'ownSpecies', 'edits', 'seed'] as const).some((key) => now[key] !== before[key]),
    });
  });
  session.subscribe((now, before) => {
    if (now.quality !== before.quality) {
      picture.setQuality(now.quality);
      onChange({ grow: false });
    }
    const pruned = now.envelopeShown && now.tree?.species.pruning !== before.tree?.species.pruning;
    if (!pruned && IN_SCENE.every((key) => now[key] === before[key])) return;
    overlays();
    onChange({ grow: false });
  });
  studio.store.subscribe((now, before) => {
    if (now.open === before.open && now.place === before.place) return;
    overlays();
    onChange({ grow: false });
  });
  return () => {
    const now = document.getState();
    clock.seek(now.time);
    clock.rate = now.rate;
    if (now.paused) clock.pause();
    else clock.play();
    picture.setWind(blowing(now, now.wind), 0);
    picture.setCompare(beside(now), 0);
    picture.setSeason(now.season);
    picture.setStage(now.stage, now.hour);
    picture.setQuality(session.getState().quality);
    picture.setCamera(now.camera);
    picture.show(now);
    overlays();
    onChange({ grow: false });
  };
}
