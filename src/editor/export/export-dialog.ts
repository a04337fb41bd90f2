import { html, nothing, type TemplateResult } from 'lit';
import { live } from 'lit/directives/live.js';
import type { ExportOptions } from '../../core/io/export-options.ts';
import { fileName } from '../../core/io/export-tree.ts';
import type { LoopGap } from '../../core/wind/loop.ts';
import '../styles/export.css';
import { Part } from '../ui/panel.ts';
import { exportWords } from '../words/export.ts';
import './channel-preview.ts';
import { estimateOf, meshesOf } from './estimate.ts';
import { roundCount, sizeText } from './figures.ts';
import { filmOf } from './film.ts';
import { choicesOf, isFormat, isPicture, KINDS, type Kind, rowsOf, SECTIONS } from './kinds.ts';
import { MeshCounter } from './mesh-counter.ts';
import { optionRow } from './option-row.ts';
import type { PictureOptions } from './picture-options.ts';
import { NoEncoder, type Progress, runExport, type Subject } from './run-export.ts';

/** How a run ended. */
type Outcome =
  | { readonly kind: 'saved'; readonly name: string; readonly bytes: number }
  | { readonly kind: 'cancelled' }
  | { readonly kind: 'failed'; readonly why: string; readonly noEncoder: boolean };

const SIZES = { hd: [1920, 1080], uhd: [3840, 2160], square: [2048, 2048], tall: [1080, 1920] } as const;

/** What the tree can be taken away as: a list, the options of what is chosen, what it will be, and a button. */
class Export extends Part {
  private kind: Kind | null = null;
  private run: AbortController | null = null;
  private progress: Progress | null = null;
  private outcome: Outcome | null = null;
  private readonly counter = new MeshCounter(() => this.requestUpdate());

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    this.run?.abort();
    this.counter.stop();
    this.outcome = null;
  }

  /** The kind that was chosen last, in this visit or another. */
  private get chosen(): Kind {
    const last = this.editor.preferences.exports.last?.kind;
    return this.kind ?? KINDS.find((kind) => kind === last) ?? 'glb';
  }

  protected override render(): TemplateResult {
    if (!this.session.tree) return html`<p class="soft">${exportWords.noTree}</p>`;
    const { chosen } = this;
    const words = exportWords.kinds[chosen];
    return html`<form class="export" novalidate @submit=${this.start}>
      ${this.list()}
      <div class="export-options">
        <h3>${words.name}</h3><p class="soft">${words.about}</p>
        ${this.options()}
        ${chosen === 'channels' ? html`<wg-channel-preview .editor=${this.editor}></wg-channel-preview>` : nothing}
      </div>
      <footer class="export-foot">${this.status()}${this.buttons()}</footer>
    </form>`;
  }

  private list(): TemplateResult {
    const busy = this.run !== null;
    return html`<fieldset class="export-kinds" ?disabled=${busy}><legend class="spoken">${exportWords.listLabel}</legend>${SECTIONS.map(
      ({ name, kinds }) =>
        html`<div class="export-section"><h3 aria-hidden="true">${exportWords.sections[name]}</h3>${kinds.map(
          (
            kind,
          ) => html`<label class="export-kind"><input type="radio" name="export-kind" value=${kind} ?autofocus=${kind === this.chosen}
          .checked=${live(kind === this.chosen)} @change=${() => this.choose(kind)}>
          <span>${exportWords.kinds[kind].name}</span> <small>${exportWords.kinds[kind].ending}</small></label>`,
        )}</div>`,
    )}</fieldset>`;
  }

  private get choices(): ExportOptions | PictureOptions {
    return choicesOf(this.chosen, this.editor.preferences);
  }

  private options(): TemplateResult {
    const { chosen, choices } = this;
    const busy = this.run !== null;
    const values = choices as unknown as Readonly<Record<string, unknown>>;
    return html`${isPicture(chosen) ? this.sizes(busy) : nothing}
      <div class="options-grid">${rowsOf(chosen, values).map((row) =>
        optionRow(row, values[row.key], busy, (value) => this.set({ [row.key]: value })),
      )}</div>${this.warnings()}`;
  }

  private sizes(busy: boolean): TemplateResult {
    const set =
      ([width, height]: readonly [number, number]) =>
      () =>
        this.set({ width, height });
    const ratio = window.devicePixelRatio;
    const [w, h] = [window.innerWidth, window.innerHeight].map((side) => 2 * Math.round((side * ratio) / 2)) as [
      number,
      number,
    ];
    return html`<div class="export-sizes" role="group" aria-label=${exportWords.sizesLabel}>
      <button type="button" class="quiet" ?disabled=${busy} @click=${set([w, h])}>${exportWords.sizes.screen}</button>
      ${(Object.keys(SIZES) as (keyof typeof SIZES)[]).map(
        (size) =>
          html`<button type="button" class="quiet" ?disabled=${busy} @click=${set(SIZES[size])}>${exportWords.sizes[size]}</button>`,
      )}</div>`;
  }

  /** What of the wind will not be as it is wished. */
  private warnings(): TemplateResult | typeof nothing {
    const { chosen, choices, doc } = this;
    const moves =
      chosen === 'sequence' || chosen === 'video' || ('clip' in choices && chosen === 'glb' && choices.clip);
    if (!moves) return nothing;
    const lines: string[] = [];
    if (!doc.blowing) lines.push(exportWords.still);
    else if ('loop' in choices && choices.loop) {
      lines.push(...filmOf(doc.wind, 0, choices).open.map((gap: LoopGap) => exportWords.seams[gap]));
    }
    return lines.length > 0 ? html`<p class="export-note">${lines.join(' ')}</p>` : nothing;
  }

  private status(): TemplateResult {
    const { progress, outcome, run } = this;
    if (run) {
      const frame = progress?.frame;
      const stage = exportWords.stages[progress?.stage ?? 'open'] ?? '';
      return html`<div class="export-status" role="status"><span>${frame ? exportWords.frame(frame.done, frame.all) : stage}</span>
        <progress max="1" .value=${progress?.done ?? 0} aria-label=${stage}></progress></div>`;
    }
    return html`<div class="export-status" role="status">${outcome ? this.ended(outcome) : this.estimate()}</div>`;
  }

  private ended(outcome: Outcome): TemplateResult {
    if (outcome.kind === 'cancelled') return html`<span>${exportWords.cancelled}</span>`;
    if (outcome.kind === 'saved')
      return html`<span class="export-saved">${exportWords.saved(outcome.name, sizeText(outcome.bytes))}</span>`;
    return html`<span class="export-failed">${outcome.why}</span>
      ${outcome.noEncoder ? html`<button type="button" class="text" @click=${() => this.choose('sequence')}>${exportWords.takesSequence}</button>` : nothing}`;
  }

  private estimate(): TemplateResult | typeof nothing {
    const { tree } = this.session;
    const { chosen, choices } = this;
    const meshes = tree && isFormat(chosen) ? this.counter.of(tree, meshesOf(chosen, choices as ExportOptions)) : null;
    const estimate = tree && estimateOf(chosen, tree, choices, meshes);
    if (!estimate)
      return this.counter.busy ? html`<span class="soft">${exportWords.estimate.counting}</span>` : nothing;
    const parts = [
      estimate.triangles !== undefined && exportWords.estimate.triangles(roundCount(estimate.triangles)),
      estimate.frames !== undefined && exportWords.estimate.frames(estimate.frames),
      estimate.bytes !== undefined && exportWords.estimate.size(sizeText(estimate.bytes)),
    ].filter((part) => part !== false);
    return html`<span class="soft">${exportWords.estimate.label}</span> <span class="export-figures">${parts.join(' · ')}</span>
      ${estimate.large ? html`<span class="soft">${exportWords.estimate.large}</span>` : nothing}`;
  }

  private buttons(): TemplateResult {
    if (this.run)
      return html`<button type="button" class="quiet" @click=${() => this.run?.abort()}>${exportWords.cancel}</button>`;
    return html`<button type="submit" class="primary">${exportWords.act[this.chosen]}</button>`;
  }

  private choose(kind: Kind): void {
    this.kind = kind;
    this.outcome = null;
    this.editor.actions.rememberExport('last', { kind });
    this.requestUpdate();
  }

  private set(change: Readonly<Record<string, unknown>>): void {
    this.outcome = null;
    this.editor.actions.rememberExport(this.chosen, { ...this.choices, ...change });
    this.requestUpdate();
  }

  private subject(): Subject | null {
    const { tree } = this.session;
    const { actions, picture } = this.editor;
    if (!tree) return null;
    const { doc } = this;
    const species = doc.treeName === null ? tree.species : { ...tree.species, name: doc.treeName };
    const wind = doc.blowing ? doc.wind : { ...doc.wind, strength: 0 };
    return { species, seed: tree.seed, wind, time: actions.time(), picture, name: fileName(species.name, tree.seed) };
  }

  private readonly start = (event: Event): void => {
    event.preventDefault();
    const { chosen, editor } = this;
    if (chosen === 'project') {
      void editor.actions.saveAs();
      return;
    }
    const subject = this.subject();
    if (this.run || !subject) return;
    const choices = isFormat(chosen)
      ? { ...this.choices, season: this.doc.season, link: editor.actions.linkNow() }
      : this.choices;
    void this.go(chosen, subject, choices);
  };

  private async go(kind: Kind, subject: Subject, choices: ExportOptions | PictureOptions): Promise<void> {
    const run = new AbortController();
    this.run = run;
    this.progress = null;
    this.outcome = null;
    this.requestUpdate();
    await this.updateComplete;
    // What had the focus has gone: to the one thing that can be done now.
    this.querySelector<HTMLButtonElement>('.export-foot button')?.focus();
    try {
      const { name, blob } = await runExport(kind, subject, choices, run.signal, (progress) => {
        this.progress = progress;
        this.requestUpdate();
      });
      run.signal.throwIfAborted();
      this.editor.actions.saveFile(name, blob);
      this.outcome = { kind: 'saved', name, bytes: blob.size };
    } catch (error) {
      this.outcome = run.signal.aborted ? { kind: 'cancelled' } : failure(error);
    }
    this.run = null;
    this.progress = null;
    this.requestUpdate();
    await this.updateComplete;
    this.querySelector<HTMLButtonElement>('.export-foot .primary')?.focus();
  }
}

function failure(error: unknown): Outcome {
  if (error instanceof NoEncoder) {
    const why = typeof VideoEncoder === 'undefined' ? exportWords.noEncoderHere : exportWords.noEncoder;
    return { kind: 'failed', why, noEncoder: true };
  }
  const why = exportWords.failed(error instanceof Error ? error.message : String(error));
  return { kind: 'failed', why, noEncoder: false };
}

customElements.define('wg-export', Export);
