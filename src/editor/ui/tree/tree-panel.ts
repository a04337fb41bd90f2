import { html, nothing, type PropertyValues, type TemplateResult } from 'lit';
import { guard } from 'lit/directives/guard.js';
import { live } from 'lit/directives/live.js';
import { editSpecies, type ParameterValue, PLACES, type SpeciesEdits } from '../../../core/species/edits.ts';
import type { NumberParameter } from '../../../core/species/parameter.ts';
import { LONGEST_NAME } from '../../../core/species/parse.ts';
import { SEASONS } from '../../../core/species/season.ts';
import type { Species } from '../../../core/species/species.ts';
import { treeWords } from '../../words/tree.ts';
import { choice, toggle } from '../choice.ts';
import { icon } from '../icons.ts';
import { Part } from '../panel.ts';
import { unlessTyping } from '../unless-typing.ts';
import { type Range, sliderRange } from './comfort.ts';
import { type Context, stateOf } from './context.ts';
import { envelopeEditor } from './envelope-editor.ts';
import { type Explained, explainedBy, placePopover, popoverContent } from './help-popover.ts';
import { listenToEdits } from './hold-edits.ts';
import { levelTable } from './level-table.ts';
import { noEffect } from './no-effect.ts';
import { parameterRow } from './parameter-row.ts';
import { isFound } from './search.ts';
import { pathsOfRow, pathsOfSection, type Row, SECTIONS, type Section } from './sections.ts';
import { type Silhouette, silhouette } from './silhouette.ts';

/** Sections that are open at first. */
const OPEN: readonly string[] = ['tree', 'levels'];

/** Pixels of the stems' numbers that must be in view when a stem is selected. */
const LEAST_SEEN = 160;

/** Pixels of the panel that show the levels side by side. */
const TABLE_WIDTH = 640;

/** Every parameter of the tree, generated from the parameter table. */
class TreePanel extends Part {
  private seen: readonly unknown[] = [];
  private turn = 0;
  private query = '';
  private changedOnly = false;
  private wrong: string | null = null;
  private explained: Explained | null = null;
  private table = false;
  private readonly reaches = new Map<string, Range>();
  private readonly halves = new Map<string, number>();
  private edited: { base: Species; edits: SpeciesEdits; species: Species } | null = null;
  private outline: { of: unknown; drawn: Silhouette } | null = null;
  private toLevels = false;
  private lastStem: number | null = null;
  private widthBefore: number | null = null;
  private stopHolding = (): void => {};

  /** A document changes with every step of a slider, of the wind, of time: only what is shown here draws here. */
  protected override shouldUpdate(changed: PropertyValues): boolean {
    const { doc, session } = this;
    const now = [
      doc.edits,
      doc.treeName,
      doc.wind.model,
      doc.season,
      session.tree?.stems,
      session.tree?.base,
      session.level,
      session.locks,
      session.peek,
      session.narrow,
      session.stem,
      this.turn,
    ];
    const same = now.every((value, i) => Object.is(value, this.seen[i]));
    this.seen = now;
    return changed.size > 0 || !same;
  }

  private again(): void {
    this.turn++;
    this.requestUpdate();
  }

  protected override willUpdate(): void {
    const { stem, tree } = this.session;
    this.toLevels = stem !== null && stem !== this.lastStem && tree !== null;
    if (this.toLevels) this.openFold('levels');
    this.lastStem = stem;
  }

  protected override updated(): void {
    if (!this.toLevels) return;
    this.toLevels = false;
    const tabs = this.querySelector<HTMLElement>('.tree-fold[data-section="levels"]');
    const body = this.closest<HTMLElement>('.body, [role="tabpanel"]:not(.level-panel)');
    if (!tabs || !body) return;
    const { top } = tabs.getBoundingClientRect();
    const seen = body.getBoundingClientRect();
    // Numbers of another level may stand in view already: then nothing moves.
    if (top > seen.bottom - LEAST_SEEN || top < seen.top - tabs.offsetHeight + LEAST_SEEN) tabs.scrollIntoView();
  }

  protected override render(): TemplateResult | typeof nothing {
    const { tree } = this.session;
    if (!tree) return nothing;
    const c = this.context(tree.base);
    const filtered = this.query.trim() !== '' || this.changedOnly;
    return html`${this.tools(c)}
      <div class="sections" ?data-peek=${this.session.peek}>${filtered ? this.filtered(c) : this.all(c)}</div>
      <div class="parameter-help paper" popover role="dialog" aria-label=${this.explained ? treeWords.about(PLACES.get(this.explained.path)!.parameter.label) : nothing}
        @toggle=${this.onPopover}>${this.explained ? popoverContent(c, this.explained, () => this.explainer().hidePopover()) : nothing}</div>`;
  }

  private context(base: Species): Context {
    const { editor, doc, session } = this;
    const { edits } = doc;
    if (this.edited?.base !== base || this.edited.edits !== edits) {
      if (this.edited?.base.name !== base.name) {
        this.reaches.clear();
        this.halves.clear();
      }
      this.edited = { base, edits, species: editSpecies(base, edits) };
    }
    const { species } = this.edited;
    const set = (values: Readonly<Record<string, ParameterValue>>): void => {
      this.setWrong(null);
      if (!editor.actions.setParameters(values)) this.setWrong(Object.keys(values)[0]!);
    };
    const c: Context = {
      editor,
      base,
      species,
      locks: session.locks,
      wrong: this.wrong,
      why: (path) => noEffect(path, species, doc.wind.model),
      reach: (path) => {
        const parameter = PLACES.get(path)!.parameter;
        if (parameter.kind !== 'number') return { min: 0, max: 0 };
        const { value, first } = stateOf(c, path);
        return this.reach(path, parameter, value, first);
      },
      set: (path, value) => set({ [path]: value }),
      setAll: set,
      setWrong: (path) => this.setWrong(path),
      silhouette: () => this.silhouette(),
      stretch: (drawing, half) => {
        const wide = Math.max(half, this.halves.get(drawing) ?? 0);
        this.halves.set(drawing, wide);
        return wide;
      },
      explain: (path, anchor) => void this.explain(path, anchor),
    };
    return c;
  }

  /** A slider that was stretched stays so: it must not shrink under the hand. */
  private reach(path: string, parameter: NumberParameter, value: ParameterValue, first: ParameterValue): Range {
    const before = this.reaches.get(path);
    const numbers = [value, first].map((v) => (typeof v === 'number' ? v : undefined));
    if (before && numbers.every((v) => v === undefined || (v >= before.min && v <= before.max))) return before;
    const range = sliderRange(parameter, [...numbers, before?.min, before?.max]);
    this.reaches.set(path, range);
    return range;
  }

  private silhouette(): Silhouette | null {
    const { tree } = this.session;
    if (!tree) return null;
    if (this.outline?.of !== tree.stems)
      this.outline = { of: tree.stems, drawn: silhouette(tree.stems, tree.species, tree.seed) };
    return this.outline.drawn;
  }

  private setWrong(path: string | null): void {
    if (this.wrong === path) return;
    this.wrong = path;
    this.again();
  }

  private tools(c: Context): TemplateResult {
    const { editor, doc, session } = this;
    const count = Object.keys(doc.edits).length;
    const peek = (on: boolean) => (event: Event) => {
      if (event instanceof PointerEvent && on) (event.currentTarget as Element).setPointerCapture(event.pointerId);
      editor.actions.setPeek(on);
    };
    const key = (on: boolean) => (event: KeyboardEvent) => {
      if (event.key !== ' ' && event.key !== 'Enter') return;
      event.preventDefault();
      event.stopPropagation();
      if (!event.repeat) editor.actions.setPeek(on);
    };
    return html`<div class="tree-tools">
      ${count === 0 && doc.treeName === null ? nothing : this.name(c)}
      <label class="tree-search">${icon('find')}<input type="search" id="find-parameter" placeholder=${treeWords.search} aria-label=${treeWords.search}
        autocomplete="off" spellcheck="false" .value=${live(this.query)} @input=${(e: Event) => {
          this.query = (e.target as HTMLInputElement).value;
          this.again();
        }}></label>
      <div class="tree-state">${toggle('changed-only', treeWords.changedOnly, this.changedOnly, (on) => {
        this.changedOnly = on;
        this.again();
      })}<span class="changes" role="status">${treeWords.changes(count)}</span></div>
      ${
        count === 0 && session.locks.size === 0
          ? nothing
          : html`<div class="tree-buttons">${
              count === 0
                ? nothing
                : html`<button type="button" class="quiet peek" aria-pressed=${session.peek} title=${treeWords.peekHint}
                @pointerdown=${peek(true)} @pointerup=${peek(false)} @pointercancel=${peek(false)} @lostpointercapture=${peek(false)}
                @keydown=${key(true)} @keyup=${key(false)} @blur=${peek(false)}>${icon('eye')}<span>${treeWords.peek}</span></button>
              <button type="button" class="quiet" title=${treeWords.resetAllHint} @click=${() => editor.actions.resetAll()}>${icon('reset')}<span>${treeWords.resetAll}</span></button>`
            }${
              session.locks.size === 0
                ? nothing
                : html`<button type="button" class="quiet" @click=${() => editor.actions.clearLocks()} title=${treeWords.locked(session.locks.size)}>${icon('unlock')}<span>${treeWords.unlockAll}</span></button>`
            }</div>`
      }
    </div>`;
  }

  /** Who has changed a tree may give it a name of its own. */
  private name(c: Context): TemplateResult {
    const { editor, doc } = this;
    const typed = (event: Event): void => {
      const box = event.target as HTMLInputElement;
      editor.actions.setName(box.value);
      box.value = this.doc.treeName ?? c.base.name;
    };
    return html`<div class="tree-name"><label for="tree-name">${treeWords.nameLabel}</label><input type="text" id="tree-name" maxlength=${LONGEST_NAME}
      spellcheck="false" autocomplete="off" aria-label=${treeWords.name} .value=${unlessTyping(doc.treeName ?? c.base.name)} @change=${typed}></div>`;
  }

  /** Rows that are searched for, or changed; all levels, and nothing folded. */
  private filtered(c: Context): TemplateResult {
    const wanted = (row: Row): boolean => {
      const paths = pathsOfRow(row);
      return (
        paths.some((path) => isFound(path, this.query)) &&
        (!this.changedOnly || paths.some((p) => stateOf(c, p).changed))
      );
    };
    const sections = SECTIONS.map((section) => ({
      section,
      rows: section.groups.flatMap((g) => g.rows).filter(wanted),
    })).filter(({ rows }) => rows.length > 0);
    const count = sections.reduce((sum, { rows }) => sum + rows.length, 0);
    if (count === 0)
      return html`<p class="note" role="status">${this.query.trim() ? treeWords.noneFound : treeWords.noneChanged}</p>`;
    return html`<p class="spoken" role="status">${treeWords.found(count)}</p>${sections.map(
      ({
        section,
        rows,
      }) => html`<section class="found" aria-label=${treeWords.sections[section.id]}><p class="rows-title">${this.chip(section)}${treeWords.sections[section.id]}</p>
        ${this.rows(c, rows)}</section>`,
    )}`;
  }

  private all(c: Context): TemplateResult {
    const levels = SECTIONS.filter((s) => s.level !== undefined);
    const [first, ...others] = SECTIONS.filter((s) => s.level === undefined);
    return html`${this.fold(c, 'tree', treeWords.sections.tree, [first!], () => this.groups(c, first!))}
      ${this.fold(c, 'levels', treeWords.stems, levels, () => this.levels(c, levels))}
      ${others.map((section) => this.fold(c, section.id, treeWords.sections[section.id], [section], () => this.groups(c, section)))}`;
  }

  private chip(section: Section): TemplateResult | typeof nothing {
    return section.level === undefined ? nothing : html`<span class="chip" data-level=${section.level}></span>`;
  }

  private isOpen(name: string): boolean {
    return this.editor.preferences.folds[`tree-${name}`] ?? OPEN.includes(name);
  }

  private openFold(name: string): void {
    if (!this.isOpen(name)) this.editor.actions.setFold(`tree-${name}`, true);
  }

  private fold(
    c: Context,
    name: string,
    title: string,
    sections: readonly Section[],
    content: () => TemplateResult,
  ): TemplateResult {
    const open = this.isOpen(name);
    const count = sections.flatMap(pathsOfSection).filter((path) => Object.hasOwn(this.doc.edits, path)).length;
    const toggled = (event: Event): void => {
      const now = (event.currentTarget as HTMLDetailsElement).open;
      if (now === this.isOpen(name)) return;
      this.editor.actions.setFold(`tree-${name}`, now);
      if (name === 'pruning') this.showEnvelope();
      this.again();
    };
    return html`<details class="fold tree-fold" data-section=${name} ?open=${open} @toggle=${toggled}>
      <summary><span>${title}</span>${count > 0 ? html`<span class="changes">${treeWords.changesIn(count)}</span>` : nothing}</summary>
      ${open ? html`<div class="folded">${content()}${count > 0 ? this.resetSection(c, title, sections) : nothing}</div>` : nothing}
    </details>`;
  }

  private resetSection(c: Context, title: string, sections: readonly Section[]): TemplateResult {
    const paths = sections.flatMap(pathsOfSection);
    const reset = (): void => {
      const values = paths
        .filter((path) => Object.hasOwn(this.doc.edits, path))
        .map((path) => [path, stateOf(c, path).first] as const);
      c.editor.actions.setParameters(Object.fromEntries(values));
    };
    return html`<button type="button" class="quiet reset-section" @click=${reset}>${icon('reset')}<span>${treeWords.resetSection(title)}</span></button>`;
  }

  private groups(c: Context, section: Section): TemplateResult {
    return html`${this.otherSeason(section)}${section.groups.map(
      ({ group, rows }) =>
        html`<div role="group" aria-label=${treeWords.groups[group] || treeWords.sections[section.id]}>${
          treeWords.groups[group] && section.groups.length > 1
            ? html`<p class="rows-title">${treeWords.groups[group]}</p>`
            : nothing
        }${group === 'envelope' ? this.envelope(c) : nothing}${this.rows(c, rows)}</div>`,
    )}`;
  }

  /** What is set for a season is seen in it alone. */
  private otherSeason({ id }: Section): TemplateResult | typeof nothing {
    const season = SEASONS.find((each) => each === id);
    if (season === undefined || season === this.doc.season) return nothing;
    return html`<p class="note">${treeWords.seen(season)}
      <button type="button" class="text" @click=${() => this.editor.actions.setSeason(season)}>${treeWords.showSeason(season)}</button></p>`;
  }

  /** A reason that stands under one row is not written under the next ones, too. */
  private rows(c: Context, rows: readonly Row[]): unknown[] {
    return rows.map((row, i) => parameterRow(row, c, i > 0 && c.why(rows[i - 1]!.path) === c.why(row.path)));
  }

  private envelope(c: Context): unknown {
    const { pruning, tree } = c.species;
    return guard(
      [...Object.values(pruning), tree.baseSize, c.silhouette()],
      () => html`<div class="envelope">${envelopeEditor(c)}</div>`,
    );
  }

  private levels(c: Context, levels: readonly Section[]): TemplateResult {
    const { level } = this.session;
    const section = levels[level]!;
    return html`${choice({
      name: 'level-layout',
      legend: treeWords.layout,
      quiet: true,
      value: this.table ? 'table' : 'one',
      options: [
        { value: 'one', label: treeWords.oneByOne },
        { value: 'table', label: treeWords.sideBySide },
      ],
      onChoose: (layout) => {
        this.table = layout === 'table';
        this.widen();
        this.again();
      },
    })}
    ${
      this.table
        ? levelTable(c)
        : html`<div class="level-tabs" role="tablist" aria-label=${treeWords.levelsLegend} @keydown=${this.onTabKey}>${treeWords.levels.map(
            (
              name,
              i,
            ) => html`<button type="button" role="tab" id="level-tab-${i}" data-level=${i} aria-controls="level-panel"
              aria-selected=${i === level} tabindex=${i === level ? 0 : -1} ?data-empty=${i >= c.species.tree.levels}
              @click=${() => this.editor.actions.setLevel(i)}>${name}</button>`,
          )}</div>
          <div role="tabpanel" id="level-panel" class="level-panel" aria-labelledby="level-tab-${level}">${this.groups(c, section)}</div>`
    }`;
  }

  /** The table takes the width that it needs, and gives it back. */
  private widen(): void {
    const { preferences, actions } = this.editor;
    if (this.session.narrow) return;
    if (this.table) {
      this.widthBefore = preferences.growWidth;
      if ((preferences.growWidth ?? 0) < TABLE_WIDTH) actions.setGrowWidth(TABLE_WIDTH);
    } else {
      actions.setGrowWidth(this.widthBefore);
    }
    (this.closest('wg-app') as HTMLElement & { requestUpdate?(): void })?.requestUpdate?.();
  }

  private onTabKey(event: KeyboardEvent): void {
    const { level } = this.session;
    const next = { ArrowRight: level + 1, ArrowLeft: level - 1, Home: 0, End: 3 }[event.key];
    if (next === undefined) return;
    event.preventDefault();
    event.stopPropagation();
    const to = (next + 4) % 4;
    this.editor.actions.setLevel(to);
    void this.updateComplete.then(() => this.querySelector<HTMLElement>(`#level-tab-${to}`)?.focus());
  }

  /** The envelope stands in the scene while its section is open. */
  private showEnvelope(): void {
    this.editor.actions.showEnvelope(this.isConnected && this.isOpen('pruning'));
  }

  override connectedCallback(): void {
    super.connectedCallback();
    this.stopHolding = listenToEdits(this, this.editor.actions);
    this.showEnvelope();
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    this.stopHolding();
    this.showEnvelope();
  }

  private explainer(): HTMLElement {
    return this.querySelector<HTMLElement>('.parameter-help')!;
  }

  private async explain(path: string, anchor: HTMLElement): Promise<void> {
    this.explained = await explainedBy(path);
    this.again();
    await this.updateComplete;
    placePopover(this.explainer(), anchor, this.session.narrow);
  }

  private onPopover(event: ToggleEvent): void {
    if (event.newState !== 'closed') return;
    this.explained = null;
    this.again();
  }
}

customElements.define('wg-tree', TreePanel);
