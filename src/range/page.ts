import { html, nothing, render, type TemplateResult } from 'lit';
import { SEASONS } from '../core/species/season.ts';
import type { DrawnElements } from '../view/wind-tree.ts';
import type { Figures } from './picture.ts';
import { fromSlider, type RangeState, toSlider, WAYS } from './state.ts';
import { rangeTable } from './table.ts';
import { count, metres, rangeWords as words } from './words.ts';

/** What the page shows. */
export interface Shown {
  readonly state: RangeState;
  readonly dark: boolean;
  /** What is wrong with the link, line by line. */
  readonly notice: readonly string[];
  /** By the ranges of Table 2; empty until the tree has grown. */
  readonly table: readonly DrawnElements[];
  readonly figures: Figures | null;
  /** A frame; 0 while it is not known. */
  readonly milliseconds: number;
}

type Tell = (change: Partial<RangeState>) => void;

/** The page around the picture: controls, figures, the table. */
export class RangePage {
  readonly canvas = document.createElement('canvas');
  readonly inset = document.createElement('canvas');
  readonly #root: HTMLElement;
  readonly #dismiss: () => void;
  readonly #tell: Tell;
  #message: string = words.loading;
  #shown: Shown | null = null;

  constructor(root: HTMLElement, dismiss: () => void, tell: Tell) {
    this.#root = root;
    this.#dismiss = dismiss;
    this.#tell = tell;
    this.canvas.setAttribute('role', 'img');
    this.canvas.setAttribute('aria-label', words.picture);
    this.inset.className = 'inset';
    this.inset.width = 240;
    this.inset.height = 240;
    this.inset.hidden = true;
    this.inset.setAttribute('role', 'img');
    this.inset.setAttribute('aria-label', words.inset);
  }

  ready(): void {
    this.#message = '';
  }

  fail(message: string): void {
    this.#message = message;
    if (this.#shown) this.show(this.#shown);
  }

  show(shown: Shown): void {
    this.#shown = shown;
    render(this.#page(shown), this.#root);
  }

  #page(shown: Shown): TemplateResult {
    return html`
      <h1>${words.title}</h1>
      <p class="lead">${words.intro}</p>
      ${shown.notice.length > 0 ? this.#notice(shown.notice) : nothing}
      <div class="show">
        <figure class="picture">
          ${this.canvas}${this.inset}
          ${this.#message ? html`<p class="message" role="status">${this.#message}</p>` : ''}
        </figure>
        <div class="controls">${this.#controls(shown)}${figureList(shown)}</div>
      </div>
      <h2>${words.table}</h2>
      <p class="soft">${words.tableLead}</p>
      ${rangeTable(shown.table, shown.state.range, (range) => this.#tell({ range }))}
      <h2>${words.fits}</h2>
      <ul>${words.fit.map((text) => html`<li>${text}</li>`)}</ul>
      <h2>${words.ours}</h2>
      <ul>${words.own.map((text) => html`<li>${text}</li>`)}</ul>
    `;
  }

  #notice(lines: readonly string[]): TemplateResult {
    return html`<div class="notice" role="alert">
      <p><strong>${words.linkFaults}</strong></p>
      ${lines.map((line) => html`<p>${line}</p>`)}
      <button type="button" aria-label=${words.dismiss} title=${words.dismiss} @click=${this.#dismiss}>×</button>
    </div>`;
  }

  #controls({ state, dark }: Shown): TemplateResult {
    const tell = this.#tell;
    const textOf = (event: Event): string => (event.target as HTMLInputElement).value;
    const checkedOf = (event: Event): boolean => (event.target as HTMLInputElement).checked;
    const check = (name: string, on: boolean, change: (on: boolean) => Partial<RangeState>, title = '') => html`
      <label class="check" title=${title}>
        <input type="checkbox" .checked=${on} @change=${(event: Event) => tell(change(checkedOf(event)))} />${name}
      </label>`;
    return html`
      <label class="row">
        <span class="name">${words.range}</span>
        <input id="range" type="range" min="0" max="1" step="0.005" .value=${String(toSlider(state.range))}
          aria-valuetext=${metres(state.range)}
          @input=${(event: Event) => tell({ range: fromSlider(Number(textOf(event))) })} />
        <output for="range">${metres(state.range)}</output>
      </label>
      <fieldset class="row" aria-label=${words.way}>
        <span class="name" aria-hidden="true">${words.way}</span>
        <span class="segments">${WAYS.map(
          (way) => html`<label><input type="radio" name="way" .checked=${state.way === way}
            @change=${() => tell({ way })} /><span>${words.ways[way]}</span></label>`,
        )}</span>
      </fieldset>
      <label class="row">
        <span class="name">${words.quality}</span>
        <input id="quality" type="range" min="0.1" max="1" step="0.05" .value=${String(state.quality)}
          ?disabled=${state.way !== 'paper'}
          @input=${(event: Event) => tell({ quality: Number(textOf(event)) })} />
        <output for="quality">${state.quality.toFixed(2)}</output>
      </label>
      <label class="row">
        <span class="name">${words.season}</span>
        <select @change=${(event: Event) => {
          const season = SEASONS.find((each) => each === textOf(event));
          if (season) tell({ season });
        }}>
          ${SEASONS.map((season) => html`<option value=${season} .selected=${state.season === season}>${words.seasons[season]}</option>`)}
        </select>
      </label>
      <div class="row">
        ${check(words.near, state.near, (near) => ({ near }), words.nearHint)}
        ${check(words.wind, state.wind, (wind) => ({ wind }))}
        ${check(words.dark, dark, (on) => ({ dark: on }))}
      </div>`;
  }
}

function figureList({ state, figures, milliseconds }: Shown): TemplateResult {
  const list: [string, string][] = [
    [words.triangles, figures ? count(figures.triangles) : '…'],
    [words.lines, figures ? count(figures.lines) : '…'],
    [words.points, figures ? count(figures.points) : '…'],
    [words.ms, milliseconds > 0 ? milliseconds.toFixed(1) : '…'],
  ];
  return html`
    <dl class="figures" aria-label=${words.now}>
      ${list.map(([name, value]) => html`<div><dt>${name}</dt><dd>${value}</dd></div>`)}
    </dl>
    <p class="soft note">${state.way === 'paper' ? words.r2(state.range) : words.notPaper}</p>`;
}
