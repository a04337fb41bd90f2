import { statSync } from 'node:fs';
import { resolve } from 'node:path';
import { describe, expect, test } from 'vitest';
import { lessonHtml } from '../../build/learn.ts';
import { lessonPage } from '../../build/lesson-page.ts';
import { LESSONS } from '../../src/learn/lessons.ts';
import { filesUnder, textOf } from '../house/tree-files.ts';

const figuresOf = (html: string): string[] => [...html.matchAll(/data-figure="([\w-]+)"/g)].map(([, id]) => id!);

/** Ids of the figures that the files of a lesson write: a title stands behind each of them. */
const specsOf = (slug: string): string[] =>
  filesUnder(`src/learn/${slug}`)
    .filter((file) => file.endsWith('.ts'))
    .flatMap((file) => [...textOf(file).matchAll(/\b(?:id|kind): '([\w-]+)',\s+title:/g)].map(([, id]) => id!));

describe.each(LESSONS)('lesson $slug', ({ slug, title }) => {
  const html = textOf(`learn/${slug}.html`);

  test('has a figure for every place and a place for every figure', () => {
    expect(figuresOf(html).length).toBeGreaterThan(0);
    expect(figuresOf(html).toSorted()).toEqual(specsOf(slug).toSorted());
  });

  test('is complete: a lead, captions, exercises with answers, a measured table, where it comes from', () => {
    expect(html).toContain('class="lead"');
    expect(html.match(/<figcaption>\s*\S/g)).toHaveLength(figuresOf(html).length);
    expect(html.match(/<summary>/g)?.length).toBeGreaterThanOrEqual(3);
    expect(html).toMatch(/class="measured"/);
  });

  test('shows a small picture of each figure where no script draws it', () => {
    const built = lessonPage(html, `/learn/${slug}.html`);
    const pictures = [
      ...built.matchAll(/<figure class="live"[^>]*><img class="still[^>]* src="..\/([^"]+)"[^>]* alt="[^"]+/g),
    ];
    expect(pictures).toHaveLength(figuresOf(html).length);
    const sizes = pictures.map(([, file]) => statSync(resolve(import.meta.dirname, '../../public', file!)).size);
    expect(Math.max(...sizes)).toBeLessThan(12_000);
  });

  test('builds: its formulas are right and the code that it cites is there', async () => {
    const path = `/learn/${slug}.html`;
    const built = await lessonHtml(lessonPage(html, path), path);
    expect(built).toContain(`<h1>${title}</h1>`);
    expect(built).not.toMatch(/<(tex|equation|source-lines)\b/);
    const ids = [...built.matchAll(/ id="([^"]+)"/g)].map(([, id]) => id!);
    expect(ids.filter((id, i) => ids.indexOf(id) !== i)).toEqual([]);
  });
});
