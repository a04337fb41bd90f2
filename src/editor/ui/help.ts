import { html, type TemplateResult } from 'lit';
import { COMMANDS, type CommandGroup, keysOf } from '../shortcuts.ts';
import { commandWords } from '../words/commands.ts';
import { helpWords } from '../words/help.ts';
import { pageWords } from '../words/pages.ts';
import { toggle } from './choice.ts';
import { icon } from './icons.ts';
import { Part } from './panel.ts';

/** The keys, drawn from the table that acts on them, and what the mouse does. */
class Help extends Part {
  protected override render(): TemplateResult {
    const { actions, preferences } = this.editor;
    const groups = Object.keys(commandWords.groups) as CommandGroup[];
    return html`<p>${helpWords.how}</p>
      <div class="help-deeds">
        <button type="button" class="quiet" @click=${() => actions.openDialog('tour')}>${icon('walk')}<span>${helpWords.tour}</span></button>
        <button type="button" class="quiet" @click=${() => actions.openDialog('palette')}>${icon('find')}<span>${helpWords.find}</span>
          <kbd>${keysOf('palette')[0]}</kbd></button>
      </div>
      <div class="keys">${groups.map((group) => this.group(group))}</div>
      ${toggle('shortcuts', helpWords.single, preferences.shortcuts, (on) => actions.setShortcuts(on))}
      <nav class="keys" aria-label=${pageWords.heading}><section><h3>${pageWords.heading}</h3><dl>${pageWords.pages.map(
        ({ name, about, href }) => html`<div><dt><a href=${href}>${name}</a></dt><dd>${about}</dd></div>`,
      )}</dl></section></nav>
      <p class="source">${helpWords.source}</p>`;
  }

  private group(group: CommandGroup): TemplateResult {
    const rows = COMMANDS.filter((c) => c.group === group && c.keys.length > 0);
    if (rows.length === 0) return html``;
    return html`<section><h3>${commandWords.groups[group]}</h3><dl>${rows.map(
      ({ id }) =>
        html`<div><dt>${keysOf(id).map((k) => html`<kbd>${k}</kbd>`)}</dt><dd>${commandWords.labels[id]}</dd></div>`,
    )}</dl></section>`;
  }
}

customElements.define('wg-help', Help);
