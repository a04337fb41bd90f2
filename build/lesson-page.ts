import { existsSync, readFileSync } from 'node:fs';
import { basename, resolve } from 'node:path';
import { INDEX_PAGE, LESSONS, type Lesson, neighbours } from '../src/learn/lessons.ts';

/** A picture of a figure, for where no script draws it; `docs/make-figures.ts` takes them. */
interface Still {
  readonly width: number;
  readonly height: number;
  readonly alt: string;
  /** Lines on the colour of the stage, to be turned light on dark in the dark theme. */
  readonly drawn: boolean;
}

const stills = (): Record<string, Still> =>
  JSON.parse(readFileSync(resolve(import.meta.dirname, '../src/learn/stills.json'), 'utf8')) as Record<string, Still>;

/** Puts the picture of each figure into its place. */
function withStills(main: string, slug: string): string {
  const known = stills();
  return main.replace(/<figure class="live"[^>]* data-figure="([\w-]+)"[^>]*>/g, (figure, id: string) => {
    const still = known[`${slug}/${id}`];
    if (!still) return figure;
    const { width, height, alt, drawn } = still;
    return `${figure}<img class="still${drawn ? ' drawn' : ''}" vite-ignore src="../figures/${slug}/${id}.webp" width="${width}" height="${height}" alt="${escaped(alt)}" loading="lazy">`;
  });
}

const escaped = (text: string): string =>
  text.replaceAll('&', '&amp;').replaceAll('<', '&lt;').replaceAll('"', '&quot;');

/** What a page of `learn/` has around its text: the same for all, but for this. */
interface Around {
  readonly title: string;
  readonly description: string;
  readonly styles: readonly string[];
  readonly script: string;
}

function page(main: string, { title, description, styles, script }: Around): string {
  const links = styles.map((href) => `<link rel="stylesheet" href="${href}">`).join('\n    ');
  return `<!doctype html>
<html lang="en">
  <head>
    <meta charset="utf-8">
    <meta name="viewport" content="width=device-width, initial-scale=1, viewport-fit=cover">
    <meta name="color-scheme" content="light dark">
    <meta name="description" content="${escaped(description)}">
    <title>${escaped(title)}</title>
    <link rel="icon" href="../icon.svg" type="image/svg+xml">
    ${links}
  </head>
  <body>
    <wg-nav current="learn"></wg-nav>
    ${main.trim()}
    <script type="module" src="${script}"></script>
  </body>
</html>
`;
}

function lessonNav(slug: string): string {
  const { before, after } = neighbours(slug);
  const link = (lesson: Lesson | undefined, name: string, text: string): string =>
    lesson ? `<a class="${name}" href="./${lesson.slug}.html">${text} ${lesson.number} · ${lesson.title}</a>` : '';
  return `<nav class="lesson-nav" aria-label="Lessons">${link(before, 'before', 'Before:')}<a class="all" href="./index.html">All lessons</a>${link(after, 'after', 'Next:')}</nav>`;
}

/**
 * A page of `learn/` as a browser takes it. Its file is no more than `<main class="lesson">`: what stands around the text, the heading and the
 * way to the next lesson come from the table of lessons. Throws where that has no such lesson, or the file is no `<main>`.
 */
export function lessonPage(main: string, path: string): string {
  if (!/^\s*<main class="lesson">[\s\S]*<\/main>\s*$/.test(main))
    throw new Error('it is more, or less, than <main class="lesson">.');
  const slug = basename(path, '.html');
  if (slug === 'index')
    return page(main, {
      ...INDEX_PAGE,
      styles: ['/src/learn/lesson.css', '/src/learn/index.css'],
      script: '/src/learn/index-page.ts',
    });
  const { lesson } = neighbours(slug);
  const own = `/src/learn/${slug}/page.css`;
  const hasOwn = existsSync(resolve(import.meta.dirname, `..${own}`));
  const kicker = `<p class="kicker">Lesson ${lesson.number} · ${escaped(lesson.papers)}</p>`;
  return page(
    withStills(main, slug)
      .replace('<main class="lesson">', (start) => `${start}\n      ${kicker}<h1>${escaped(lesson.title)}</h1>`)
      .replace(/\s*<\/main>\s*$/, () => `\n      ${lessonNav(slug)}\n    </main>`),
    {
      title: `${lesson.title} · Windgrove lessons`,
      description: lesson.description,
      styles: ['/src/learn/lesson.css', ...(hasOwn ? [own] : [])],
      script: `/src/learn/${slug}/main.ts`,
    },
  );
}

/** All lessons, in the order in which they are read. */
export const lessonCards = (): string =>
  `<ol class="cards">${LESSONS.map(
    ({ slug, number, title, about, papers }) =>
      `<li><a href="./${slug}.html"><span class="number">${number}</span><span class="what"><strong>${title}</strong><span>${about}</span><small>${escaped(papers)}</small></span></a></li>`,
  ).join('')}</ol>`;
