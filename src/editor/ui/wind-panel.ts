import { html, type TemplateResult } from 'lit';
import { LINK_NUMBERS } from '../../core/link/numbers.ts';
import { windDirection } from '../../view/wind-direction.ts';
import { choice, toggle } from './choice.ts';
import { dial } from './dial.ts';
import { fold } from './fold.ts';
import './air-panel.ts';
import './gust-panel.ts';
import './mixer.ts';
import './model-panel.ts';
import './wind-files.ts';
import './wind-presets.ts';
import './wizard.ts';
import { numberField } from './number-field.ts';
import { Part } from './panel.ts';

/** What blows: a wind to begin with, its strength and direction, the mixer, gusts, the answer of the branches. */
class WindPanel extends Part {
  protected override render(): TemplateResult {
    const { doc, editor } = this;
    const { wind, preset } = editor.actions.edited();
    const original = this.session.winds.find((w) => w.id === preset)?.wind ?? wind;
    const waves = wind.waves.length === 1 ? 'One wave' : `${wind.waves.length || 'No'} waves`;
    return html`
      <div class="wind-head">${this.side()}${toggle(
        'blowing',
        html`Wind`,
        doc.blowing,
        (on) => editor.actions.setBlowing(on),
        {
          name: 'Wind',
          title: 'Wind on or off (B)',
        },
      )}</div>
      <wg-wind-presets .editor=${editor}></wg-wind-presets>
      <div class="steering" @focusin=${() => editor.actions.setHandling(true)} @focusout=${() => editor.actions.setHandling(false)}>${numberField(
        {
          ...LINK_NUMBERS.strength,
          id: 'strength',
          label: 'Strength',
          name: 'Wind strength',
          value: wind.strength,
          step: 0.01,
          reset: original.strength,
          help: 'A factor on all of the wind',
          onInput: (value) => editor.actions.setStrength(value),
        },
      )}
      ${this.direction()}</div>
      ${this.overlays()}
      ${fold(editor, 'wizard', 'Wizard', html`<wg-wizard .editor=${editor}></wg-wizard>`)}
      ${fold(editor, 'mixer', waves, html`<wg-mixer .editor=${editor}></wg-mixer>`, true)}
      ${fold(editor, 'gusts', this.gusts(wind.gusts.length), html`<wg-gusts .editor=${editor}></wg-gusts>`)}
      ${fold(editor, 'model', this.model(wind.model), html`<wg-model .editor=${editor}></wg-model>`)}
      ${fold(editor, 'air', 'Air and paper', html`<wg-air .editor=${editor}></wg-air>`)}
      ${fold(editor, 'wind-file', 'Copy, paste, files', html`<wg-wind-files .editor=${editor}></wg-wind-files>`)}`;
  }

  /** What of the wind is seen in the picture. */
  private overlays(): TemplateResult {
    const { actions } = this.editor;
    const { overlays } = this.doc;
    return html`<div class="overlays" role="group" aria-label="In the picture">
      ${toggle('overlay-arrows', 'Arrows', overlays.arrows, (arrows) => actions.setOverlays({ arrows }), { title: 'Arrows of the force over the ground (A)' })}
      ${toggle('overlay-fronts', 'Fronts', overlays.fronts, (fronts) => actions.setOverlays({ fronts }), { title: 'Fronts of gusts on the ground' })}
      ${toggle('overlay-handle', 'Handle', overlays.handle, (handle) => actions.setOverlays({ handle }), { title: 'The handle that turns the wind (H)' })}
    </div>`;
  }

  private gusts(count: number): TemplateResult {
    return html`<span>Gusts</span><span class="soft count">${count || ''}</span>`;
  }

  private model(model: string): TemplateResult {
    return html`<span>Branches answer</span><span class="soft count">${model}</span>`;
  }

  /** Which of two winds is changed here. */
  private side(): TemplateResult | '' {
    if (!this.doc.compare) return '';
    return choice({
      name: 'side',
      legend: 'Wind that is changed here',
      quiet: true,
      value: this.session.side,
      options: [
        { value: 'A', label: 'Wind A', title: 'The wind of the left side' },
        { value: 'B', label: 'Wind B', title: 'The wind of the right side' },
      ],
      onChoose: (side) => this.editor.actions.setSide(side),
    });
  }

  /** The whole wind as one direction; turning it turns all waves together. */
  private direction(): TemplateResult {
    const { actions } = this.editor;
    const towards = windDirection(actions.edited().wind);
    const degrees = towards === null ? 0 : Math.round((((towards * 180) / Math.PI + 360) % 360) * 10) / 10;
    const set = (value: number): void => actions.turnWind((value * Math.PI) / 180);
    const disabled = towards === null;
    const typed = (event: Event): void => {
      const box = event.target as HTMLInputElement;
      if (box.value !== '' && box.validity.valid) set(box.valueAsNumber);
      else box.value = String(degrees);
    };
    return html`<div class="field whole" ?data-disabled=${disabled}>
      <label for="direction-number" title="Turns all waves together: 0° to the right of the first view, 90° away from you">Direction</label>
      ${dial({ id: 'direction', name: 'Wind direction, dial', value: Math.round(degrees), disabled, onInput: set })}
      <span class="amount"><input type="number" id="direction-number" aria-label="Wind direction, degrees" min="0" max="360" step="any"
        .value=${String(degrees)} ?disabled=${disabled} @change=${typed}><span class="unit" aria-hidden="true">°</span></span>
    </div>`;
  }
}

customElements.define('wg-wind', WindPanel);
