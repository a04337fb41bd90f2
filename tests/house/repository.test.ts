import { statSync } from 'node:fs';
import { join } from 'node:path';
import { describe, expect, test } from 'vitest';
import { filesUnder, root, textOf } from './tree-files.ts';

const data = /\.(json|png|svg|glb|hdr|jpg|webp|gif|swc|xml|ico|woff2?)$/;
const all = filesUnder('.');
const texts = all.filter((file) => !/\.(png|glb|hdr|jpg|webp|gif|ico|woff2?)$/.test(file));

describe('files', () => {
  test('none that is written by hand is beyond 20 kB', () => {
    const rooms = ['src', 'shaders', 'e2e', 'tests', 'bench'];
    const large = rooms
      .flatMap(filesUnder)
      .filter((file) => !data.test(file))
      .map((file) => ({ file, bytes: statSync(join(root, file)).size }))
      .filter(({ bytes }) => bytes > 20_000);
    expect(large).toEqual([]);
  });

  test('none names a path of one machine', () => {
    // Written in pieces, so that this file does not find itself.
    const paths = new RegExp(
      ['/wo' + 'rk/', '/ro' + 'ot/', '/ho' + 'me/[a-z]+/', '/Us' + 'ers/[A-Za-z]+/', '[A-Z]:\\\\\\\\?Us' + 'ers']
        .map((path) => `(?<![\\w.])${path}`)
        .join('|'),
    );
    expect(texts.filter((file) => paths.test(textOf(file)))).toEqual([]);
  });

  test('none names the host of a package registry', () => {
    const hosts = new RegExp(['registry\\.[a-z]+\\.[a-z]+', 'regis' + 'try=http', '"resol' + 'ved": *"http'].join('|'));
    expect(texts.filter((file) => hosts.test(textOf(file)))).toEqual([]);
  });
});

describe('lock file', () => {
  interface Package {
    readonly version?: string;
    readonly resolved?: string;
    readonly integrity?: string;
    readonly dependencies?: Record<string, string>;
    readonly optionalDependencies?: Record<string, string>;
  }
  const lock = JSON.parse(textOf('package-lock.json')) as { packages: Record<string, Package> };
  const manifest = JSON.parse(textOf('package.json')) as Record<string, Record<string, string>>;

  test('has no addresses, so that it installs from whichever registry the machine uses', () => {
    const addressed = Object.entries(lock.packages).filter(([, { resolved }]) => resolved !== undefined);
    expect(addressed.map(([name]) => name)).toEqual([]);
  });

  test('has the checksum of every package', () => {
    const unchecked = Object.entries(lock.packages).filter(([name, { integrity }]) => name !== '' && !integrity);
    expect(unchecked.map(([name]) => name)).toEqual([]);
  });

  /** Folders in which Node looks for what a package asks for: its own, then outwards to the top. */
  const around = (place: string): string[] => {
    const parts = place.split(/\/(?=node_modules\/)/).filter(Boolean);
    return [...parts.map((_, i) => `${parts.slice(0, parts.length - i).join('/')}/`), ''];
  };

  // A lock file written where a registry lacks the builds for other machines leaves them out, and then `npm ci` refuses it.
  test('has every package that a package in it asks for, also those for other machines', () => {
    const missing = Object.entries(lock.packages).flatMap(([place, { dependencies, optionalDependencies }]) =>
      Object.keys({ ...dependencies, ...optionalDependencies })
        .filter((name) => !around(place).some((folder) => lock.packages[`${folder}node_modules/${name}`]))
        .map((name) => `${place}: ${name}`),
    );
    expect(missing).toEqual([]);
  });

  test('agrees with the manifest, whose versions are exact', () => {
    for (const group of ['dependencies', 'devDependencies', 'peerDependencies', 'optionalDependencies']) {
      for (const [name, asked] of Object.entries(manifest[group] ?? {})) {
        if (group === 'peerDependencies') continue;
        // Another package's version under a name of our own: npm:three@0.180.0.
        const version = asked.replace(/^npm:.*@/, '');
        expect(version, name).toMatch(/^\d+\.\d+\.\d+/);
        expect(lock.packages[`node_modules/${name}`]?.version, name).toBe(version);
      }
    }
  });
});

describe('the gate', () => {
  test('is a script that may be run and asks nothing', () => {
    expect(statSync(join(root, '.ci/run')).mode & 0o111).not.toBe(0);
    expect(textOf('.ci/run')).toContain('exec </dev/null');
  });

  test.each(['start', 'build', 'preview', 'test', 'test:unit', 'test:e2e', 'bench', 'lint', 'typecheck'])(
    'the manifest has the script %s',
    (name) => {
      const { scripts } = JSON.parse(textOf('package.json')) as { scripts: Record<string, string> };
      expect(scripts[name]).toBeTruthy();
    },
  );
});
