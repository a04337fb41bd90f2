import type { LinkDocument } from '../../core/link/link.ts';
import type { PackedTree } from '../../core/pack/packed.ts';
import { Probe } from '../../core/wind/probe.ts';
import { PROBE_RATE } from '../../core/wind/probe-history.ts';
import { defaultPiece, indexPieces, type PieceIndex, placeOfPiece } from '../../core/wind/probe-place.ts';
import { ProbeRecorder } from '../../core/wind/probe-recorder.ts';
import type { Wind } from '../../core/wind/wind.ts';
import type { Picture } from '../../view/picture/picture.ts';
import { windDirection } from '../../view/wind-direction.ts';
import { watch } from '../document-store.ts';
import type { Editor } from '../editor.ts';
import { fadeOf } from '../fade.ts';
import { FeltByProbe } from './felt.ts';
import { createStudioStore, type StudioStore } from './studio-state.ts';
import { followTrust } from './trust.ts';

/** Milliseconds a frame for the past after a jump: the picture stays smooth while the plots fill up. */
const CATCH_UP = 4;

/** What the studio needs of the editor. */
export type StudioHost = Pick<Editor, 'document' | 'session' | 'preferences' | 'actions' | 'onFrame'>;

/** The winds that can be looked at: the document's, and the one beside it. */
export type Side = 'a' | 'b';

/** What measures the wind and the answer of one branch, for the drawer to show. */
export interface Studio {
  /** Takes the tree on the screen: call it wherever `picture.setTree` is called. */
  setTree(packed: PackedTree): void;
  readonly store: StudioStore;
  readonly picture: Picture;
  readonly tree: PackedTree | null;
  readonly index: PieceIndex | null;
  /** History of the probe under the document's wind, and under the one beside it; null: there is none. */
  recorder(side: Side): ProbeRecorder | null;
  /** The wind as the tree feels it, fades included. */
  felt(side: Side): FeltByProbe;
  /** Direction that `along` means in all plots, radians. */
  axis(): number;
  /** Called after each frame in which readings were added or lost, while the drawer is open; returns how to stop. */
  onReadings(listener: () => void): () => void;
  /** Forgets the past of both probes and computes it anew. */
  forget(): void;
}

/** The wind that blows: none where it is switched off. */
const blowing = (d: LinkDocument, wind: Wind): Wind => (d.blowing ? wind : { ...wind, strength: 0 });

/** Makes the studio; it follows the document and the frames by itself, and rests while its drawer is closed. */
export function createStudio(editor: StudioHost, picture: Picture): Studio {
  const { document, actions } = editor;
  const store = createStudioStore({ open: editor.preferences.folds.studio ?? false });
  const first = document.getState();
  const felt = {
    a: new FeltByProbe(blowing(first, first.wind)),
    b: new FeltByProbe(blowing(first, first.compare?.wind ?? first.wind)),
  };
  let tree: PackedTree | null = null;
  let index: PieceIndex | null = null;
  const recorders: Record<Side, ProbeRecorder | null> = { a: null, b: null };
  const epochs: Record<Side, number> = { a: felt.a.epoch, b: felt.b.epoch };
  const listeners = new Set<() => void>();

  const recorderOf = (side: Side, piece: number): ProbeRecorder | null =>
    tree && new ProbeRecorder(new Probe(tree, piece, felt[side]));

  /** Puts both probes where the document says, or where they are of most use. */
  const place = (): void => {
    if (!tree || !index) return;
    const { probe, compare } = document.getState();
    const piece = probe !== null && probe < tree.pieceCount ? probe : defaultPiece(tree, index);
    recorders.a = recorderOf('a', piece);
    recorders.b = compare ? recorderOf('b', piece) : null;
    store.setState({ place: placeOfPiece(tree, index, piece), trust: null });
  };

  const forget = (): void => {
    recorders.a?.forget();
    recorders.b?.forget();
  };

  // As followDocument tells the picture.
  document.subscribe((now, before) => {
    const time = actions.time();
    const stopped = now.paused && !before.paused;
    const switched = now.blowing !== before.blowing;
    if (now.wind !== before.wind || switched || stopped) {
      felt.a.set(blowing(now, now.wind), time, now.paused ? 0 : fadeOf(now.wind, before.wind));
    }
    if (now.compare !== before.compare || (now.compare && (switched || stopped))) {
      const fade = now.compare && before.compare && !now.paused ? fadeOf(now.compare.wind, before.compare.wind) : 0;
      felt.b.set(blowing(now, now.compare?.wind ?? now.wind), time, fade);
    }
    if (now.probe !== before.probe || Boolean(now.compare) !== Boolean(before.compare)) place();
  });

  const tellNatural = (): void => {
    const natural = recorders.a?.probe.natural ?? null;
    if (store.getState().natural !== natural) store.setState({ natural });
  };

  /** Brings one history up to the clock; where the wind says that the past is another one, from its beginning. */
  const follow = (side: Side, step: number, more: () => boolean): number => {
    const recorder = recorders[side];
    felt[side].follow(step / PROBE_RATE);
    if (!recorder) return 1;
    if (epochs[side] !== felt[side].epoch) recorder.forget();
    epochs[side] = felt[side].epoch;
    return recorder.follow(step, more);
  };

  const record = (time: number): void => {
    const { open } = store.getState();
    if (!open || !recorders.a) return;
    const step = Math.floor(time * PROBE_RATE + 1e-6);
    const end = performance.now() + CATCH_UP;
    const more = (): boolean => performance.now() < end;
    const done = Math.min(follow('a', step, more), follow('b', step, more));
    const catchingUp = done < 1 ? done : null;
    if (store.getState().catchingUp !== catchingUp) store.setState({ catchingUp });
    tellNatural();
    for (const listener of listeners) listener();
  };
  editor.onFrame(record);
  // While time stands there may be no frames: what is left to compute goes on without them.
  let waiting = false;
  const goOn = (): void => {
    waiting = false;
    record(actions.time());
    if (store.getState().catchingUp !== null) wake();
  };
  const wake = (): void => {
    if (!waiting) requestAnimationFrame(goOn);
    waiting = true;
  };
  document.subscribe(wake);
  watch(store, (s) => s.open, wake);
  watch(store, (s) => s.place, wake);
  watch(store, (s) => s.catchingUp, wake);

  const studio: Studio = {
    store,
    picture,
    get tree() {
      return tree;
    },
    get index() {
      return index;
    },
    setTree(packed) {
      tree = packed;
      index = indexPieces(packed);
      place();
    },
    recorder: (side) => recorders[side],
    felt: (side) => felt[side],
    axis: () => {
      const { wind, compare } = document.getState();
      return windDirection(wind) ?? (compare ? windDirection(compare.wind) : null) ?? 0;
    },
    onReadings(listener) {
      listeners.add(listener);
      return () => listeners.delete(listener);
    },
    forget,
  };
  followTrust(studio, editor);
  return studio;
}
