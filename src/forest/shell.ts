import { html, nothing, render, type TemplateResult } from 'lit';
import { SITE_PAGES } from '../site/pages.ts';
import { counters } from './counters.ts';
import { panel } from './panel.ts';
import type { Scene, Sources } from './sources.ts';
import type { Store } from './store.ts';
import { words } from './words.ts';
import type { World } from './world.ts';

const ICONS = {
  play: 'M4.5 2.5v11l9-5.5z',
  pause: 'M4.5 2.5v11M11.5 2.5v11',
  down: 'M4 6.5l4 4 4-4',
  up: 'M4 9.5l4-4 4 4',
};

const icon = (path: string): TemplateResult =>
  html`<svg class="icon" viewBox="0 0 16 16" fill="none" aria-hidden="true"><path d=${path} /></svg>`;

const pages = (): TemplateResult =>
  html`<nav aria-label=${words.pages}>${SITE_PAGES.map(
    ({ id, name, short = name, href }) =>
      html`<a href=${`./${href}`} aria-current=${id === 'forest' ? 'page' : nothing}>${short}</a>`,
  )}</nav>`;

/** Where a picture that is held over the page may be dropped. */
const dropPlaces = (): TemplateResult =>
  html`<div class="drop">${(['height', 'density'] as const).map(
    (map) => html`<div data-map=${map}><span>${words.drop}</span><strong>${words.mapNames[map]}</strong></div>`,
  )}</div>`;

export interface ShellWork {
  readonly onScene: (scene: Scene) => void;
  readonly onCopy: () => void;
}

/** Draws what lies over the picture, as the state and the forest are now. */
export function drawShell(into: HTMLElement, store: Store, sources: Sources, world: World, work: ShellWork): void {
  const { open, playing, notice, dragging } = store.state;
  render(
    html`
      <div class="panel" ?data-open=${open}>
        <header>
          <h1>${words.title}</h1>
          <button class="quiet" type="button" data-do="play" aria-label=${playing ? words.pause : words.play}
            title=${playing ? words.pause : words.play} @click=${() => store.set({ playing: !playing })}>
            ${icon(playing ? ICONS.pause : ICONS.play)}</button>
          <button class="quiet" type="button" data-do="open" aria-expanded=${open} aria-controls="settings"
            aria-label=${open ? words.close : words.open} title=${open ? words.close : words.open}
            @click=${() => store.set({ open: !open })}>${icon(open ? ICONS.up : ICONS.down)}</button>
        </header>
        <div id="settings" role="region" aria-label=${words.panel} ?hidden=${!open}>
          ${pages()}
          ${panel(store, sources, { standing: world.standing, ownSpeed: world.ownSpeed, ...work })}
        </div>
        <div class="now" role="region" aria-label=${words.now} ?hidden=${!open}></div>
      </div>
      <div class="notices">
        ${
          notice
            ? html`<div class="notice" data-kind=${notice.kind} role=${notice.kind === 'error' ? 'alert' : 'status'}>
                <p><strong>${notice.title}</strong></p>
                ${notice.lines.map((line) => html`<p>${line}</p>`)}
                <button class="quiet" type="button" aria-label=${words.dismiss} title=${words.dismiss}
                  @click=${() => store.set({ notice: null })}>×</button>
              </div>`
            : nothing
        }
      </div>
      <p class="work" role="status"></p>
      ${dragging ? dropPlaces() : nothing}`,
    into,
  );
}

/** What the page is at: seeding, growing, or nothing to be told of. */
function workText(world: World): string {
  if (world.seeding) return words.seeding;
  const { progress, growing } = world.stats;
  if (progress < 1) return words.shaping(progress);
  return growing > 0 ? words.dressing(growing) : '';
}

/** Brings counters and progress up to date: a few times a second, apart from the rest of the page. */
export function drawCounters(into: HTMLElement, world: World): void {
  const now = into.querySelector<HTMLElement>('.now');
  if (now && !now.closest('[hidden]')) render(counters(world.stats), now);
  const work = into.querySelector<HTMLElement>('.work');
  const text = workText(world);
  if (work && work.textContent !== text) work.textContent = text;
}

/** Says in the picture's stead that there is none, and why. */
export function drawFailure(into: HTMLElement, title: string, more: string): void {
  render(
    html`<div class="failure" role="alert"><h1>${title}</h1><p>${more}</p>
      ${pages()}
    </div>`,
    into,
  );
}
