import { readdirSync, readFileSync } from 'node:fs';
import { join, sep } from 'node:path';
import { gzipSync } from 'node:zlib';
import type { BuiltSite } from '../../src/site/kept-files.ts';

/** A site that was built into a folder; pages that only browser tests look at, built beside it, are not of it. */
export function siteIn(folder: string): BuiltSite {
  const files = readdirSync(folder, { recursive: true, withFileTypes: true })
    .filter((entry) => entry.isFile())
    .map((entry) =>
      join(entry.parentPath, entry.name)
        .slice(folder.length + 1)
        .replaceAll(sep, '/'),
    )
    .filter((path) => !path.startsWith('e2e/'));
  return { files, text: (path) => readFileSync(join(folder, path), 'utf8') };
}

/** What a page has before anything is seen of it: bytes as they travel, and scripts that hold it up. */
export function beforeFirstPaint(
  site: BuiltSite,
  page: string,
): { readonly bytes: number; readonly blocking: string[] } {
  const html = site.text(page);
  const sheets = [...html.matchAll(/<link\b[^>]*\brel="stylesheet"[^>]*\bhref="([^"]+)"/g)].map(([, href]) =>
    join(page, '..', href!).replaceAll(sep, '/'),
  );
  const packed = [html, ...sheets.map((sheet) => site.text(sheet))].map((text) => gzipSync(text, { level: 9 }).length);
  const blocking = [...html.matchAll(/<script\b([^>]*)>/g)]
    .map(([, attributes]) => attributes!)
    .filter((attributes) => /\bsrc=/.test(attributes) && !/type="module"|\bdefer\b|\basync\b/.test(attributes));
  return { bytes: packed.reduce((sum, one) => sum + one, 0), blocking };
}
