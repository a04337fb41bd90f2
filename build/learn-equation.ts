import katex from 'katex';

/** Terms that have the colour of what they stand for, in a formula as in a figure. */
export const TERMS = ['force', 'answer', 'velocity', 'rest', 'wrong'] as const;

const plain = (text: string): string =>
  text.replaceAll('&lt;', '<').replaceAll('&gt;', '>').replaceAll('&quot;', '"').replaceAll('&amp;', '&').trim();

/** LaTeX as it stands in a page, as HTML and MathML. Throws KaTeX's message, with the formula, where it is wrong. */
export function formulaHtml(latex: string, display: boolean): string {
  const source = plain(latex);
  try {
    return katex.renderToString(source, {
      displayMode: display,
      output: 'htmlAndMathml',
      throwOnError: true,
      strict: 'ignore',
      trust: ({ command }) => command === '\\htmlClass',
      macros: Object.fromEntries(TERMS.map((term) => [`\\${term}`, `\\htmlClass{term-${term}}{#1}`])),
    });
  } catch (error) {
    throw new Error(`<tex>${source}</tex>: ${error instanceof Error ? error.message : String(error)}`);
  }
}
