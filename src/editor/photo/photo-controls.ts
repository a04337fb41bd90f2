import { html, type TemplateResult } from 'lit';
import { toggle } from '../ui/choice.ts';
import { amount, slider } from '../ui/number-field.ts';
import { photoWords } from '../words/scene.ts';
import { LONGEST, SHORTEST } from './focal-length.ts';
import { A_THIRD, exposureText, MOST_EXPOSURE, NO_SETTINGS, type PhotoSettings } from './photo-settings.ts';

/** A step of the lens: a part of an octave, as each millimetre means less the more there are. */
const LENS_STEP = 0.05;

const tidy = (x: number, digits: number): number => Number(x.toFixed(digits));

/** Exposure and lens as sliders with boxes, and what goes with them. `own`: the stage's own focal length in mm. */
export function photoControls(
  settings: PhotoSettings,
  own: number,
  set: (change: Partial<PhotoSettings>) => void,
): TemplateResult {
  const { exposure, lens, keepsSize, thirds } = settings;
  const focal = lens ?? own;
  const setLens = (millimetres: number): void =>
    set({ lens: Math.abs(millimetres - own) < 1e-9 ? null : Math.min(LONGEST, Math.max(SHORTEST, millimetres)) });
  const setExposure = (steps: number): void => {
    const thirds = Math.round(3 * steps);
    set({ exposure: tidy(Math.abs(3 * steps - thirds) < 0.1 ? thirds / 3 : steps, 2) });
  };
  return html`<div class="field" title=${photoWords.reset}>
      <label for="photo-exposure" title=${photoWords.exposureHelp}>${photoWords.exposure}</label>
      ${slider({
        id: 'photo-exposure',
        name: photoWords.exposure,
        unit: 'EV',
        value: exposure,
        min: -MOST_EXPOSURE,
        max: MOST_EXPOSURE,
        step: A_THIRD,
        reset: 0,
        shown: exposureText(exposure),
        onInput: setExposure,
      })}
      ${amount({
        id: 'photo-exposure-number',
        name: photoWords.exposure,
        unit: 'EV',
        shown: String(exposure),
        min: -MOST_EXPOSURE,
        max: MOST_EXPOSURE,
        step: A_THIRD,
        onTyped: setExposure,
        onEmptied: () => set({ exposure: NO_SETTINGS.exposure }),
      })}
    </div>
    <div class="field" title=${photoWords.reset}>
      <label for="photo-lens" title=${photoWords.lensHelp}>${photoWords.lens}</label>
      ${slider({
        id: 'photo-lens',
        name: photoWords.lens,
        unit: 'mm',
        value: Math.log2(focal),
        min: Math.log2(SHORTEST),
        max: Math.log2(LONGEST),
        step: LENS_STEP,
        reset: Math.log2(own),
        marks: { tick: Math.log2(own) },
        shown: focal.toFixed(0),
        onInput: (octaves) => setLens(octaves === Math.log2(own) ? own : Math.round(2 ** octaves)),
      })}
      ${amount({
        id: 'photo-lens-number',
        name: photoWords.lens,
        unit: 'mm',
        shown: focal.toFixed(0),
        min: SHORTEST,
        max: LONGEST,
        step: 1,
        onTyped: setLens,
        onEmptied: () => set({ lens: NO_SETTINGS.lens }),
      })}
    </div>
    ${toggle('photo-keeps-size', photoWords.keepsSize, keepsSize, (on) => set({ keepsSize: on }), {
      title: photoWords.keepsSizeHelp,
    })}
    ${toggle('photo-thirds', photoWords.thirds, thirds, (on) => set({ thirds: on }), { title: photoWords.thirdsHelp })}`;
}
