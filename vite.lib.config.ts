import { cpSync, readdirSync } from 'node:fs';
import { join } from 'node:path';
import { defineConfig, type Plugin } from 'vite';
import { shaders } from './build/glsl.ts';
import { shippedParsed } from './build/lib-shipped.ts';
import { declarations } from './build/lib-types.ts';
import { workersBeside, workersInside } from './build/lib-workers.ts';

const root = import.meta.dirname;
const out = process.env.WINDGROVE_LIB_BUILD ?? join(root, 'dist-lib');
const entry = (name: string): string => join(root, 'src/lib', `${name}.ts`);

/** What a module that keeps its place is called: as its source, without `src/` or `public/`. */
const placeOf = (name: string): string => `${name.replace(/^src\/|^public\//, '').replace(/\.json$/, '')}.js`;

/** The files of species and winds themselves, for who would rather fetch them. */
const data: Plugin = {
  name: 'windgrove:data',
  closeBundle() {
    for (const folder of ['species', 'winds']) {
      for (const file of readdirSync(join(root, 'public', folder)).filter((name) => /\.(json|csv)$/.test(name)))
        cpSync(join(root, 'public', folder, file), join(out, folder, file));
    }
  },
};

/** Packages stay imports, which the manifest of the package answers for; what the compiler adds itself goes in. */
const isPackage = (id: string): boolean =>
  /^[\w@]/.test(id) && !/^[A-Za-z]:/.test(id) && !id.startsWith('@oxc-project/runtime');

/**
 * The npm package. `vite build --config vite.lib.config.ts`: its modules, one for each of ours, so that what is not used is not taken;
 * with `--mode script`, afterwards: one file that needs no other.
 */
export default defineConfig(({ mode }) => {
  const whole = mode === 'script';
  return {
    root,
    publicDir: false,
    define: { 'process.env.NODE_ENV': '"production"' },
    json: { namedExports: false },
    plugins: [shaders(), shippedParsed(), ...(whole ? [workersInside()] : [workersBeside(), declarations(), data])],
    build: {
      target: 'es2023',
      outDir: out,
      emptyOutDir: !whole,
      // Whoever bundles the modules minifies them; until then they can be read.
      minify: whole,
      lib: whole
        ? { entry: entry('script'), formats: ['iife'], name: 'windgrove', fileName: () => 'windgrove.js' }
        : { entry: ['index', 'core', 'element'].map(entry), formats: ['es'] },
      rollupOptions: whole
        ? { output: { codeSplitting: false } }
        : {
            external: isPackage,
            output: {
              preserveModules: true,
              preserveModulesRoot: root,
              entryFileNames: ({ name }) => placeOf(name),
            },
          },
    },
  };
});
