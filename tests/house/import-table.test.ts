import { describe, expect, test } from 'vitest';
import { exists, type Import, importsOf } from './imports.ts';
import { filesUnder } from './tree-files.ts';

/** Who may import whom: the folders of src, the shaders, and the packages that a room knows. */
const table: Record<string, { rooms: string[]; packages: string[] }> = {
  core: {
    rooms: ['core'],
    packages: [
      'zod',
      'papaparse',
      'fft.js',
      'fflate',
      'fast-png',
      '@gltf-transform/core',
      '@gltf-transform/extensions',
      '@rgrove/parse-xml',
    ],
  },
  worker: { rooms: ['worker', 'core'], packages: [] },
  gpu: { rooms: ['gpu', 'core', 'shaders'], packages: ['three'] },
  view: { rooms: ['view', 'core', 'worker', 'gpu', 'shaders'], packages: ['three', 'mediabunny'] },
  element: { rooms: ['element', 'core', 'view', 'worker'], packages: ['@lit/reactive-element'] },
  lib: { rooms: ['lib', 'core', 'view', 'worker', 'element'], packages: [] },
  site: { rooms: ['site'], packages: ['workbox-precaching', 'workbox-routing', 'workbox-strategies'] },
  reference: { rooms: ['reference', 'core'], packages: [] },
  viewer: { rooms: ['viewer', 'core', 'view', 'element'], packages: [] },
  editor: {
    rooms: ['editor', 'core', 'view', 'element', 'site'],
    packages: ['lit', 'zustand', 'zundo', 'uplot', 'idb-keyval', 'driver.js', 'fflate', 'mediabunny'],
  },
  learn: { rooms: ['learn', 'core', 'view', 'worker', 'gpu', 'element', 'site'], packages: ['lit', 'three', 'uplot'] },
  forest: { rooms: ['forest', 'core', 'view', 'site'], packages: ['lit'] },
  range: { rooms: ['range', 'core', 'view'], packages: ['lit', 'three'] },
  bench: { rooms: ['bench', 'core', 'view', 'gpu', 'worker'], packages: ['three', '@dgreenheck/ez-tree'] },
  cli: { rooms: ['cli', 'core'], packages: ['node:'] },
};

/** The room of a file of the repository: a folder of src, or the folder at the top. */
const roomOf = (path: string): string => path.replace(/^src\//, '').split('/')[0]!;

/** Why an import is against the table, or undefined where it is allowed. */
function fault({ file, specifier, target, package: name }: Import): string | undefined {
  const room = roomOf(file);
  const allowed = table[room];
  if (!allowed) return `${file}: the table has no room '${room}'`;
  if (name !== undefined) {
    const known = allowed.packages.some((each) => name === each || (each === 'node:' && name.startsWith('node:')));
    return known ? undefined : `${file}: ${room} may not import the package '${specifier}'`;
  }
  if (!allowed.rooms.includes(roomOf(target!))) return `${file}: ${room} may not import '${specifier}'`;
  return exists(target!) ? undefined : `${file}: '${specifier}' is not there`;
}

const sources = filesUnder('src').filter((file) => /\.m?ts$/.test(file));

describe('import table of the design', () => {
  test('reads a tree that has something in it', () => {
    expect(sources.length).toBeGreaterThan(5);
  });

  test('every import of src is one that its room may make', () => {
    expect(sources.flatMap(importsOf).map(fault).filter(Boolean)).toEqual([]);
  });

  test.each([
    ['src/core/math/vec3.ts', 'three', /may not import the package/],
    ['src/core/math/vec3.ts', 'node:fs', /may not import the package/],
    ['src/core/math/vec3.ts', '../../gpu/passes.ts', /may not import/],
    ['src/worker/worker.ts', '../../shaders/lib/trig.glsl', /may not import/],
    ['src/view/stage.ts', '../editor/main.ts', /may not import/],
    ['src/core/math/vec3.ts', './no-such-file.ts', /is not there/],
  ])('%s may not import %s', (file, specifier, message) => {
    const name = specifier.startsWith('.') ? undefined : specifier;
    const target = name ? undefined : new URL(specifier, `file:///${file}`).pathname.slice(1);
    expect(fault({ file, specifier, target, package: name })).toMatch(message);
  });
});
