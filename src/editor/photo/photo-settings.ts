import { exposedLook } from '../../view/exposed-look.ts';
import { putOn } from '../../view/lens.ts';
import type { Shot } from '../../view/stage.ts';
import type { Aspect } from './photo-frame.ts';

/** How the reader photographs: nothing of it is in the document, so no undo and no link meets it. */
export interface PhotoSettings {
  readonly aspect: Aspect;
  /** Steps of exposure: each lets in twice the light. */
  readonly exposure: number;
  /** Focal length in mm, 35-mm equivalent; null: as the stage has it. */
  readonly lens: number | null;
  /** Another lens leaves the tree as large as it is. */
  readonly keepsSize: boolean;
  /** Lines at thirds of the frame. */
  readonly thirds: boolean;
}

export const NO_SETTINGS: PhotoSettings = { aspect: 'free', exposure: 0, lens: null, keepsSize: true, thirds: false };

/** Steps of exposure to both sides, and of the slider: a third, as on a camera's wheel. */
export const MOST_EXPOSURE = 3;
export const A_THIRD = 1 / 3;

/** Steps as a camera shows them: `+1.3`, `−0.7`, `0`. */
export function exposureText(exposure: number): string {
  const text = Math.abs(exposure).toFixed(1).replace('.0', '');
  return text === '0' ? '0' : `${exposure < 0 ? '−' : '+'}${text}`;
}

/** What the settings do to the stage, whose own focal length in the frame is `own` mm; null: nothing. */
export function shotOf({ exposure, lens, keepsSize }: PhotoSettings, own: number): Shot | null {
  if (exposure === 0 && lens === null) return null;
  const zoom = (lens ?? own) / own;
  return { look: (look) => exposedLook(look, exposure), aim: (stage) => putOn(stage, { zoom, keepsSize }) };
}
