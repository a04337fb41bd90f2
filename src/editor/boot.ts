import { type LinkDocument, type LinkFault, roundTime } from '../core/link/link.ts';
import { presets } from '../core/wind/presets.ts';
import { Clock } from '../view/clock.ts';
import { openPicture } from '../view/picture/open-picture.ts';
import { createActions } from './actions.ts';
import { Address } from './address.ts';
import { createDocument, watch } from './document-store.ts';
import { listenToDrops } from './drop.ts';
import type { Editor } from './editor.ts';
import { firstDocument } from './first-document.ts';
import { followDocument } from './follow-document.ts';
import { Grower } from './grower.ts';
import { linkFaultLines } from './link-faults.ts';
import { Loop } from './loop.ts';
import { listenToOrbitKeys } from './orbit-keys.ts';
import { loadPreferences, savePreferences } from './preferences.ts';
import { createSession, type SpeciesEntry } from './session.ts';
import { listenToKeys } from './shortcuts.ts';
import { loadIndex, readOwnFile, SpeciesError } from './species-source.ts';
import { installTestHook } from './test-hook.ts';
import { followTheme } from './theme.ts';
import './ui/app.ts';
import { followInsets, followWidth } from './window-shape.ts';

/** Milliseconds between two readings of the figures while playing. */
const FIGURES = 500;

const HINTS = {
  first: 'Drag to walk around the tree. Pull a slider of the wind, and every branch answers.',
  still: 'Your system asks for less motion, so time stands still. Press play, or Space, to let it run.',
};

const STILL =
  'The tree is drawn once for each change. Another browser, or graphics acceleration switched on, shows it in the wind.';
const LOST = 'The graphics card was taken away; the picture comes back with it';

/** Starts the editor: the picture in `host`, the interface in `place`. */
export async function boot(host: HTMLElement, place: HTMLElement): Promise<void> {
  const root = window.document.documentElement;
  const preferences = loadPreferences();
  const lessMotion = matchMedia('(prefers-reduced-motion: reduce)').matches;
  const session = createSession();
  const clock = new Clock();
  const address = new Address();

  let species: readonly SpeciesEntry[] = [];
  let broken: unknown;
  try {
    species = await loadIndex();
  } catch (error) {
    broken = error;
  }
  session.setState({ species });
  const decoding = {
    defaults: firstDocument(preferences.theme, lessMotion),
    species: species.map((s) => s.id),
    winds: presets,
  };
  const first = address.read(decoding);
  const document = createDocument(first.document);
  /** The document as the link holds it at this moment: while playing, the clock knows the time. */
  const now = (): LinkDocument => ({ ...document.getState(), time: roundTime(clock.time) });

  const actions = createActions(document, session, preferences, clock, {
    cancelGrowing: () => grower.cancel(),
    share: async () => {
      address.write(now());
      address.flush();
      try {
        await navigator.clipboard.writeText(location.href);
        actions.notify('note', 'The link to this picture is copied');
      } catch {
        actions.notify('note', 'The browser does not let this page copy; the link is in the address bar', [
          location.href,
        ]);
      }
    },
  });
  const tell = (title: string, error: unknown): void => {
    if (error instanceof SpeciesError) actions.notify('error', error.message, error.lines);
    else actions.notify('error', title, [error instanceof Error ? error.message : String(error)]);
  };
  const openFile = (file: File): void =>
    void readOwnFile(file).then(actions.openSpecies, (error: unknown) => tell(`${file.name} could not be read`, error));

  let measured = 0;
  // Its first frame comes after all that it speaks of has been made.
  const loop = new Loop(
    clock,
    (time) => {
      const figures = picture.draw(time, clock.playing || picture.moving);
      const at = performance.now();
      if (!clock.playing || at - measured > FIGURES) {
        measured = at;
        session.setState({ frames: { ...figures, interval: loop.frameInterval } });
      }
      if (grower.current) root.dataset.ready = 'true';
    },
    () => picture.moving,
  );
  const { picture, lack, reason } = openPicture(host, {
    onChange: () => loop.invalidate(),
    onCamera: (camera) => actions.setCamera(camera),
    onLost: (lost) => {
      if (lost) actions.notify('warning', LOST);
      else actions.retract(LOST);
      loop.invalidate();
    },
  });
  const editor: Editor = { document, session, preferences, actions, onFrame: loop.onFrame };
  const grower: Grower = new Grower(document, session, actions, (tree, of) => {
    picture.setTree(tree, of);
    loop.invalidate();
  });

  followWidth(session);
  const app = window.document.createElement('wg-app') as HTMLElement & {
    editor: Editor;
    updateComplete: Promise<boolean>;
  };
  app.editor = editor;
  app.addEventListener('species-file', (event) => openFile((event as CustomEvent<File>).detail));
  place.replaceChildren(app);
  await app.updateComplete;

  followTheme(document, (dark) => {
    picture.setDark(dark);
    loop.invalidate();
  });
  followInsets(app, session, (insets) => {
    picture.setInsets(insets);
    loop.invalidate();
  });
  const restart = followDocument(editor, clock, picture, (changed) => {
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
  window.addEventListener('hashchange', () => {
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
      window.document.title = `${tree.species.name} · Windgrove`;
      const label = `${tree.species.name}, seed ${tree.seed}. Arrow keys walk around it, plus and minus come closer and go away.`;
      picture.canvas.setAttribute('aria-label', label);
    },
  );
  listenToKeys(editor);
  listenToOrbitKeys(picture, actions);
  listenToDrops(openFile);
  installTestHook(editor, picture, loop, () => grower.current);

  const tellFaults = (faults: readonly LinkFault[]): void => {
    if (faults.length === 0) return;
    actions.notify('error', 'Parts of this link could not be used; the rest applies', linkFaultLines(faults));
  };
  if (broken) tell('The list of species could not be read', broken);
  tellFaults(first.faults);
  if (lessMotion && first.document.paused) session.setState({ hint: HINTS.still });
  else if (!preferences.visited && lack !== 'still') session.setState({ hint: HINTS.first });
  preferences.visited = true;
  savePreferences(preferences);
  if (lack === 'slow') actions.notify('warning', 'The wind is slower here than it could be', [reason]);
  if (lack === 'still') {
    actions.notify('warning', 'This is a still picture', [reason, STILL]);
    document.setState({ paused: true });
  }
  restart();
  // Without the list there is one message, not two; a species of the reader's own needs no list.
  if (!broken || first.document.ownSpecies !== null) await grower.grow();
}
