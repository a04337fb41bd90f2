import { ALL_LEVELS } from '../core/link/link.ts';
import type { Editor } from './editor.ts';

/** A key and what it does: the table that listens and that the help shows. */
export interface Shortcut {
  readonly group: 'Time' | 'Tree' | 'Wind' | 'View' | 'Sliders';
  readonly keys: readonly { readonly key: string; readonly shown: string }[];
  readonly label: string;
  /** Absent: the focused control does it by itself; the table only tells. */
  readonly act?: (editor: Editor) => void;
}

const key = (name: string, shown = name.toUpperCase()) => ({ key: name, shown });

export const shortcuts: readonly Shortcut[] = [
  { group: 'Time', keys: [key(' ', 'Space')], label: 'Play or pause', act: (e) => e.actions.toggle() },
  { group: 'Time', keys: [key('.')], label: 'One step on', act: (e) => e.actions.step(1) },
  { group: 'Time', keys: [key(',')], label: 'One step back', act: (e) => e.actions.step(-1) },
  { group: 'Time', keys: [key('s')], label: 'Slow motion', act: (e) => e.actions.toggleSlow() },
  { group: 'Time', keys: [key('0')], label: 'Back to the start', act: (e) => e.actions.seek(0) },
  { group: 'Tree', keys: [key('d')], label: 'Another tree (dice)', act: (e) => e.actions.rollSeed() },
  {
    group: 'Tree',
    keys: [key('1'), key('2'), key('3'), key('4')],
    label: 'Trunk alone, with limbs, with branches, all',
  },
  {
    group: 'Tree',
    keys: [key('l')],
    label: 'Leaves on or off',
    act: (e) => e.actions.setShowLeaves(!e.document.getState().showLeaves),
  },
  {
    group: 'Wind',
    keys: [key('b')],
    label: 'Wind on or off',
    act: (e) => e.actions.setBlowing(!e.document.getState().blowing),
  },
  { group: 'Wind', keys: [key('g')], label: 'Throw a gust from upwind', act: (e) => e.actions.throwGust() },
  {
    group: 'Wind',
    keys: [key('t')],
    label: 'Aim gusts: each click on the ground throws one',
    act: (e) => e.actions.setThrowing(!e.session.getState().throwing),
  },
  {
    group: 'Wind',
    keys: [key('a')],
    label: 'Arrows of the wind over the ground',
    act: (e) => e.actions.setOverlays({ arrows: !e.document.getState().overlays.arrows }),
  },
  {
    group: 'Wind',
    keys: [key('h')],
    label: 'The handle that turns the wind',
    act: (e) => e.actions.setOverlays({ handle: !e.document.getState().overlays.handle }),
  },
  { group: 'Wind', keys: [key('delete', 'Del')], label: 'On the ruler: take the gust away' },
  { group: 'View', keys: [key('escape', 'Esc')], label: 'Leave: aiming, a chosen gust' },
  { group: 'View', keys: [key('q')], label: 'Shaded', act: (e) => e.actions.setView('shaded') },
  { group: 'View', keys: [key('w')], label: 'Wireframe', act: (e) => e.actions.setView('wireframe') },
  {
    group: 'View',
    keys: [key('e')],
    label: 'Curves: control polygons and frames',
    act: (e) => e.actions.setView('control'),
  },
  { group: 'View', keys: [key('r')], label: 'Levels in their colours', act: (e) => e.actions.setView('levels') },
  { group: 'View', keys: [key('f')], label: 'The whole tree', act: (e) => e.actions.setCamera(null) },
  { group: 'View', keys: [key('c')], label: 'Copy the link', act: (e) => void e.actions.share() },
  { group: 'View', keys: [key('?')], label: 'This help', act: (e) => e.actions.setHelp(!e.session.getState().help) },
  {
    group: 'View',
    keys: [key('arrows', '← ↑ → ↓'), key('+'), key('-')],
    label: 'In the picture: walk around, closer, away',
  },
  { group: 'Sliders', keys: [key('arrows', '← →')], label: 'A little less, a little more' },
  { group: 'Sliders', keys: [key('arrows', 'Shift ← →')], label: 'Ten times as much' },
];

/** Whether `target` uses `pressed` itself: letters in text boxes, Space on buttons, arrows and digits where they mean something. */
function taken(target: EventTarget | null, pressed: string): boolean {
  if (!(target instanceof HTMLElement)) return false;
  if (target.closest('dialog') && pressed !== '?') return true;
  if (target.isContentEditable || target.matches('textarea, select')) return true;
  if (target instanceof HTMLInputElement && !['range', 'checkbox', 'radio', 'file'].includes(target.type)) return true;
  return pressed === ' ' && target.matches('button, summary, input, label, a');
}

/** Listens to the whole page; returns how to stop. */
export function listenToKeys(editor: Editor): () => void {
  const onKey = (event: KeyboardEvent): void => {
    if (event.ctrlKey || event.metaKey || event.altKey || event.defaultPrevented) return;
    // A dialog and a menu close by themselves; what is left of Escape leaves the modes of the page, wherever the focus is.
    if (event.key === 'Escape') {
      const own = event.target instanceof HTMLElement && event.target.closest('dialog[open], :popover-open');
      if (!own && editor.actions.leave()) event.preventDefault();
      return;
    }
    if (!editor.preferences.shortcuts || taken(event.target, event.key)) return;
    const level = Number(event.key);
    if (level >= 1 && level <= 4) {
      const count = editor.session.getState().tree?.figures.levels ?? 3;
      editor.actions.setLevels(level >= Math.min(4, count) ? ALL_LEVELS : level);
      return;
    }
    const found = shortcuts.find((s) => s.act && s.keys.some((k) => k.key === event.key.toLowerCase()));
    if (!found) return;
    event.preventDefault();
    found.act!(editor);
  };
  window.addEventListener('keydown', onKey);
  return () => window.removeEventListener('keydown', onKey);
}
