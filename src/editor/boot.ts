import { decodeLink, type LinkDocument, type LinkFault, roundTime } from '../core/link/link.ts';
import type { Species } from '../core/species/species.ts';
import { Clock } from '../view/clock.ts';
import type { GrownTree } from '../view/picture/grow-tree.ts';
import { openPicture } from '../view/picture/open-picture.ts';
import { createActions } from './actions.ts';
import { followStem } from './actions-stem.ts';
import { Address } from './address.ts';
import { createDocument, watch } from './document-store.ts';
import { listenToDrops } from './drop.ts';
import type { Editor } from './editor.ts';
import { FileError } from './file-error.ts';
import { firstDocument } from './first-document.ts';
import { followDocument } from './follow-document.ts';
import { followGallery } from './follow-gallery.ts';
import { followTitle } from './follow-title.ts';
import { Grower } from './grower.ts';
import { listenToHolds } from './hold-controls.ts';
import { followFile } from './kept-file.ts';
import { linkFaultLines } from './link-faults.ts';
import { listenToKeys } from './listen-keys.ts';
import { Loop } from './loop.ts';
import { listenToOrbitKeys } from './orbit-keys.ts';
import { pageWork } from './page-work.ts';
import { listenToPastes } from './paste.ts';
import { loadPreferences, savePreferences } from './preferences.ts';
import { sceneEvents } from './scene-events.ts';
import { pageServices } from './services.ts';
import { createSession } from './session.ts';
import { followSkyInk } from './sky-ink.ts';
import { loadIndex } from './species-source.ts';
import { startWork } from './start-work.ts';
import { createStudio, type Studio } from './studio/studio.ts';
import { installTestHook } from './test-hook.ts';
import { followTheme } from './theme.ts';
import { thumbnailOf } from './thumbnail.ts';
import './ui/app.ts';
import { followInsets, followWidth } from './window-shape.ts';
import { firstWind, loadWinds } from './winds-source.ts';
import { messageWords } from './words/messages.ts';

/** Milliseconds between two readings of the figures while playing. */
const FIGURES = 500;

/** Starts the editor: the picture in `host`, the interface in `place`. */
export async function boot(host: HTMLElement, place: HTMLElement): Promise<void> {
  const root = window.document.documentElement;
  const preferences = loadPreferences();
  const lessMotion = matchMedia('(prefers-reduced-motion: reduce)').matches;
  const clock = new Clock();
  const address = new Address();
  const session = createSession({ embed: address.embed, quality: preferences.quality });
  // In a frame of another page nothing is made, so nothing is kept.
  const work = address.embed ? null : pageWork();

  const [index, { winds, broken }] = await Promise.all([
    loadIndex().then(
      (species) => ({ species, error: null }),
      (error: unknown) => ({ species: [], error }),
    ),
    loadWinds(),
  ]);
  session.setState({ species: index.species, winds });
  const decoding = {
    defaults: firstDocument(preferences.theme, lessMotion, firstWind(winds)),
    species: index.species.map((s) => s.id),
    winds: Object.fromEntries(winds.map((w) => [w.id, w.wind])),
  };
  const first = address.read(decoding);
  const begin = work && (await work.begin(address.asks ? first.document : null, decoding.defaults));
  const document = createDocument(first.document);
  /** The document as the link holds it at this moment: while playing, the clock knows the time. */
  const now = (): LinkDocument => ({ ...document.getState(), time: roundTime(clock.time) });

  const actions = createActions(
    document,
    session,
    preferences,
    clock,
    pageServices({
      address,
      now,
      first: () => decoding.defaults,
      read: (link) => decodeLink(link, decoding),
      show(whole) {
        document.setState(whole);
        restart();
      },
      thumbnail: async () => grown && thumbnailOf(picture, ...grown),
      notify: (kind, title, lines) => actions.notify(kind, title, lines),
      cancelGrowing: () => grower.cancel(),
      ships: (record) => winds.some((w) => w.wind.record?.name === record),
    }),
  );
  const tell = (title: string, error: unknown): void => {
    if (error instanceof FileError) actions.notify('error', error.message, error.lines);
    else actions.notify('error', title, [error instanceof Error ? error.message : String(error)]);
  };
  const open = (file: File): void => void actions.openFile(file);
  if (work && begin) startWork(work, begin, { document, session, actions, now, link: first.document });
  followFile(document, session);

  /** The tree on the screen, for small pictures of it. */
  let grown: readonly [GrownTree, Species] | null = null;
  let measured = 0;
  // Its first frame comes after all that it speaks of has been made.
  const loop = new Loop(
    clock,
    (time) => {
      const figures = picture.draw(time, clock.playing || picture.moving);
      const { catchingUp } = figures;
      if (session.getState().catchingUp !== catchingUp) session.setState({ catchingUp });
      const at = performance.now();
      if (!clock.playing || at - measured > FIGURES) {
        measured = at;
        session.setState({ frames: { ...figures, interval: loop.frameInterval } });
      }
      if (grower.current && catchingUp === null) root.dataset.ready = 'true';
    },
    () => picture.moving || session.getState().catchingUp !== null,
    // The gallery covers all of the window; the first tree stands before it is closed.
    () => session.getState().dialog === 'gallery' && root.dataset.ready === 'true',
  );
  const { picture, lack, reason } = await openPicture(
    host,
    sceneEvents(document, actions, session, loop.invalidate, () => studio),
  );
  const shared = { document, session, preferences, actions, picture, onFrame: loop.onFrame };
  const studio: Studio = createStudio(shared, picture);
  const editor: Editor = { ...shared, studio };
  const grower: Grower = new Grower(document, session, actions, (tree, of, draft) => {
    if (!draft) grown = [tree, of];
    picture.setTree(tree, of, { draft });
    studio.setTree(tree.packed);
    loop.invalidate();
  });

  followWidth(session);
  followStem(session);
  const app = window.document.createElement('wg-app') as HTMLElement & {
    editor: Editor;
    updateComplete: Promise<boolean>;
  };
  app.editor = editor;
  app.addEventListener('own-file', (event) => open((event as CustomEvent<File>).detail));
  place.replaceChildren(app);
  await app.updateComplete;

  const inkFor = followSkyInk(document);
  followTheme(document, (dark) => {
    inkFor(dark);
    picture.setDark(dark);
    loop.invalidate();
  });
  followInsets(app, session, (insets) => {
    session.setState({ insets });
    picture.setInsets(insets);
    loop.invalidate();
  });
  const restart = followDocument(editor, clock, (changed) => {
    if (changed.grow) root.dataset.ready = 'false';
    address.write(now());
    loop.invalidate();
  });
  // While time runs the address follows it, a second at a time.
  let second = 0;
  loop.onFrame((time) => {
    if (!clock.playing || Math.floor(time) === second) return;
    second = Math.floor(time);
    address.write(now());
  });
  window.addEventListener('pagehide', () => address.flush());
  followGallery({ session, actions, address, now, uncovered: loop.invalidate });
  window.addEventListener('hashchange', () => {
    if (address.gallery !== null || address.isWritten) return;
    const next = address.read(decoding);
    document.setState(next.document);
    restart();
    tellFaults(next.faults);
  });
  watch(
    session,
    (s) => s.tree,
    (tree) => {
      if (!tree) return;
      const label = messageWords.picture(tree.species.name, tree.seed);
      picture.canvas.setAttribute('aria-label', label);
    },
  );
  followTitle(document, session);
  listenToHolds(actions);
  listenToKeys(editor);
  listenToOrbitKeys(picture, actions);
  listenToDrops(open);
  listenToPastes(actions);
  installTestHook(editor, picture, loop, () => grower.current);

  const tellFaults = (faults: readonly LinkFault[]): void => {
    if (faults.length === 0) return;
    actions.notify('error', messageWords.link, linkFaultLines(faults));
  };
  // Who asks for nothing, and left nothing here, chooses first.
  if (address.gallery !== null) actions.openGallery(address.gallery || null);
  else if (!index.error && !address.asks && begin?.kind === 'fresh') actions.openGallery();
  if (index.error) tell(messageWords.noSpecies, index.error);
  for (const error of broken) tell(messageWords.noWind, error);
  tellFaults(first.faults);
  if (lessMotion && document.getState().paused)
    session.setState({ hint: messageWords.hints.still, offer: !preferences.visited });
  else if (!preferences.visited && lack !== 'still') session.setState({ hint: messageWords.hints.first, offer: true });
  preferences.visited = true;
  savePreferences(preferences);
  if (lack === 'slow') actions.notify('warning', messageWords.slow, [reason]);
  if (lack === 'still') {
    actions.notify('warning', messageWords.still, [reason, messageWords.stillSays]);
    document.setState({ paused: true });
  }
  restart();
  // Without the list there is one message, not two; a species of the reader's own needs no list.
  if (!index.error || document.getState().ownSpecies !== null) await grower.grow();
}
