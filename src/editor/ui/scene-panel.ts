import { html, nothing, type TemplateResult } from 'lit';
import { STAGES } from '../../core/link/link.ts';
import { SEASONS } from '../../core/species/season.ts';
import { QUALITIES } from '../../view/picture/quality.ts';
import { ownHour } from '../../view/stage-table.ts';
import { command, withKeys } from '../shortcuts.ts';
import '../styles/scene.css';
import { sceneWords } from '../words/scene.ts';
import { choice, toggle } from './choice.ts';
import { icon } from './icons.ts';
import { slider } from './number-field.ts';
import { Part } from './panel.ts';

/** Hours of a step of the slider: a quarter. */
const STEP = 0.25;

/** An hour as a clock shows it, `08:30`. */
export function clockText(hour: number): string {
  const minutes = Math.round(hour * 60) % (24 * 60);
  return `${String(Math.floor(minutes / 60)).padStart(2, '0')}:${String(minutes % 60).padStart(2, '0')}`;
}

/** What a clock shows as an hour; null: nothing was typed. */
export function hourOfClock(text: string): number | null {
  const [, hours, minutes] = /^(\d\d):(\d\d)/.exec(text) ?? [];
  return hours === undefined ? null : Math.round((Number(hours) + Number(minutes) / 60) * 100) / 100;
}

/** In what season, where and in what light the tree stands; how finely it is drawn. */
class ScenePanel extends Part {
  protected override render(): TemplateResult {
    const { actions } = this.editor;
    const { season, stage } = this.doc;
    return html`${choice({
      name: 'season',
      legend: sceneWords.season,
      value: season,
      options: SEASONS.map((value) => ({ value, label: sceneWords.seasons[value] })),
      onChoose: (value) => actions.setSeason(value),
    })}
    ${choice({
      name: 'stage',
      legend: sceneWords.stage,
      value: stage,
      options: STAGES.map((value) => ({
        value,
        label: sceneWords.stages[value][0],
        title: sceneWords.stages[value][1],
      })),
      onChoose: (value) => actions.setStage(value),
    })}
    ${this.hour()}${this.quality()}
    <button type="button" class="button" title=${withKeys('photo', sceneWords.photo)} @click=${this.photo}>
      ${icon('camera')}<span>${sceneWords.photo}</span></button>`;
  }

  private hour(): TemplateResult {
    const { actions } = this.editor;
    const { stage, hour } = this.doc;
    const own = ownHour(stage, document.documentElement.dataset.theme === 'dark');
    const value = hour ?? own;
    const shown = clockText(value);
    const typed = (event: Event): void => {
      const next = hourOfClock((event.target as HTMLInputElement).value);
      if (next !== null) actions.setHour(next);
    };
    const help = stage === 'studio' ? sceneWords.hourInStudio : sceneWords.hourHelp;
    return html`<div class="hour"><div class="field">
        <label for="hour" title=${help}>${sceneWords.hour}</label>
        ${slider({
          id: 'hour',
          name: sceneWords.hour,
          unit: '',
          value,
          min: 0,
          max: 24,
          step: STEP,
          shown,
          turns: true,
          onInput: (next) => actions.setHour(next),
        })}
        <input type="time" aria-label=${sceneWords.hour} .value=${shown} @change=${typed}>
      </div>
      ${toggle('hour-of-stage', sceneWords.ofStage, hour === null, (on) => actions.setHour(on ? null : own))}</div>`;
  }

  private quality(): TemplateResult {
    const { quality, frames } = this.session;
    return html`<div class="fineness">${choice({
      name: 'quality',
      legend: sceneWords.quality,
      value: quality,
      options: QUALITIES.map((value) => ({ value, label: sceneWords.qualities[value] })),
      onChoose: (value) => this.editor.actions.setQuality(value),
    })}${quality === 'auto' && frames?.quality ? html`<p>${sceneWords.qualityNow(frames.quality)}</p>` : nothing}</div>`;
  }

  private readonly photo = (): void => {
    this.closest<HTMLElement>('[popover]')?.hidePopover();
    command('photo').act?.(this.editor);
  };
}

customElements.define('wg-scene', ScenePanel);
