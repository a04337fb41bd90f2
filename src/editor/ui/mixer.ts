import { html, type PropertyValues, type TemplateResult } from 'lit';
import { blowingWaves, MOST_WAVES, type Wave, type Wind } from '../../core/wind/wind.ts';
import { mixerWords } from '../words/wind-panel.ts';
import { icon } from './icons.ts';
import { Part } from './panel.ts';
import { drawTrace, type TraceColours } from './trace.ts';
import { waveRow } from './wave-row.ts';

/** The waves of the wind, a row each, with live traces. */
class Mixer extends Part {
  private stopTicking = (): void => {};
  private colours: TraceColours | null = null;
  private readonly sizes = new ResizeObserver((entries) => {
    for (const { target, contentRect } of entries) {
      const canvas = target as HTMLCanvasElement;
      canvas.width = Math.round(contentRect.width * devicePixelRatio);
      canvas.height = Math.round(contentRect.height * devicePixelRatio);
    }
    this.draw(this.editor.actions.time());
  });
  private readonly themes = new MutationObserver(() => {
    this.colours = null;
    this.draw(this.editor.actions.time());
  });

  override connectedCallback(): void {
    super.connectedCallback();
    this.stopTicking = this.editor.onFrame((time) => this.draw(time));
    this.themes.observe(document.documentElement, { attributeFilter: ['data-theme'] });
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    this.stopTicking();
    this.sizes.disconnect();
    this.themes.disconnect();
  }

  protected override render(): TemplateResult {
    const { editor } = this;
    const { wind, preset } = editor.actions.edited();
    const original = this.session.winds.find((w) => w.id === preset)?.wind;
    const blowing = blowingWaves(wind);
    const most = wind.waves.length >= MOST_WAVES;
    return html`<div class="rows">${wind.waves.map((wave, index) =>
      waveRow({
        editor,
        wave,
        index,
        count: wind.waves.length,
        most,
        original: original?.waves[index],
        heard: blowing.includes(wave),
        open: editor.preferences.folds[`wave-${index + 1}`] ?? false,
        onOpen: (open) => {
          editor.actions.setFold(`wave-${index + 1}`, open);
          this.requestUpdate();
        },
        onGrip: (event) => this.pull(event, index),
        onMove: (to) => this.move(index, to),
      }),
    )}</div>
    ${wind.waves.length === 0 ? html`<p class="soft empty">${mixerWords.none}</p>` : ''}
    <button type="button" class="quiet add" ?disabled=${most} @click=${() => this.add()}>${icon('plus')}<span>${mixerWords.add}</span></button>
    ${most ? html`<span class="soft">${mixerWords.most}</span>` : ''}`;
  }

  protected override updated(changes: PropertyValues): void {
    super.updated(changes);
    for (const canvas of this.querySelectorAll('canvas')) this.sizes.observe(canvas);
    this.draw(this.editor.actions.time());
  }

  private add(): void {
    const place = this.editor.actions.addWave();
    if (place === null) return;
    this.editor.actions.setFold(`wave-${place + 1}`, true);
    void this.updateComplete.then(() => this.querySelector<HTMLElement>(`#wave-${place + 1}-amplitude`)?.focus());
  }

  private move(from: number, to: number): void {
    this.editor.actions.moveWave(from, to);
    const place = Math.min(this.editor.actions.edited().wind.waves.length - 1, Math.max(0, to));
    void this.updateComplete.then(() => this.querySelectorAll<HTMLElement>('.grip')[place]?.focus());
  }

  /** Pulls a row to another place: the row under the finger shows where it would go; Escape leaves it where it was. */
  private pull(event: PointerEvent, from: number): void {
    if (event.button !== 0) return;
    const grip = event.currentTarget as HTMLElement;
    const rows = [...this.querySelectorAll<HTMLElement>('.wave')];
    const controller = new AbortController();
    const { signal } = controller;
    let to = from;
    grip.setPointerCapture(event.pointerId);
    const mark = (): void => {
      rows.forEach((row, i) => {
        row.toggleAttribute('data-pulled', i === from && to !== from);
        row.toggleAttribute('data-before', i === to && to < from);
        row.toggleAttribute('data-after', i === to && to > from);
      });
    };
    const end = (): void => {
      controller.abort();
      for (const row of rows)
        for (const name of ['data-pulled', 'data-before', 'data-after']) row.removeAttribute(name);
    };
    const listen = <K extends keyof HTMLElementEventMap>(name: K, act: (e: HTMLElementEventMap[K]) => void): void =>
      grip.addEventListener(name, act, { signal });
    listen('pointermove', (e) => {
      const at = rows.findIndex((row) => e.clientY < row.getBoundingClientRect().bottom);
      to = at < 0 ? rows.length - 1 : at;
      mark();
    });
    listen('pointerup', () => {
      end();
      if (to !== from) this.move(from, to);
    });
    listen('pointercancel', end);
    listen('keydown', (e) => {
      if (e.key !== 'Escape') return;
      e.stopPropagation();
      end();
    });
  }

  private draw(time: number): void {
    const canvases = this.querySelectorAll<HTMLCanvasElement>('canvas.trace');
    if (canvases.length === 0) return;
    const { wind } = this.editor.actions.edited();
    const { blowing } = this.doc;
    const heard = new Set<Wave>(blowing ? blowingWaves(wind) : []);
    const loudest = loudestOf(wind);
    this.colours ??= coloursOf(this);
    for (const canvas of canvases) {
      const wave = wind.waves[Number(canvas.dataset.wave)];
      if (!wave || canvas.width === 0) continue;
      const share = loudest > 0 ? wave.amplitude / loudest : 0;
      drawTrace(canvas, wave, time, { share, heard: heard.has(wave), paper: wind.paper, colours: this.colours });
    }
  }
}

const loudestOf = ({ waves }: Wind): number => waves.reduce((most, { amplitude }) => Math.max(most, amplitude), 0);

function coloursOf(element: HTMLElement): TraceColours {
  const style = getComputedStyle(element);
  const of = (name: string): string => style.getPropertyValue(name).trim();
  return { line: of('--force'), area: of('--force-soft'), quiet: of('--line') };
}

customElements.define('wg-mixer', Mixer);
