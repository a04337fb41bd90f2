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
import { withKeys } from '../shortcuts.ts';
import { windWords } from '../words/wind-panel.ts';
import { numberField } from './number-field.ts';
import { Part } from './panel.ts';

/** What blows: a wind to begin with, its strength and direction, the mixer, gusts, the answer of the branches. */
class WindPanel extends Part {
  protected override render(): TemplateResult {
    const { doc, editor } = this;
    const { wind, preset } = editor.actions.edited();
    const original = this.session.winds.find((w) => w.id === preset)?.wind ?? wind;
    const waves = windWords.waves(wind.waves.length);
    return html`
      <div class="wind-head">${this.side()}${toggle(
        'blowing',
        windWords.wind,
        doc.blowing,
        (on) => editor.actions.setBlowing(on),
        {
          name: windWords.wind,
          title: withKeys('blow', windWords.onOff),
        },
      )}</div>
      <wg-wind-presets .editor=${editor}></wg-wind-presets>
      <div class="steering" @focusin=${() => editor.actions.setHandling(true)} @focusout=${() => editor.actions.setHandling(false)}>${numberField(
        {
          ...LINK_NUMBERS.strength,
          id: 'strength',
          label: windWords.strength,
          name: windWords.strengthName,
          value: wind.strength,
          step: 0.01,
          reset: original.strength,
          help: windWords.strengthHelp,
          onInput: (value) => editor.actions.setStrength(value),
        },
      )}
      ${this.direction()}</div>
      ${this.overlays()}
      ${fold(editor, 'wizard', windWords.wizard, html`<wg-wizard .editor=${editor}></wg-wizard>`)}
      ${fold(editor, 'mixer', waves, html`<wg-mixer .editor=${editor}></wg-mixer>`, true)}
      ${fold(editor, 'gusts', this.gusts(wind.gusts.length), html`<wg-gusts .editor=${editor}></wg-gusts>`)}
      ${fold(editor, 'model', this.model(wind.model), html`<wg-model .editor=${editor}></wg-model>`)}
      ${fold(editor, 'air', windWords.air, html`<wg-air .editor=${editor}></wg-air>`)}
      ${fold(editor, 'wind-file', windWords.files, html`<wg-wind-files .editor=${editor}></wg-wind-files>`)}`;
  }

  /** What of the wind is seen in the picture. */
  private overlays(): TemplateResult {
    const { actions } = this.editor;
    const { overlays } = this.doc;
    return html`<div class="overlays" role="group" aria-label=${windWords.inPicture}>
      ${toggle('overlay-arrows', windWords.arrows, overlays.arrows, (arrows) => actions.setOverlays({ arrows }), { title: withKeys('arrows', windWords.arrowsTitle) })}
      ${toggle('overlay-fronts', windWords.fronts, overlays.fronts, (fronts) => actions.setOverlays({ fronts }), { title: windWords.frontsTitle })}
      ${toggle('overlay-handle', windWords.handle, overlays.handle, (handle) => actions.setOverlays({ handle }), { title: withKeys('handle', windWords.handleTitle) })}
    </div>`;
  }

  private gusts(count: number): TemplateResult {
    return html`<span>${windWords.gusts}</span><span class="soft count">${count || ''}</span>`;
  }

  private model(model: string): TemplateResult {
    return html`<span>${windWords.answer}</span><span class="soft count">${model}</span>`;
  }

  /** Which of two winds is changed here. */
  private side(): TemplateResult | '' {
    if (!this.doc.compare) return '';
    return choice({
      name: 'side',
      legend: windWords.side,
      quiet: true,
      value: this.session.side,
      options: [
        { value: 'A', label: windWords.sideA, title: windWords.sideATitle },
        { value: 'B', label: windWords.sideB, title: windWords.sideBTitle },
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
      <label for="direction-number" title=${windWords.directionHelp}>${windWords.direction}</label>
      ${dial({ id: 'direction', name: windWords.directionDial, value: Math.round(degrees), disabled, onInput: set })}
      <span class="amount"><input type="number" id="direction-number" aria-label=${windWords.directionNumber} min="0" max="360" step="any"
        .value=${String(degrees)} ?disabled=${disabled} @change=${typed}><span class="unit" aria-hidden="true">°</span></span>
    </div>`;
  }
}

customElements.define('wg-wind', WindPanel);
