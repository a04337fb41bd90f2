import { html, type TemplateResult } from 'lit';
import { live } from 'lit/directives/live.js';
import { STAGES } from '../core/link/document.ts';
import { SEASONS } from '../core/species/season.ts';
import { groundFields } from './panel-ground.ts';
import { mixFields } from './panel-mix.ts';
import { slider } from './slider.ts';
import type { Scene, Sources } from './sources.ts';
import type { Store } from './store.ts';
import { words } from './words.ts';

/** What the panel can do besides editing the forest, and what it shows that is no part of it. */
export interface PanelWork {
  readonly standing: number;
  readonly ownSpeed: number;
  readonly onScene: (scene: Scene) => void;
  readonly onCopy: () => void;
}

/** Trees are chosen on a scale of powers: from 10 to 20 000. */
const LEAST = 10;
const MOST = 20_000;
const STEPS = 200;
const countOf = (step: number): number => {
  const count = LEAST * (MOST / LEAST) ** (step / STEPS);
  const digits = 10 ** Math.max(0, Math.floor(Math.log10(count)) - 1);
  return Math.round(count / digits) * digits;
};
const stepOf = (count: number): number =>
  Math.round((STEPS * Math.log(Math.max(LEAST, count) / LEAST)) / Math.log(MOST / LEAST));

const fold = (title: string, open: boolean, content: TemplateResult): TemplateResult =>
  html`<details ?open=${open}><summary>${title}</summary><div class="fold">${content}</div></details>`;

const newSeed = (): number => crypto.getRandomValues(new Uint32Array(1))[0]! % 100_000;

/** All settings of the forest; `counters` stand where they are seen first. */
export function panel(store: Store, sources: Sources, work: PanelWork): TemplateResult {
  const { document } = store.state;
  const isScene = (scene: Scene): boolean => scene.name === document.name;
  return html`
    <section class="scenes" aria-label=${words.scenes}>
      ${sources.scenes.map(
        (scene) => html`<button type="button" class="button" aria-pressed=${isScene(scene)} title=${scene.description}
          @click=${() => work.onScene(scene)}>${scene.name}</button>`,
      )}
    </section>
    ${fold(
      words.trees,
      true,
      html`
        ${slider({
          label: words.count,
          min: 0,
          max: STEPS,
          step: 1,
          value: stepOf(document.count),
          text: words.countValue(document.count, work.standing),
          onInput: (step) => store.edit({ count: countOf(step) }),
        })}
        ${mixFields(store, sources)}
        <div class="field seed">
          <label><span class="label">${words.seed}</span>
            <input type="number" min="0" max="4294967295" step="1" .value=${live(String(document.seed))}
              @change=${(event: Event) => store.edit({ seed: (event.target as HTMLInputElement).valueAsNumber || 0 })}></label>
          <button class="quiet" type="button" @click=${() => store.edit({ seed: newSeed() })}>${words.newSeed}</button>
        </div>`,
    )}
    ${fold(words.light, true, lightFields(store))} ${fold(words.wind, true, windFields(store, sources, work))}
    ${fold(words.ground, false, groundFields(store))}
    ${fold(
      words.speedOfPage,
      false,
      slider({
        label: words.budget,
        min: 8,
        max: 200,
        step: 0.5,
        value: document.budget,
        text: words.milliseconds(document.budget),
        onInput: (budget) => store.edit({ budget }),
      }),
    )}
    ${fold(words.keys, false, html`<dl class="keys">${words.help.map(([key, does]) => html`<dt>${key}</dt><dd>${does}</dd>`)}</dl>`)}
    <button class="button copy" type="button" @click=${work.onCopy}>${words.copy}</button>`;
}

function lightFields(store: Store): TemplateResult {
  const { season, stage, hour } = store.state.document;
  return html`
    <fieldset class="options"><legend class="unseen">${words.season}</legend>
      ${SEASONS.map(
        (each) => html`<label><input type="radio" name="season" value=${each} .checked=${live(each === season)}
          @change=${() => store.edit({ season: each })}><span>${words.seasons[each]}</span></label>`,
      )}
    </fieldset>
    <fieldset class="options"><legend class="unseen">${words.stage}</legend>
      ${STAGES.map(
        (each) => html`<label><input type="radio" name="stage" value=${each} .checked=${live(each === stage)}
          @change=${() => store.edit({ stage: each, hour: null })}><span>${words.stages[each]}</span></label>`,
      )}
    </fieldset>
    ${slider({
      label: words.hour,
      min: 0,
      max: 24,
      step: 0.25,
      value: hour ?? 12,
      text: hour === null ? words.ownHour : words.hourValue(hour),
      onInput: (value) => store.edit({ hour: value }),
      own: { label: words.ownTime, active: hour !== null, onClick: () => store.edit({ hour: null }) },
    })}`;
}

function windFields(store: Store, sources: Sources, { ownSpeed }: PanelWork): TemplateResult {
  const { wind, windSpeed, windTurn } = store.state.document;
  return html`
    <div class="field"><label><span class="label">${words.windOf}</span>
      <select @change=${(event: Event) => store.edit({ wind: (event.target as HTMLSelectElement).value, windSpeed: null })}>
        ${sources.winds.map(({ id, name }) => html`<option value=${id} .selected=${id === wind}>${name}</option>`)}
      </select></label></div>
    ${slider({
      label: words.windSpeed,
      min: 0,
      max: 30,
      step: 0.5,
      value: windSpeed ?? Math.round(2 * ownSpeed) / 2,
      text: words.windValue(windSpeed ?? ownSpeed),
      onInput: (value) => store.edit({ windSpeed: value }),
      own: { label: words.ownSpeed, active: windSpeed !== null, onClick: () => store.edit({ windSpeed: null }) },
    })}
    ${slider({
      label: words.windTurn,
      min: 0,
      max: 359,
      step: 1,
      value: windTurn,
      text: words.degrees(windTurn),
      onInput: (value) => store.edit({ windTurn: value }),
    })}
  `;
}
