import { readFileSync } from 'node:fs';
import type { ServerResponse } from 'node:http';
import { createRequire } from 'node:module';
import { resolve } from 'node:path';
import type { Plugin } from 'vite';
import { codeHtml, linesOf, sourceText } from './learn-source.ts';
import { lessonCards, lessonPage } from './lesson-page.ts';
import { navigation } from './site.ts';

/** A page of a whole file stands here, below the top of the site. */
const SOURCE = /^source\/(.+)\.html$/;

const attributesOf = (text: string): Record<string, string> =>
  Object.fromEntries([...text.matchAll(/([\w-]+)="([^"]*)"/g)].map(([, name, value]) => [name, value]));

/** Replaces each match by what a promise brings. */
async function replaced(
  text: string,
  pattern: RegExp,
  by: (match: RegExpMatchArray) => Promise<string> | string,
): Promise<string> {
  const parts = await Promise.all([...text.matchAll(pattern)].map(by));
  return text.replace(pattern, () => parts.shift() ?? '');
}

/** Writes a lesson's formulas and citations of source, or the cards of all lessons, into its page; `cite` hears of every file that is cited. */
export async function lessonHtml(html: string, path: string, cite: (file: string) => void = () => {}): Promise<string> {
  const up = '../'.repeat(path.replace(/^\//, '').split('/').length - 1) || './';
  let out = html;
  if (/<(tex|equation)\b/.test(out)) {
    const { formulaHtml } = await import('./learn-equation.ts');
    out = await replaced(out, /<tex>([\s\S]*?)<\/tex>/g, ([, latex]) => formulaHtml(latex!, false));
    out = await replaced(out, /<equation\b([^>]*)>([\s\S]*?)<\/equation>/g, ([, text, latex]) => {
      const { id, cite: from } = attributesOf(text!);
      const name = from ? `Equation, ${from}` : 'Equation';
      // What may have to be scrolled must be reached with the keyboard.
      return `<div class="equation"${id ? ` id="${id}"` : ''}><div class="formula" role="group" aria-label="${name}" tabindex="0">${formulaHtml(latex!, true)}</div>${from ? `<span class="cite">${from}</span>` : ''}</div>`;
    });
  }
  out = await replaced(out, /<source-lines\b([^>]*)>\s*<\/source-lines>/g, async ([, text]) => {
    const { file = '', name = '' } = attributesOf(text!);
    const source = sourceText(file);
    const lines = await linesOf(file, source, name);
    cite(file);
    const where = `${up}source/${file}.html#L${lines.from}`;
    return `<div class="source-lines"><p><span><code>${name}</code></span><a href="${where}">${file}, lines ${lines.from} to ${lines.to}</a></p><pre class="source" tabindex="0" role="group" aria-label="Source of ${name}">${codeHtml(source, lines)}</pre></div>`;
  });
  return out.replace(/<lesson-cards>\s*<\/lesson-cards>/, lessonCards);
}

/** The page of a whole file of source, each line with an anchor. Throws where there is no such file. */
export function sourcePage(file: string): string {
  const text = sourceText(file).trimEnd();
  const depth = file.split('/').length;
  const up = '../'.repeat(depth);
  return `<!doctype html>
<html lang="en"><head><meta charset="utf-8"><meta name="viewport" content="width=device-width, initial-scale=1"><meta name="color-scheme" content="light dark"><title>${file} · Windgrove</title><link rel="icon" href="${up}icon.svg" type="image/svg+xml"><link rel="stylesheet" href="${up}source/source.css"></head>
<body>${navigation('learn', depth)}<main><h1>${file}</h1><pre class="source" tabindex="0" role="group" aria-label="Source">${codeHtml(text, { from: 1, to: text.split('\n').length }, true)}</pre></main></body></html>
`;
}

/** What pages of source are dressed in: plain files, so that they need no build. */
function sourceStyle(): string {
  const text = (file: string): string => readFileSync(resolve(import.meta.dirname, '../src', file), 'utf8');
  const own =
    ':root { --mono: ui-monospace, Menlo, Consolas, monospace; }\nh1 { font: 600 18px var(--mono); overflow-wrap: anywhere; }\n';
  return [
    text('site/tokens.css'),
    text('site/page.css').replace(/@import[^;]*;/g, ''),
    text('learn/source.css'),
    own,
  ].join('\n');
}

/** The style of KaTeX with the one kind of font file that every browser of ours reads: the others would be a megabyte of the site. */
function formulaStyle(): string {
  const file = createRequire(import.meta.url).resolve('katex/dist/katex.min.css');
  return readFileSync(file, 'utf8')
    .replaceAll(/,url\([^)]*\) format\("(?:woff|truetype)"\)/g, '')
    .replaceAll('url(fonts/', 'url(katex/dist/fonts/');
}

/** Serves the page of a file while developing. */
function answer(response: ServerResponse, file: string): void {
  try {
    response.setHeader('Content-Type', 'text/html').end(sourcePage(file));
  } catch (error) {
    response.statusCode = 404;
    response.end(String(error));
  }
}

/** Lessons: what stands around their text, formulas, cited source and the way from one to the next are written when the site is built. */
export function learn(): Plugin {
  const cited = new Set<string>();
  return {
    name: 'windgrove:learn',
    enforce: 'pre',
    transform: {
      filter: { id: /\/learn\/lesson\.css(\?|$)/ },
      handler: (code) => ({ code: code.replace('@import "katex/dist/katex.min.css";', formulaStyle), map: null }),
    },
    transformIndexHtml: {
      order: 'pre',
      async handler(html, { path }) {
        if (!/^\/?learn\//.test(path)) return html;
        try {
          return await lessonHtml(lessonPage(html, path), path, (file) => cited.add(file));
        } catch (error) {
          throw new Error(`${path}: ${error instanceof Error ? error.message : String(error)}`);
        }
      },
    },
    configureServer(server) {
      server.middlewares.use((request, response, next) => {
        const path = (request.url ?? '').replace(/[?#].*$/, '').replace(/^\//, '');
        const file = SOURCE.exec(path)?.[1];
        if (path === 'source/source.css') response.setHeader('Content-Type', 'text/css').end(sourceStyle());
        else if (file) answer(response, file);
        else next();
      });
    },
    generateBundle() {
      if (cited.size === 0) return;
      this.emitFile({ type: 'asset', fileName: 'source/source.css', source: sourceStyle() });
      for (const file of cited)
        this.emitFile({ type: 'asset', fileName: `source/${file}.html`, source: sourcePage(file) });
    },
  };
}
