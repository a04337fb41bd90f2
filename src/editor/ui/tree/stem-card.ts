import { html, nothing, type PropertyValues, type TemplateResult } from 'lit';
import type { StemTable } from '../../../core/pack/stem-table.ts';
import { stemName } from '../../actions-stem.ts';
import { stemWords } from '../../words/stem.ts';
import { treeWords } from '../../words/tree.ts';
import { icon } from '../icons.ts';
import { Part } from '../panel.ts';
import { showPanel } from '../show-panel.ts';

const words = stemWords;
const LAST_LEVEL = 3;

/** Pixels from the pointer to the name of the stem under it. */
const BESIDE = 14;

/** The piece with which a stem ends. */
const lastPiece = (stems: StemTable, stem: number): number => stems.stemOfPiece.lastIndexOf(stem);

/** What is known of the stem that is selected in the scene, and the name of the one under the pointer. */
class StemCard extends Part {
  private seen: readonly unknown[] = [];

  protected override shouldUpdate(changed: PropertyValues): boolean {
    const { stem, hoveredStem, tree, insets, narrow } = this.session;
    const now = [stem, hoveredStem, tree?.stems, insets, narrow];
    const same = now.every((value, i) => Object.is(value, this.seen[i]));
    this.seen = now;
    return changed.size > 0 || !same;
  }

  override connectedCallback(): void {
    super.connectedCallback();
    window.addEventListener('pointermove', this.follow);
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    window.removeEventListener('pointermove', this.follow);
  }

  /** No state: a name that follows the mouse must not draw the interface anew. */
  private readonly follow = (event: PointerEvent): void => {
    this.style.setProperty('--pointer-x', `${Math.min(event.clientX + BESIDE, window.innerWidth - 160)}px`);
    this.style.setProperty('--pointer-y', `${event.clientY + BESIDE}px`);
  };

  protected override render(): TemplateResult | typeof nothing {
    const { tree, stem, hoveredStem } = this.session;
    if (!tree) return nothing;
    return html`${stem === null ? nothing : this.card(tree.stems, stem)}
      ${hoveredStem === null || hoveredStem === stem ? nothing : html`<p class="stem-name" aria-hidden="true">${this.chip(tree.stems, hoveredStem)}${stemName(tree.stems, hoveredStem)}</p>`}`;
  }

  private chip(stems: StemTable, stem: number): TemplateResult {
    return html`<span class="chip" data-level=${Math.min(stems.level[stem] ?? 0, LAST_LEVEL)}></span>`;
  }

  private card(stems: StemTable, stem: number): TemplateResult {
    const { editor } = this;
    const level = stems.level[stem]!;
    const radius = stems.radius[stem]!;
    const rows: readonly (readonly [string, string, string])[] = [
      [words.length, stems.length[stem]!.toFixed(2), 'm'],
      [words.radius, (1000 * radius).toFixed(radius < 0.01 ? 1 : 0), 'mm'],
      [level === 0 ? words.lean : words.downAngle, stems.downAngle[stem]!.toFixed(0), '°'],
      ...(stems.parent[stem]! < 0 ? [] : [[words.place, (100 * stems.parentZ[stem]!).toFixed(0), '%'] as const]),
    ];
    const shown = Math.min(level, LAST_LEVEL);
    const shape = (): void => {
      editor.actions.setLevel(shown);
      editor.actions.setFold('tree-levels', true);
      void showPanel(editor, 'grow').then(() => {
        const tab = document.querySelector<HTMLElement>(`#level-tab-${shown}`);
        tab?.scrollIntoView({ block: 'start' });
        tab?.focus({ preventScroll: true });
      });
    };
    const probe = (): void => {
      editor.actions.setProbe(lastPiece(stems, stem));
      void showPanel(editor, 'studio');
    };
    return html`<section class="stem-card paper" aria-label=${words.card} style="--foot: ${this.session.insets.bottom}px">
      <div class="stem-head"><h2>${this.chip(stems, stem)}${stemName(stems, stem)}</h2>
        <button type="button" class="round" aria-label=${words.close} title="${words.close} (Esc)" @click=${() => editor.actions.selectStem(null)}>${icon('close')}</button></div>
      <dl class="figures">${rows.map(
        ([name, value, unit]) => html`<div><dt>${name}</dt><dd>${value}<span class="unit">${unit}</span></dd></div>`,
      )}</dl>
      <div class="stem-links"><button type="button" class="text" @click=${shape}>${level === 0 ? words.editTrunk : words.edit(treeWords.levels[shown]!)}</button>
        <button type="button" class="text" @click=${probe}>${words.probe}</button></div>
    </section>`;
  }
}

customElements.define('wg-stem', StemCard);
