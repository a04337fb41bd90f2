import { html, type PropertyValues, type TemplateResult } from 'lit';
import { shortcuts } from '../shortcuts.ts';
import { toggle } from './choice.ts';
import { icon } from './icons.ts';
import { Part } from './panel.ts';

/** The keys, drawn from the table that acts on them, and what the mouse does. */
class Help extends Part {
  protected override render(): TemplateResult {
    const { actions, preferences } = this.editor;
    const groups = [...new Set(shortcuts.map((s) => s.group))];
    return html`<dialog class="help" aria-labelledby="help-title" @close=${() => actions.setHelp(false)}>
      <header><h2 id="help-title">Keys and help</h2>
        <button type="button" class="round" aria-label="Close help" @click=${() => actions.setHelp(false)}>${icon('close')}</button></header>
      <p>Drag the picture to walk around the tree, scroll or pinch to come closer, drag with the right button or two fingers to move aside.
        Every number can be typed; double-click a slider to put it back. The address always holds what you see.</p>
      <div class="keys">${groups.map(
        (group) =>
          html`<section><h3>${group}</h3><dl>${shortcuts
            .filter((s) => s.group === group)
            .map(
              (s) => html`<div><dt>${s.keys.map((k) => html`<kbd>${k.shown}</kbd>`)}</dt><dd>${s.label}</dd></div>`,
            )}</dl></section>`,
      )}</div>
      ${toggle('shortcuts', 'Single keys act anywhere on the page', preferences.shortcuts, (on) => actions.setShortcuts(on))}
      <p class="source">Trees after Weber &amp; Penn (1995), moved after Skjermo (2006, 2007).</p>
    </dialog>`;
  }

  protected override updated(changes: PropertyValues): void {
    super.updated(changes);
    const dialog = this.querySelector('dialog')!;
    if (this.session.help && !dialog.open) dialog.showModal();
    if (!this.session.help && dialog.open) dialog.close();
  }
}

customElements.define('wg-help', Help);
