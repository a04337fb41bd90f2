import { THEMES, type Theme } from '../core/link/link.ts';
import { QUALITIES, type Quality } from '../view/picture/quality.ts';

/** What the editor remembers on this machine; never in a link. */
export interface Preferences {
  theme: Theme;
  /** How finely the picture is drawn. */
  quality: Quality;
  /** Names of the folds that are closed, or open where they start closed. */
  folds: Record<string, boolean>;
  /** Height of the studio's drawer in pixels; null: as the window's height suggests. */
  studioHeight: number | null;
  /** Width of the left panel in pixels; null: as the window's width suggests. */
  growWidth: number | null;
  /** What was chosen last in the export, by kind of file; what reads it checks it. */
  exports: Record<string, Record<string, unknown>>;
  /** Keys act without a control being focused. */
  shortcuts: boolean;
  /** The reader has been here before. */
  visited: boolean;
}

const KEY = 'windgrove';
const fresh = (): Preferences => ({
  theme: 'auto',
  quality: 'auto',
  folds: {},
  studioHeight: null,
  growWidth: null,
  exports: {},
  shortcuts: true,
  visited: false,
});

const isRecord = (entry: [string, unknown]): entry is [string, Record<string, unknown>] =>
  typeof entry[1] === 'object' && entry[1] !== null;

const pixels = (value: unknown): number | null => (Number.isFinite(value) ? (value as number) : null);

/** What was remembered; a fresh start where that is nothing, broken or forbidden. */
export function loadPreferences(): Preferences {
  try {
    const found: unknown = JSON.parse(localStorage.getItem(KEY) ?? '{}');
    if (typeof found !== 'object' || found === null) return fresh();
    const { theme, quality, folds, studioHeight, growWidth, shortcuts, exports, visited } = found as Partial<
      Record<keyof Preferences, unknown>
    >;
    const entries = Object.entries(folds ?? {}).filter((e): e is [string, boolean] => typeof e[1] === 'boolean');
    return {
      theme: THEMES.find((t) => t === theme) ?? 'auto',
      quality: QUALITIES.find((q) => q === quality) ?? 'auto',
      folds: Object.fromEntries(entries),
      studioHeight: pixels(studioHeight),
      growWidth: pixels(growWidth),
      exports: Object.fromEntries(Object.entries(exports ?? {}).filter(isRecord)),
      shortcuts: shortcuts !== false,
      visited: visited === true,
    };
  } catch {
    return fresh();
  }
}

export function savePreferences(preferences: Preferences): void {
  try {
    localStorage.setItem(KEY, JSON.stringify(preferences));
  } catch {
    // A private window or a full disk: the editor works, it just forgets.
  }
}
