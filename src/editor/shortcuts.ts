import { ALL_LEVELS } from '../core/link/link.ts';
import type { Editor } from './editor.ts';
import { type Key, keyText, onMac } from './keys.ts';
import { showPanel, showSearch } from './ui/show-panel.ts';
import { commandWords } from './words/commands.ts';

export type CommandGroup = keyof typeof commandWords.groups;
export type CommandId = keyof typeof commandWords.labels;

/** Something that a reader can tell the page to do: the table listens to keys, draws the help and fills menus and palette. */
export interface Command {
  readonly id: CommandId;
  readonly group: CommandGroup;
  readonly keys: readonly Key[];
  /** Absent: the focused control does it by itself; the table only tells. */
  readonly act?: (editor: Editor) => void;
  /** Whether it can be done now; absent: always. */
  readonly enabled?: (editor: Editor) => boolean;
  /** A key that stays down does it again and again. */
  readonly repeats?: true;
  /** A key that stays down does it for as long: let go, it is done once more, which takes it back. */
  readonly whileHeld?: true;
}

const key = (name: string, shown?: string): Key => (shown === undefined ? { key: name } : { key: name, shown });
const mod = (name: string): Key => ({ key: name, mod: true });
const modShift = (name: string): Key => ({ key: name, mod: true, shift: true });

const edited = (e: Editor): boolean => Object.keys(e.document.getState().edits).length > 0;
const level = (e: Editor, towards: number): void =>
  e.actions.setLevel(Math.min(3, Math.max(0, e.session.getState().level + towards)));

export const COMMANDS: readonly Command[] = [
  { id: 'new', group: 'file', keys: [], act: (e) => e.actions.newTree() },
  { id: 'open', group: 'file', keys: [mod('o')], act: (e) => void e.actions.open() },
  { id: 'save', group: 'file', keys: [mod('s')], act: (e) => void e.actions.save() },
  { id: 'saveAs', group: 'file', keys: [modShift('s')], act: (e) => void e.actions.saveAs() },
  { id: 'share', group: 'file', keys: [key('c')], act: (e) => void e.actions.share() },
  { id: 'embed', group: 'file', keys: [], act: (e) => void e.actions.copyEmbed() },
  { id: 'export', group: 'file', keys: [mod('e')], act: (e) => e.actions.openDialog('export') },

  {
    id: 'undo',
    group: 'edit',
    keys: [mod('z')],
    act: (e) => e.actions.undo(),
    enabled: (e) => e.session.getState().canUndo,
    repeats: true,
  },
  {
    id: 'redo',
    group: 'edit',
    keys: [modShift('z'), mod('y')],
    act: (e) => e.actions.redo(),
    enabled: (e) => e.session.getState().canRedo,
    repeats: true,
  },
  { id: 'history', group: 'edit', keys: [key('y')], act: (e) => e.actions.openDialog('history') },
  { id: 'snapshot', group: 'edit', keys: [key('k')], act: (e) => e.actions.takeSnapshot('') },
  { id: 'palette', group: 'edit', keys: [mod('k')], act: (e) => e.actions.openDialog('palette') },
  { id: 'search', group: 'edit', keys: [key('/')], act: (e) => void showSearch(e) },

  { id: 'gallery', group: 'tree', keys: [key('p')], act: (e) => e.actions.openGallery() },
  { id: 'seed', group: 'tree', keys: [key('d')], act: (e) => e.actions.rollSeed() },
  { id: 'variety', group: 'tree', keys: [key('m')], act: (e) => e.actions.openDialog('variety') },
  {
    id: 'peek',
    group: 'tree',
    keys: [key('\\')],
    act: (e) => e.actions.setPeek(!e.session.getState().peek),
    enabled: (e) => edited(e) || e.session.getState().peek,
    whileHeld: true,
  },
  { id: 'reset', group: 'tree', keys: [], act: (e) => e.actions.resetAll(), enabled: edited },
  { id: 'levelUp', group: 'tree', keys: [key('[')], act: (e) => level(e, -1) },
  { id: 'levelDown', group: 'tree', keys: [key(']')], act: (e) => level(e, 1) },
  { id: 'levels', group: 'tree', keys: [key('1'), key('2'), key('3'), key('4')] },
  {
    id: 'leaves',
    group: 'tree',
    keys: [key('l')],
    act: (e) => e.actions.setShowLeaves(!e.document.getState().showLeaves),
  },

  {
    id: 'blow',
    group: 'wind',
    keys: [key('b')],
    act: (e) => e.actions.setBlowing(!e.document.getState().blowing),
  },
  { id: 'gust', group: 'wind', keys: [key('g')], act: (e) => e.actions.throwGust() },
  {
    id: 'aim',
    group: 'wind',
    keys: [key('t')],
    act: (e) => e.actions.setThrowing(!e.session.getState().throwing),
  },
  {
    id: 'arrows',
    group: 'wind',
    keys: [key('a')],
    act: (e) => e.actions.setOverlays({ arrows: !e.document.getState().overlays.arrows }),
  },
  {
    id: 'handle',
    group: 'wind',
    keys: [key('h')],
    act: (e) => e.actions.setOverlays({ handle: !e.document.getState().overlays.handle }),
  },
  { id: 'studio', group: 'wind', keys: [key('u')], act: (e) => void showPanel(e, 'studio') },
  { id: 'deleteGust', group: 'wind', keys: [key('delete')] },

  { id: 'play', group: 'time', keys: [key(' ')], act: (e) => e.actions.toggle() },
  { id: 'stepOn', group: 'time', keys: [key('.')], act: (e) => e.actions.step(1), repeats: true },
  { id: 'stepBack', group: 'time', keys: [key(',')], act: (e) => e.actions.step(-1), repeats: true },
  { id: 'slow', group: 'time', keys: [key('s')], act: (e) => e.actions.toggleSlow() },
  { id: 'start', group: 'time', keys: [key('0')], act: (e) => e.actions.seek(0) },

  { id: 'leave', group: 'view', keys: [key('escape')] },
  { id: 'shaded', group: 'view', keys: [key('q')], act: (e) => e.actions.setView('shaded') },
  { id: 'wireframe', group: 'view', keys: [key('w')], act: (e) => e.actions.setView('wireframe') },
  { id: 'control', group: 'view', keys: [key('e')], act: (e) => e.actions.setView('control') },
  { id: 'levelColours', group: 'view', keys: [key('r')], act: (e) => e.actions.setView('levels') },
  {
    id: 'whole',
    group: 'view',
    keys: [key('f')],
    act: (e) => e.actions.setCamera(null),
    enabled: (e) => e.document.getState().camera !== null,
  },
  { id: 'photo', group: 'view', keys: [key('v')], act: (e) => e.actions.setPhoto(!e.session.getState().photo) },
  { id: 'seasonSpring', group: 'view', keys: [], act: (e) => e.actions.setSeason('spring') },
  { id: 'seasonSummer', group: 'view', keys: [], act: (e) => e.actions.setSeason('summer') },
  { id: 'seasonAutumn', group: 'view', keys: [], act: (e) => e.actions.setSeason('autumn') },
  { id: 'seasonWinter', group: 'view', keys: [], act: (e) => e.actions.setSeason('winter') },
  { id: 'stageMeadow', group: 'view', keys: [], act: (e) => e.actions.setStage('meadow') },
  { id: 'stagePark', group: 'view', keys: [], act: (e) => e.actions.setStage('park') },
  { id: 'stageGolden', group: 'view', keys: [], act: (e) => e.actions.setStage('golden') },
  { id: 'stageStudio', group: 'view', keys: [], act: (e) => e.actions.setStage('studio') },
  { id: 'themeAuto', group: 'view', keys: [], act: (e) => e.actions.setTheme('auto') },
  { id: 'themeLight', group: 'view', keys: [], act: (e) => e.actions.setTheme('light') },
  { id: 'themeDark', group: 'view', keys: [], act: (e) => e.actions.setTheme('dark') },
  { id: 'walk', group: 'view', keys: [key('arrows', commandWords.slider.walk), key('+'), key('-')] },

  { id: 'help', group: 'help', keys: [key('?')], act: (e) => e.actions.openDialog('help') },
  { id: 'tour', group: 'help', keys: [], act: (e) => e.actions.openDialog('tour') },

  { id: 'little', group: 'sliders', keys: [key('arrows', commandWords.slider.arrows)] },
  { id: 'much', group: 'sliders', keys: [key('arrows', commandWords.slider.shifted)] },
];

const byId = new Map(COMMANDS.map((command) => [command.id, command]));

export const command = (id: CommandId): Command => byId.get(id)!;

/** Draws as many levels as a digit says: 4, or the deepest that the tree has, is all of them. */
export function drawLevels(editor: Editor, digit: number): void {
  const count = editor.session.getState().tree?.figures.levels ?? 3;
  editor.actions.setLevels(digit >= Math.min(4, count) ? ALL_LEVELS : digit);
}

/** The keys of a command as this machine writes them. */
export const keysOf = (id: CommandId): string[] => command(id).keys.map((k) => keyText(k, onMac()));

/** `What it does (K)`: a tooltip. */
export function withKeys(id: CommandId, says: string = commandWords.labels[id]): string {
  const keys = keysOf(id);
  return keys.length > 0 ? `${says} (${keys[0]})` : says;
}
