import { html, type TemplateResult } from 'lit';
import { LINK_NUMBERS } from '../../core/link/numbers.ts';
import { WIND_NUMBERS } from '../../core/link/wind-numbers.ts';
import { STILL, type Wind } from '../../core/wind/wind.ts';
import { choice, toggle } from './choice.ts';
import { numberField } from './number-field.ts';
import { Part } from './panel.ts';
import { ruleField } from './rule-field.ts';

const PROFILES: Record<Wind['profile']['kind'], { label: string; says: string }> = {
  none: { label: 'None', says: 'The wind is as strong at the ground as at the top, as in the paper.' },
  log: { label: 'Logarithmic', says: 'Rough ground slows the air near it: ln(z/z0), as over open land.' },
  power: { label: 'Power law', says: 'The engineers’ rule of thumb: (z/height) to an exponent.' },
};
const KINDS = ['none', 'log', 'power'] as const;

/** The air as a whole: how it grows with height, whether it leans, and the printed forms. */
class AirPanel extends Part {
  protected override render(): TemplateResult {
    const { actions } = this.editor;
    const { wind, preset } = actions.edited();
    const original = this.session.winds.find((w) => w.id === preset)?.wind ?? STILL;
    return html`${this.profile(wind)}
      ${toggle('zero-mean', 'No lean', wind.zeroMean, (on) => actions.setZeroMean(on), {
        name: 'No lean: zero mean',
        title: 'Takes its mean push from every wave',
      })}
      <p class="says">A gust only ever pushes, so trees lean with the wind; without the lean they sway about their rest. <span class="soft">The paper’s
        equation 14 leans.</span></p>
      ${toggle('paper', 'As the paper prints it', wind.paper, (on) => actions.setPaper(on), {
        title: 'Waves that travel upwind, lengths that change, projected frames (Skjermo 2007)',
      })}
      <p class="says">Waves run upwind and branches stretch: what the printed signs and lengths of equations 11 and 17 do.</p>
      ${numberField({
        ...LINK_NUMBERS.p,
        id: 'exponent-force',
        label: 'Force to the power',
        value: wind.forceExponent,
        step: 0.05,
        reset: original.forceExponent,
        help: 'Exponent p of the force (equation 16 prints 1.8)',
        onInput: (value) => actions.setForceExponent(value),
      })}
      ${numberField({
        ...LINK_NUMBERS.m,
        id: 'exponent-length',
        label: 'Length to the power',
        value: wind.lengthExponent,
        step: 0.05,
        reset: original.lengthExponent,
        help: 'Exponent m of the length that divides the force (the paper: 2)',
        onInput: (value) => actions.setLengthExponent(value),
      })}`;
  }

  private profile({ profile }: Wind): TemplateResult {
    const { actions } = this.editor;
    const height = ruleField(WIND_NUMBERS.height, {
      id: 'profile-height',
      label: 'Height',
      name: 'Height at which the wind is as its waves say',
      value: profile.height,
      reset: STILL.profile.height,
      onInput: (value) => actions.setProfile({ height: value }),
    });
    return html`${choice({
      name: 'profile',
      legend: 'With height',
      value: profile.kind,
      options: KINDS.map((value) => ({ value, label: PROFILES[value].label, title: PROFILES[value].says })),
      onChoose: (kind) => actions.setProfile({ kind }),
    })}
    <p class="says">${PROFILES[profile.kind].says}</p>
    ${profile.kind === 'none' ? '' : height}
    ${
      profile.kind === 'log'
        ? ruleField(WIND_NUMBERS.roughness, {
            id: 'profile-roughness',
            label: 'Roughness',
            value: profile.roughness,
            reset: STILL.profile.roughness,
            onInput: (roughness) => actions.setProfile({ roughness }),
          })
        : ''
    }
    ${
      profile.kind === 'power'
        ? ruleField(WIND_NUMBERS.exponent, {
            id: 'profile-exponent',
            label: 'Exponent',
            value: profile.exponent,
            reset: STILL.profile.exponent,
            onInput: (exponent) => actions.setProfile({ exponent }),
          })
        : ''
    }`;
  }
}

customElements.define('wg-air', AirPanel);
