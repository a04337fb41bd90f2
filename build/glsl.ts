import type { Plugin } from 'vite';
import { minifiedGlsl } from './glsl-minify.ts';

/** A line that asks for another shader, by its path from the top of the repository's shaders/; three's own have angle brackets. */
const INCLUDE = /^[ \t]*#include[ \t]+(\/[\w/.-]+\.(?:glsl|vert|frag))[ \t]*;?[ \t]*$/;

const withoutComments = (text: string): string => text.replace(/\/\*[\s\S]*?\*\/|\/\/.*$/gm, '');

/**
 * Shaders as modules: each exports its text, and what it includes is a module that it imports.
 *
 * Thirty shaders share the functions of a few: a plugin that expands includes wrote them into each, which was a third of what travels
 * before the first tree. Every file guards itself, so that a text that comes twice is no mistake.
 */
export function shaders(): Plugin {
  let small = false;
  return {
    name: 'windgrove:shaders',
    enforce: 'pre',
    configResolved({ command }) {
      // While it is worked on, a compiler's complaint should name a line that can be found.
      small = command === 'build';
    },
    transform: {
      filter: { id: /\.(glsl|vert|frag)$/ },
      handler(code) {
        const imports: string[] = [];
        const parts: string[] = [];
        let text: string[] = [];
        const close = (): void => {
          if (text.length > 0) parts.push(JSON.stringify(`${text.join('\n')}\n`));
          text = [];
        };
        const plain = withoutComments(code);
        for (const line of (small ? minifiedGlsl(plain) : plain).split('\n')) {
          const path = INCLUDE.exec(line)?.[1];
          if (path) {
            close();
            imports.push(`import part${imports.length} from '/shaders${path}';`);
            parts.push(`part${imports.length - 1}`);
          } else if (line.trim() !== '') text.push(line.trim());
        }
        close();
        return { code: `${imports.join('\n')}\nexport default ${parts.join(' + ') || "''"};\n`, map: null };
      },
    },
  };
}
