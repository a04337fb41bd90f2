import { html, nothing, type TemplateResult } from 'lit';
import { PLACES } from '../../../core/species/edits.ts';
import { treeWords } from '../../words/tree.ts';
import { icon } from '../icons.ts';
import { type Context, labelOf, spokenName, stateOf } from './context.ts';
import { loadPictures, type PictureValues, pictureName } from './help-pictures.ts';
import { allowedText, sourceText } from './popover-text.ts';
import { pathsOfRow, type Row, rowOf } from './sections.ts';
import { valueText } from './value-text.ts';

const words = treeWords.help;

/** Pixels between the popover and what it explains, and between it and the window's edge. */
const GAP = 8;

/** What is explained now. */
export interface Explained {
  readonly path: string;
  readonly pictures: PictureValues | null;
}

/** Looks up the pictures of a parameter. */
export async function explainedBy(path: string): Promise<Explained> {
  const pictures = await loadPictures();
  return { path, pictures: pictures[pictureName(path)] ?? null };
}

/** Shows the popover beside `anchor`: right of the panel, or on a narrow window over it. */
export function placePopover(popover: HTMLElement, anchor: HTMLElement, narrow: boolean): void {
  popover.showPopover();
  const { height, width } = popover.getBoundingClientRect();
  const rect = anchor.getBoundingClientRect();
  const panel = anchor.closest('.side, .sheet')?.getBoundingClientRect() ?? rect;
  const room = window.innerWidth - panel.right - 2 * GAP;
  const beside = !narrow && room >= width;
  const top = beside ? rect.top : rect.bottom + GAP;
  const above = rect.top - GAP - height;
  const fits = top + height + GAP <= window.innerHeight;
  popover.style.left = `${beside ? panel.right + GAP : Math.max(GAP, Math.min(rect.left, window.innerWidth - width - GAP))}px`;
  popover.style.top = `${fits ? top : beside ? Math.max(GAP, window.innerHeight - height - GAP) : Math.max(GAP, above)}px`;
  popover.querySelector<HTMLElement>('.popover-head button')?.focus({ focusVisible: false } as FocusOptions);
}

/** What explains a parameter, its variation with it. */
export function popoverContent(c: Context, { path, pictures }: Explained, close: () => void): TemplateResult {
  const row = rowOf(path);
  const { level } = PLACES.get(row.path)!;
  const states = pathsOfRow(row).map((each) => stateOf(c, each));
  const first = pathsOfRow(row)
    .map((each, i) => valueText(each, states[i]!.first))
    .join(' ± ');
  const changed = states.some((s) => s.changed);
  const locked = states.some((s) => s.locked);
  return html`<div class="popover-head"><h2>${level === undefined ? nothing : html`<span class="chip" data-level=${level}></span>`}${spokenName(
    row.path,
  )}</h2><button type="button" class="round" aria-label=${words.close} @click=${close}>${icon('close')}</button></div>
    ${meaning(row.path)}
    ${row.variation ? html`<h3>${words.variation}</h3>${meaning(row.variation)}` : nothing}
    ${shown(path, pictures)}
    <p class="soft">${words.species(first)}</p>
    <div class="popover-buttons">${
      changed
        ? html`<button type="button" class="quiet" @click=${() => reset(c, row)}>${icon('reset')}<span>${treeWords.resetTo(first)}</span></button>`
        : nothing
    }<button type="button" class="quiet" aria-pressed=${locked} title=${treeWords.lockHint} @click=${() => lock(c, row, locked)}>${icon(
      locked ? 'lock' : 'unlock',
    )}<span>${locked ? treeWords.unlock : treeWords.lock}</span></button></div>
    <p class="soft">${treeWords.lockHint}.</p>`;
}

function meaning(path: string): TemplateResult {
  const { parameter } = PLACES.get(path)!;
  const negative = parameter.kind === 'number' ? parameter.negative : undefined;
  return html`<p>${parameter.help} ${negative ?? nothing}</p>
    <p class="soft">${sourceText(path)}<br>${allowedText(path)}</p>`;
}

/** The same tree with little and with much of it; nothing where there is no picture. */
function shown(path: string, pictures: PictureValues | null): TemplateResult | typeof nothing {
  if (!pictures) return nothing;
  const name = pictureName(path);
  const label = labelOf(path);
  const gone = (event: Event): void => (event.target as HTMLElement).closest('figure')?.remove();
  return html`<div class="low-high">${(['low', 'high'] as const).map((which) => {
    const value = valueText(path, pictures[which]);
    return html`<figure><img src="help/${name}-${which}.webp" alt=${words.picture(label, value)} width="140" height="140" @error=${gone}>
      <figcaption>${value}</figcaption></figure>`;
  })}</div>`;
}

function reset(c: Context, row: Row): void {
  for (const each of pathsOfRow(row)) c.editor.actions.resetParameter(each);
}

/** A value and its variation are locked together. */
function lock(c: Context, row: Row, locked: boolean): void {
  for (const each of pathsOfRow(row)) if (c.locks.has(each) === locked) c.editor.actions.toggleLock(each);
}
