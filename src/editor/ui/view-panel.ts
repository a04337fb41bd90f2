import { html, type TemplateResult } from 'lit';
import { THEMES, type ViewMode } from '../../core/link/link.ts';
import { type CommandId, withKeys } from '../shortcuts.ts';
import { topWords, viewWords } from '../words/top-bar.ts';
import { choice } from './choice.ts';
import { type Icon, icon } from './icons.ts';
import { menu } from './menu.ts';
import { Part } from './panel.ts';

const views: readonly (readonly [ViewMode, CommandId])[] = [
  ['shaded', 'shaded'],
  ['wireframe', 'wireframe'],
  ['control', 'control'],
  ['levels', 'levelColours'],
];
const signs: Record<(typeof THEMES)[number], Icon> = { auto: 'half', light: 'sun', dark: 'moon' };

/** How it is shown: view, whole tree, season and stage, theme. */
class ViewPanel extends Part {
  protected override render(): TemplateResult {
    const { narrow } = this.session;
    const { theme } = this.doc;
    // It comes with the panels.
    const scene = this.session.panels ? html`<wg-scene .editor=${this.editor}></wg-scene>` : html``;
    return html`${this.view()}${this.whole()}${
      narrow
        ? html`${scene}${this.theme()}`
        : html`${menu({ id: 'scene-menu', icon: 'scene', label: topWords.scene, quiet: true, content: scene })}${menu({ id: 'theme-menu', icon: signs[theme], label: topWords.theme, quiet: true, content: this.theme() })}`
    }`;
  }

  private view(): TemplateResult {
    return choice({
      name: 'view',
      legend: viewWords.legend,
      quiet: !this.session.narrow,
      value: this.doc.view,
      options: views.map(([value, id]) => ({
        value,
        label: viewWords[value][0],
        title: withKeys(id, viewWords[value][1]),
      })),
      onChoose: (view) => this.editor.actions.setView(view),
    });
  }

  private theme(): TemplateResult {
    return choice({
      name: 'theme',
      legend: topWords.theme,
      value: this.doc.theme,
      options: THEMES.map((value) => ({ value, label: html`${icon(signs[value])}${viewWords.themes[value]}` })),
      onChoose: (theme) => this.editor.actions.setTheme(theme),
    });
  }

  private whole(): TemplateResult {
    return html`<button type="button" class="quiet whole" title=${withKeys('whole', viewWords.wholeTitle)}
      ?disabled=${this.doc.camera === null} @click=${() => this.editor.actions.setCamera(null)}>
      ${icon('frame')}<span class=${this.session.narrow ? '' : 'spoken'}>${viewWords.whole}</span></button>`;
  }
}

customElements.define('wg-view', ViewPanel);
