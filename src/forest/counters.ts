import { html, type TemplateResult } from 'lit';
import type { ForestStats } from '../view/forest/forest.ts';
import { words } from './words.ts';

/** What the last frame drew. */
export function counters(stats: ForestStats): TemplateResult {
  const { counters: names, many } = words;
  const step = `${stats.step} (${stats.steps.indexOf(stats.step) + 1}/${stats.steps.length})`;
  const rows: readonly (readonly [string, string, string])[] = [
    ['trees', names.trees, many(stats.trees)],
    ['frame', names.frame, words.frame(stats.frame)],
    ['near', names.near, many(stats.near)],
    ['triangles', names.triangles, many(stats.triangles)],
    ['middle', names.middle, many(stats.middle)],
    ['draws', names.draws, many(stats.drawCalls)],
    ['far', names.far, many(stats.far)],
    ['bytes', names.bytes, words.megabytes(stats.bytes)],
    ['growing', names.growing, many(stats.growing)],
    ['step', names.step, step],
  ];
  return html`<dl class="counters">
    ${rows.map(([key, name, value]) => html`<div><dt>${name}</dt><dd data-counter=${key}>${value}</dd></div>`)}
  </dl>`;
}
