import { html, type TemplateResult } from 'lit';
import { WIND_NUMBERS } from '../../core/link/wind-numbers.ts';
import { type BendModelName, STILL, type Wind } from '../../core/wind/wind.ts';
import { choice, toggle } from './choice.ts';
import { fold } from './fold.ts';
import { Part } from './panel.ts';
import { ruleField } from './rule-field.ts';

/** What each model does, and where it is from. */
const MODELS: readonly { value: BendModelName; label: string; does: string; from: string }[] = [
  {
    value: 'direct',
    label: 'Direct',
    does: 'Branches bend as far as the wind pushes at this moment; nothing swings on.',
    from: 'Skjermo 2007, equations 16 and 17',
  },
  {
    value: 'spring',
    label: 'Spring',
    does: 'Each branch swings about where the wind pushes it, as fast as its wood lets it, and shakes what grows on it.',
    from: 'ours: a damped oscillator a branch, its frequency that of a cantilever',
  },
  {
    value: 'sway',
    label: 'Sway',
    does: 'Each stem swings by two sines of its own; the waves do not matter, only how strong the wind is.',
    from: 'Weber & Penn 1995, section 4.7',
  },
];

const LEVELS = ['Trunk', 'Limbs', 'Branches', 'Twigs'];

/** What the wind does to a branch: the model, its settings, how branches follow their parents. */
class ModelPanel extends Part {
  protected override render(): TemplateResult {
    const { actions } = this.editor;
    const { wind } = actions.edited();
    const model = MODELS.find((m) => m.value === wind.model)!;
    return html`${choice({
      name: 'model',
      legend: 'Model',
      quiet: true,
      value: wind.model,
      options: MODELS.map(({ value, label, does }) => ({ value, label, title: does })),
      onChoose: (value) => actions.setModel(value),
    })}
    <p class="says">${model.does} <span class="soft">From: ${model.from}.</span></p>
    ${wind.model === 'spring' ? this.spring(wind) : wind.model === 'sway' ? this.sway(wind) : ''}
    ${ruleField(WIND_NUMBERS.stiffness, {
      id: 'stiffness',
      label: 'Stiffness',
      name: 'Stiffness of the tree',
      value: wind.stiffness,
      reset: 1,
      onInput: (value) => actions.setStiffness(value),
    })}
    ${choice({
      name: 'pose',
      legend: 'Branches follow their parents',
      value: wind.pose,
      options: [
        { value: 'exact', label: 'At once', title: 'Depth by depth: no lag' },
        { value: 'lagged', label: 'One step late', title: 'All at once, parents from the last step, as in the paper' },
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
        label: 'Frequency',
        name: 'Factor on the natural frequencies',
        value: spring.frequency,
        reset: still.frequency,
        onInput: (frequency) => actions.setSpring({ frequency }),
      })}
      ${ruleField(WIND_NUMBERS.damping, {
        id: 'spring-damping',
        label: 'Damping',
        name: 'Damping ratio',
        value: spring.damping,
        reset: still.damping,
        onInput: (damping) => actions.setSpring({ damping }),
      })}
      ${ruleField(WIND_NUMBERS.inertia, {
        id: 'spring-inertia',
        label: 'Inertia',
        name: 'Inertia: how much of its parent shakes a branch',
        value: spring.inertia,
        reset: still.inertia,
        onInput: (inertia) => actions.setSpring({ inertia }),
      })}
      ${fold(this.editor, 'spring-levels', 'Level by level', this.levels(spring))}`;
  }

  private levels(spring: Wind['spring']): TemplateResult {
    const { actions } = this.editor;
    return html`<p class="soft">A frequency and a damping of its own for a level, in place of what its wood gives.</p>
      ${LEVELS.map((name, i) => {
        const level = spring.levels[i];
        const frequency = level?.frequency ?? null;
        const damping = level?.damping ?? null;
        return html`<div class="level"><span class="chip" data-level=${i}></span><span class="level-name">${name}</span>
          ${toggle(`level-${i}-hz`, 'Hz', frequency !== null, (on) => actions.setSpringLevel(i, { frequency: on ? 1 : null }), { name: `${name}: frequency of its own` })}
          ${toggle(`level-${i}-zeta`, 'ζ', damping !== null, (on) => actions.setSpringLevel(i, { damping: on ? spring.damping : null }), { name: `${name}: damping of its own` })}
        </div>
        ${
          frequency === null
            ? ''
            : ruleField(WIND_NUMBERS.hertz, {
                id: `level-${i}-frequency`,
                label: 'Frequency',
                name: `${name} frequency`,
                value: frequency,
                onInput: (value) => actions.setSpringLevel(i, { frequency: value }),
              })
        }
        ${
          damping === null
            ? ''
            : ruleField(WIND_NUMBERS.damping, {
                id: `level-${i}-damping`,
                label: 'Damping',
                name: `${name} damping`,
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
        label: 'Wind speed',
        value: sway.speed,
        reset: still.speed,
        onInput: (speed) => actions.setSway({ speed }),
      })}
      ${ruleField(WIND_NUMBERS.swayGust, {
        id: 'sway-gust',
        label: 'Wind gust',
        value: sway.gust,
        reset: still.gust,
        onInput: (gust) => actions.setSway({ gust }),
      })}
      ${choice({
        name: 'reading',
        legend: 'Frequency goes by',
        value: sway.reading,
        options: [
          { value: 'ratio', label: 'Radius / length', title: 'As the paper prints it' },
          { value: 'cantilever', label: 'Radius / length²', title: 'As a beam that is held at one end swings' },
        ],
        onChoose: (reading) => actions.setSway({ reading }),
      })}
      ${ruleField(WIND_NUMBERS.rate, {
        id: 'sway-rate',
        label: 'Rate',
        name: 'Rate of the swings',
        value: sway.rate,
        reset: still.rate,
        onInput: (rate) => actions.setSway({ rate }),
      })}`;
  }
}

customElements.define('wg-model', ModelPanel);
