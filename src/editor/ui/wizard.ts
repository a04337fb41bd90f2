import { html, type TemplateResult } from 'lit';
import { WIND_NUMBERS } from '../../core/link/wind-numbers.ts';
import { BEAUFORT, speedOfBeaufort } from '../../core/wind/speed.ts';
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
    const share = (key: 'steadiness' | 'turbulence', label: string, help: string): TemplateResult =>
      numberField({
        id: `wizard-${key}`,
        label,
        name: `Wizard ${key}`,
        unit: '%',
        value: Math.round(100 * wizard[key]),
        min: 0,
        max: 100,
        step: 1,
        decimals: 0,
        help,
        onInput: (value) => actions.useWizard({ [key]: value / 100 }),
      });
    return html`<p class="soft">Say what it is like; all values follow, and each can then be changed.</p>
      ${numberField({
        id: 'wizard-beaufort',
        label: 'Beaufort',
        name: 'Wizard Beaufort number',
        unit: '',
        value: wizard.beaufort,
        min: 0,
        max: MOST_BEAUFORT,
        step: 1,
        decimals: 1,
        help: 'How strong it is: 0 is calm, 11 a violent storm',
        onInput: (beaufort) => actions.useWizard({ beaufort }),
      })}
      <p class="says"><strong>${force.name}</strong>, ${speedOfBeaufort(wizard.beaufort).toFixed(1)} m/s. ${force.seen}</p>
      ${share('steadiness', 'Steadiness', 'None: gusts and lulls; full: the same all day')}
      ${share('turbulence', 'Turbulence', 'None: smooth air from the sea; full: eddies behind houses and woods')}
      ${ruleField(WIND_NUMBERS.stiffness, {
        id: 'wizard-stiffness',
        label: 'Stiffness',
        name: 'Wizard stiffness of the tree',
        value: wizard.stiffness,
        reset: 1,
        onInput: (stiffness) => actions.useWizard({ stiffness }),
      })}
      <div class="field whole"><span class="label">Direction</span>
        ${dial({
          id: 'wizard-direction',
          name: 'Wizard direction, dial',
          value: degrees,
          onInput: (value) => actions.useWizard({ direction: value * DEGREE }),
        })}
        <button type="button" class="quiet" title="The same character with other waves"
          @click=${() => actions.useWizard({ seed: wizard.seed + 1 })}>${icon('dice')}<span>Other waves</span></button>
      </div>`;
  }
}

customElements.define('wg-wizard', Wizard);
