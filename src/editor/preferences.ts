import { THEMES, type Theme } from '../core/link/link.ts';

/** What the editor remembers on this machine; never in a link. */
export interface Preferences {
  theme: Theme;
  /** Names of the folds that are closed, or open where they start closed. */
  folds: Record<string, boolean>;
  /** Height of the studio's drawer in pixels; null: as the window's height suggests. */
  studioHeight: number | null;
  /** Keys act without a control being focused. */
  shortcuts: boolean;
  /** The reader has been here before. */
  visited: boolean;
}

const KEY = 'windgrove';
const fresh = (): Preferences => ({ theme: 'auto', folds: {}, studioHeight: null, shortcuts: true, visited: false });

/** What was remembered; a fresh start where that is nothing, broken or forbidden. */
export function loadPreferences(): Preferences {
  try {
    const found: unknown = JSON.parse(localStorage.getItem(KEY) ?? '{}');
    if (typeof found !== 'object' || found === null) return fresh();
    const { theme, folds, studioHeight, shortcuts, visited } = found as Partial<Record<keyof Preferences, unknown>>;
    const entries = Object.entries(folds ?? {}).filter((e): e is [string, boolean] => typeof e[1] === 'boolean');
    return {
      theme: THEMES.find((t) => t === theme) ?? 'auto',
      folds: Object.fromEntries(entries),
      studioHeight: Number.isFinite(studioHeight) ? (studioHeight as number) : null,
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
