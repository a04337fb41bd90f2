import { spawnSync } from 'node:child_process';
import { existsSync, readdirSync, readFileSync, writeFileSync } from 'node:fs';
import { dirname, join, resolve, sep } from 'node:path';
import type { Plugin } from 'vite';
import { PARAMETER_PICTURES, type ParameterPicture, placeOf } from '../docs/parameter-pictures.ts';
import { editText } from '../src/core/link/encode-edits.ts';
import { type ParameterValue, PLACES } from '../src/core/species/edits.ts';
import { elementPage, type Manifest } from '../src/reference/element-page.ts';
import type { PictureOf, PicturePair } from '../src/reference/parameter-entry.ts';
import { parametersPage } from '../src/reference/parameters-page.ts';
import { plainMarkdown } from '../src/reference/plain-markdown.ts';
import { windPage } from '../src/reference/wind-page.ts';
import { navigation } from './site.ts';

const root = dirname(import.meta.dirname);

/** Where the pages of the library stand. */
const API = 'reference/api';

/** Pictures of docs/ that the pages show. */
const PICTURES = ['glb-clip.webp', 'glb-near.webp'] as const;
const text = (path: string): string => readFileSync(join(root, path), 'utf8');

/** Where a page asks for what is made from a table or a page of docs: `<wg-reference of="parameters"></wg-reference>`. */
const PLACE = /<wg-reference of="([\w./-]+)"><\/wg-reference>/g;

const valueText = (value: ParameterValue): string => (Array.isArray(value) ? value.join(', ') : String(value));

/** A picture's value as people write it, with its unit, and the link that grows its tree. */
function pictureOf(picture: ParameterPicture, value: ParameterValue): PictureOf {
  const place = placeOf(picture);
  const { parameter } = PLACES.get(place)!;
  const edits = { ...picture.edits, [place]: value };
  const named = parameter.kind === 'number' && typeof value === 'number' ? parameter.names?.[value] : undefined;
  const unit = 'unit' in parameter && parameter.unit ? ` ${parameter.unit}` : '';
  const pairs = Object.entries(edits).map(([path, each]) => `${path}=${encodeURIComponent(editText(path, each))}`);
  return {
    value: named ?? `${valueText(value)}${unit}`.replace(' deg', '°'),
    link: [`s=${picture.species}`, `seed=${picture.seed}`, ...pairs].join('&'),
  };
}

/** Two trees for each parameter that has pictures, by path without the level; the seasons share those of autumn. */
function picturePairs(): ReadonlyMap<string, PicturePair> {
  const pairs = new Map<string, PicturePair>();
  for (const picture of PARAMETER_PICTURES) {
    const { path, low, high } = picture;
    if (!existsSync(join(root, `public/help/${path}-low.webp`))) continue;
    pairs.set(path, { name: path, low: pictureOf(picture, low), high: pictureOf(picture, high) });
  }
  return pairs;
}

/** Pages of docs/ that have a place on the site, and that place. Other files of the repository are named, not linked. */
const ON_SITE: Readonly<Record<string, string>> = {
  'parameters.md': 'parameters.html',
  'wind-parameters.md': 'wind.html',
  'embedding.md': 'embedding.html',
};

/** A page of docs/ without its heading, which the page has, notes for its makers, and links to files that are not on the site. */
function docsPage(name: string): string {
  const markdown = text(`docs/${name}`)
    .replace(/^# .*\n/, '')
    // What is said to those who work on the repository.
    .replace(/^`npx tsx [\s\S]*?\n\n/gm, '')
    .replace(/!\[([^\]]*)\]\(([^)]*)\)/g, (_, alt: string, to: string) =>
      PICTURES.some((name) => name === to) ? `![${alt}](../docs/${to})` : '',
    )
    .replace(/(?<!!)\[([^\]]+)\]\(([^)\s#]+)(#[^)\s]*)?\)/g, (whole, label: string, to: string, anchor = '') => {
      if (/^(?:https?:|#)/.test(to) || to.endsWith('.html')) return whole;
      const place = ON_SITE[to];
      return place ? `[${label}](${place}${anchor})` : label;
    });
  return plainMarkdown(markdown);
}

function content(of: string): string {
  if (of === 'parameters') return parametersPage(picturePairs());
  if (of === 'wind') return windPage();
  if (of === 'element') {
    const file = 'custom-elements.json';
    return elementPage(existsSync(join(root, file)) ? (JSON.parse(text(file)) as Manifest) : { modules: [] });
  }
  return docsPage(of);
}

/** Writes into the reference pages what they are about, from the tables that the programs themselves read; there is no generated page in the repository. */
export function reference(): Plugin {
  return {
    name: 'windgrove:reference',
    transformIndexHtml: {
      // After the bundler: the pictures stand in public/ and keep their names.
      order: 'post',
      handler: (html) => html.replace(PLACE, (_, of: string) => content(of)),
    },
  };
}

/** What the pages of the library wear: colours, letters and the row of links of the site. */
const API_SHEET = 'reference/api.css';

/** Gives a page that TypeDoc made the site's row of links and its look; `page` is its address seen from the top of the site. */
function dress(html: string, page: string): string {
  const depth = page.split('/').length - 1;
  const sheet = `<link rel="stylesheet" href="${'../'.repeat(depth)}${API_SHEET}">`;
  return html
    .replace('</head>', `${sheet}</head>`)
    .replace(/<body[^>]*>/, (body) => body + navigation('reference', depth));
}

/** What stands beside the reference pages: pictures of docs/, and the pages of the library's functions and types, by TypeDoc. */
export function referenceFiles(): Plugin {
  let out = '';
  return {
    name: 'windgrove:reference-files',
    apply: 'build',
    configResolved({ build }) {
      out = resolve(root, build.outDir);
    },
    generateBundle() {
      for (const name of PICTURES)
        this.emitFile({ type: 'asset', fileName: `docs/${name}`, source: readFileSync(join(root, 'docs', name)) });
      const look = ['src/site/tokens.css', 'src/site/navigation.css', 'src/reference/api.css'].map(text).join('\n');
      this.emitFile({ type: 'asset', fileName: API_SHEET, source: look });
    },
    closeBundle() {
      const { scripts } = JSON.parse(text('package.json')) as { scripts: Record<string, string> };
      if (!scripts['docs:api']) return;
      const { status, stderr } = spawnSync('npm', ['run', 'docs:api', '--', '--out', join(out, API)], {
        cwd: root,
        encoding: 'utf8',
        shell: process.platform === 'win32',
      });
      if (status !== 0) throw new Error(`docs:api failed\n${stderr}`);
      for (const entry of readdirSync(join(out, API), { recursive: true, encoding: 'utf8' })) {
        if (!entry.endsWith('.html')) continue;
        const page = `${API}/${entry.replaceAll(sep, '/')}`;
        writeFileSync(join(out, page), dress(readFileSync(join(out, page), 'utf8'), page));
      }
    },
  };
}
