import { html, type TemplateResult } from 'lit';
import { LINK_NUMBERS } from '../../core/link/numbers.ts';
import { WIND_NUMBERS } from '../../core/link/wind-numbers.ts';
import { STILL, type Wind } from '../../core/wind/wind.ts';
import { airWords } from '../words/wind-panel.ts';
import { choice, toggle } from './choice.ts';
import { numberField } from './number-field.ts';
import { Part } from './panel.ts';
import { ruleField } from './rule-field.ts';

const KINDS = ['none', 'log', 'power'] as const;

/** The air as a whole: how it grows with height, whether it leans, and the printed forms. */
class AirPanel extends Part {
  protected override render(): TemplateResult {
    const { actions } = this.editor;
    const { wind, preset } = actions.edited();
    const original = this.session.winds.find((w) => w.id === preset)?.wind ?? STILL;
    return html`${this.profile(wind)}
      ${toggle('zero-mean', airWords.noLean, wind.zeroMean, (on) => actions.setZeroMean(on), {
        name: airWords.noLeanName,
        title: airWords.noLeanTitle,
      })}
      <p class="says">${airWords.noLeanSays} <span class="soft">${airWords.leans}</span></p>
      ${toggle('paper', airWords.paper, wind.paper, (on) => actions.setPaper(on), {
        title: airWords.paperTitle,
      })}
      <p class="says">${airWords.paperSays}</p>
      ${numberField({
        ...LINK_NUMBERS.p,
        id: 'exponent-force',
        label: airWords.force,
        value: wind.forceExponent,
        step: 0.05,
        reset: original.forceExponent,
        help: airWords.forceHelp,
        onInput: (value) => actions.setForceExponent(value),
      })}
      ${numberField({
        ...LINK_NUMBERS.m,
        id: 'exponent-length',
        label: airWords.length,
        value: wind.lengthExponent,
        step: 0.05,
        reset: original.lengthExponent,
        help: airWords.lengthHelp,
        onInput: (value) => actions.setLengthExponent(value),
      })}`;
  }

  private profile({ profile }: Wind): TemplateResult {
    const { actions } = this.editor;
    const height = ruleField(WIND_NUMBERS.height, {
      id: 'profile-height',
      label: airWords.height,
      name: airWords.heightName,
      value: profile.height,
      reset: STILL.profile.height,
      onInput: (value) => actions.setProfile({ height: value }),
    });
    return html`${choice({
      name: 'profile',
      legend: airWords.profile,
      value: profile.kind,
      options: KINDS.map((value) => ({
        value,
        label: airWords.profiles[value].label,
        title: airWords.profiles[value].says,
      })),
      onChoose: (kind) => actions.setProfile({ kind }),
    })}
    <p class="says">${airWords.profiles[profile.kind].says}</p>
    ${profile.kind === 'none' ? '' : height}
    ${
      profile.kind === 'log'
        ? ruleField(WIND_NUMBERS.roughness, {
            id: 'profile-roughness',
            label: airWords.roughness,
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
            label: airWords.exponent,
            value: profile.exponent,
            reset: STILL.profile.exponent,
            onInput: (exponent) => actions.setProfile({ exponent }),
          })
        : ''
    }`;
  }
}

customElements.define('wg-air', AirPanel);
