import { html, type TemplateResult } from 'lit';
import { WIND_NUMBERS } from '../../core/link/wind-numbers.ts';
import { type BendModelName, STILL, type Wind } from '../../core/wind/wind.ts';
import { modelWords } from '../words/wind-panel.ts';
import { choice, toggle } from './choice.ts';
import { fold } from './fold.ts';
import { Part } from './panel.ts';
import { ruleField } from './rule-field.ts';

const MODELS: readonly BendModelName[] = ['direct', 'spring', 'sway'];

/** What the wind does to a branch: the model, its settings, how branches follow their parents. */
class ModelPanel extends Part {
  protected override render(): TemplateResult {
    const { actions } = this.editor;
    const { wind } = actions.edited();
    const model = modelWords.models[wind.model];
    return html`${choice({
      name: 'model',
      legend: modelWords.model,
      quiet: true,
      value: wind.model,
      options: MODELS.map((value) => ({
        value,
        label: modelWords.models[value].label,
        title: modelWords.models[value].does,
      })),
      onChoose: (value) => actions.setModel(value),
    })}
    <p class="says">${model.does} <span class="soft">${model.from}</span></p>
    ${wind.model === 'spring' ? this.spring(wind) : wind.model === 'sway' ? this.sway(wind) : ''}
    ${ruleField(WIND_NUMBERS.stiffness, {
      id: 'stiffness',
      label: modelWords.stiffness,
      name: modelWords.stiffnessName,
      value: wind.stiffness,
      reset: 1,
      onInput: (value) => actions.setStiffness(value),
    })}
    ${choice({
      name: 'pose',
      legend: modelWords.pose,
      value: wind.pose,
      options: [
        { value: 'exact', label: modelWords.exact, title: modelWords.exactTitle },
        { value: 'lagged', label: modelWords.lagged, title: modelWords.laggedTitle },
      ],
      onChoose: (pose) => actions.setPose(pose),
    })}`;
  }

  private spring({ spring }: Wind): TemplateResult {
    const { actions } = this.editor;
    const still = STILL.spring;
    return html`
      ${ruleField(WIND_NUMBERS.frequency, {
        id: 'spring-frequency',
        label: modelWords.frequency,
        name: modelWords.frequencyName,
        value: spring.frequency,
        reset: still.frequency,
        onInput: (frequency) => actions.setSpring({ frequency }),
      })}
      ${ruleField(WIND_NUMBERS.damping, {
        id: 'spring-damping',
        label: modelWords.damping,
        name: modelWords.dampingName,
        value: spring.damping,
        reset: still.damping,
        onInput: (damping) => actions.setSpring({ damping }),
      })}
      ${ruleField(WIND_NUMBERS.inertia, {
        id: 'spring-inertia',
        label: modelWords.inertia,
        name: modelWords.inertiaName,
        value: spring.inertia,
        reset: still.inertia,
        onInput: (inertia) => actions.setSpring({ inertia }),
      })}
      ${fold(this.editor, 'spring-levels', modelWords.byLevel, this.levels(spring))}`;
  }

  private levels(spring: Wind['spring']): TemplateResult {
    const { actions } = this.editor;
    return html`<p class="soft">${modelWords.byLevelSays}</p>
      ${modelWords.levels.map((name, i) => {
        const level = spring.levels[i];
        const frequency = level?.frequency ?? null;
        const damping = level?.damping ?? null;
        return html`<div class="level"><span class="chip" data-level=${i}></span><span class="level-name">${name}</span>
          ${toggle(`level-${i}-hz`, 'Hz', frequency !== null, (on) => actions.setSpringLevel(i, { frequency: on ? 1 : null }), { name: modelWords.ownFrequency(name) })}
          ${toggle(`level-${i}-zeta`, 'ζ', damping !== null, (on) => actions.setSpringLevel(i, { damping: on ? spring.damping : null }), { name: modelWords.ownDamping(name) })}
        </div>
        ${
          frequency === null
            ? ''
            : ruleField(WIND_NUMBERS.hertz, {
                id: `level-${i}-frequency`,
                label: modelWords.frequency,
                name: modelWords.levelFrequency(name),
                value: frequency,
                onInput: (value) => actions.setSpringLevel(i, { frequency: value }),
              })
        }
        ${
          damping === null
            ? ''
            : ruleField(WIND_NUMBERS.damping, {
                id: `level-${i}-damping`,
                label: modelWords.damping,
                name: modelWords.levelDamping(name),
                value: damping,
                onInput: (value) => actions.setSpringLevel(i, { damping: value }),
              })
        }`;
      })}`;
  }

  private sway({ sway }: Wind): TemplateResult {
    const { actions } = this.editor;
    const still = STILL.sway;
    return html`
      ${ruleField(WIND_NUMBERS.swaySpeed, {
        id: 'sway-speed',
        label: modelWords.windSpeed,
        value: sway.speed,
        reset: still.speed,
        onInput: (speed) => actions.setSway({ speed }),
      })}
      ${ruleField(WIND_NUMBERS.swayGust, {
        id: 'sway-gust',
        label: modelWords.windGust,
        value: sway.gust,
        reset: still.gust,
        onInput: (gust) => actions.setSway({ gust }),
      })}
      ${choice({
        name: 'reading',
        legend: modelWords.reading,
        value: sway.reading,
        options: [
          { value: 'ratio', label: modelWords.ratio, title: modelWords.ratioTitle },
          { value: 'cantilever', label: modelWords.cantilever, title: modelWords.cantileverTitle },
        ],
        onChoose: (reading) => actions.setSway({ reading }),
      })}
      ${ruleField(WIND_NUMBERS.rate, {
        id: 'sway-rate',
        label: modelWords.rate,
        name: modelWords.rateName,
        value: sway.rate,
        reset: still.rate,
        onInput: (rate) => actions.setSway({ rate }),
      })}`;
  }
}

customElements.define('wg-model', ModelPanel);
