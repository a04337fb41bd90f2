import { html, type TemplateResult } from 'lit';
import { WIND_NUMBERS } from '../../core/link/wind-numbers.ts';
import { BEAUFORT, speedOfBeaufort } from '../../core/wind/speed.ts';
import { wizardWords } from '../words/wind-panel.ts';
import { dial } from './dial.ts';
import { icon } from './icons.ts';
import { numberField } from './number-field.ts';
import { Part } from './panel.ts';
import { ruleField } from './rule-field.ts';

const MOST_BEAUFORT = 11;
const DEGREE = Math.PI / 180;

/** A wind from what one says of it in a few words; every value can then be changed. */
class Wizard extends Part {
  protected override render(): TemplateResult {
    const { actions } = this.editor;
    const { wizard } = this.session;
    const force = BEAUFORT[Math.round(wizard.beaufort)]!;
    const degrees = Math.round((((wizard.direction / DEGREE) % 360) + 360) % 360);
    const share = (key: 'steadiness' | 'turbulence'): TemplateResult =>
      numberField({
        id: `wizard-${key}`,
        label: wizardWords[key][0],
        name: wizardWords[key][2],
        unit: '%',
        value: Math.round(100 * wizard[key]),
        min: 0,
        max: 100,
        step: 1,
        decimals: 0,
        help: wizardWords[key][1],
        onInput: (value) => actions.useWizard({ [key]: value / 100 }),
      });
    return html`<p class="soft">${wizardWords.about}</p>
      ${numberField({
        id: 'wizard-beaufort',
        label: wizardWords.beaufort,
        name: wizardWords.beaufortName,
        unit: '',
        value: wizard.beaufort,
        min: 0,
        max: MOST_BEAUFORT,
        step: 1,
        decimals: 1,
        help: wizardWords.beaufortHelp,
        onInput: (beaufort) => actions.useWizard({ beaufort }),
      })}
      <p class="says"><strong>${force.name}</strong>${wizardWords.feels(speedOfBeaufort(wizard.beaufort), force.seen)}</p>
      ${share('steadiness')}
      ${share('turbulence')}
      ${ruleField(WIND_NUMBERS.stiffness, {
        id: 'wizard-stiffness',
        label: wizardWords.stiffness,
        name: wizardWords.stiffnessName,
        value: wizard.stiffness,
        reset: 1,
        onInput: (stiffness) => actions.useWizard({ stiffness }),
      })}
      <div class="field whole"><span class="label">${wizardWords.direction}</span>
        ${dial({
          id: 'wizard-direction',
          name: wizardWords.directionDial,
          value: degrees,
          onInput: (value) => actions.useWizard({ direction: value * DEGREE }),
        })}
        <button type="button" class="quiet" title=${wizardWords.otherWavesTitle}
          @click=${() => actions.useWizard({ seed: wizard.seed + 1 })}>${icon('dice')}<span>${wizardWords.otherWaves}</span></button>
      </div>`;
  }
}

customElements.define('wg-wizard', Wizard);
