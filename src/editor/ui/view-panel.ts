import { html, type TemplateResult } from 'lit';
import type { Theme, ViewMode } from '../../core/link/link.ts';
import { choice } from './choice.ts';
import { icon } from './icons.ts';
import { Part } from './panel.ts';

const views: readonly { value: ViewMode; label: string; title: string }[] = [
  { value: 'shaded', label: 'Shaded', title: 'As it looks (Q)' },
  { value: 'wireframe', label: 'Wireframe', title: 'The triangles that are drawn (W)' },
  { value: 'control', label: 'Curves', title: 'Control polygons of the pieces, with their frames (E)' },
  { value: 'levels', label: 'Levels', title: 'Each level of stems in its colour (R)' },
];
const themes: readonly { value: Theme; label: string; icon: 'half' | 'sun' | 'moon' }[] = [
  { value: 'auto', label: 'Colours of your system', icon: 'half' },
  { value: 'light', label: 'Light colours', icon: 'sun' },
  { value: 'dark', label: 'Dark colours', icon: 'moon' },
];

/** How it is shown: view, whole tree, theme, link, help. */
class ViewPanel extends Part {
  protected override render(): TemplateResult {
    const { doc, editor } = this;
    return html`
      ${choice({
        name: 'view',
        legend: 'View',
        quiet: !this.session.narrow,
        value: doc.view,
        options: views,
        onChoose: (view) => editor.actions.setView(view),
      })}
      ${choice({
        name: 'theme',
        legend: 'Theme',
        quiet: !this.session.narrow,
        value: doc.theme,
        options: themes.map((t) => ({
          value: t.value,
          title: t.label,
          label: html`${icon(t.icon)}<span class="spoken">${t.label}</span>`,
        })),
        onChoose: (theme) => editor.actions.setTheme(theme),
      })}
      <div class="buttons">
        <button type="button" class="quiet" @click=${() => editor.actions.setCamera(null)} title="The whole tree in the window (F)"
          ?disabled=${doc.camera === null}>${icon('frame')}<span>Whole tree</span></button>
        <button type="button" class="quiet" @click=${() => editor.actions.share()} title="Copy a link to exactly this (C)">
          ${icon('link')}<span>Copy link</span></button>
        <button type="button" class="quiet" @click=${() => editor.actions.setHelp(true)} title="Keys and help (?)">
          ${icon('help')}<span>Help</span></button>
      </div>`;
  }
}

customElements.define('wg-view', ViewPanel);
