import { describe, expect, test } from 'vitest';
import { lessonHtml, sourcePage } from '../../build/learn.ts';
import { codeHtml, linesOf, sourceText } from '../../build/learn-source.ts';
import { lessonPage } from '../../build/lesson-page.ts';
import { LESSONS, neighbours } from '../../src/learn/lessons.ts';

const built = (html: string): Promise<string> => lessonHtml(html, '/learn/range.html');

describe('lessons as the build writes them', () => {
  test('a formula becomes HTML and MathML, its terms have their colours, and entities are read as signs', async () => {
    const html = await built('<p><tex>\\force{F} &lt; \\answer{x}</tex></p>');
    expect(html).toContain('<math');
    expect(html).toContain('class="enclosing term-force"');
    expect(html).toContain('class="enclosing term-answer"');
    expect(html).toContain('<mo>&lt;</mo>');
    expect(html).not.toContain('<tex>');
  });

  test('an equation has its anchor, its source and can be reached with the keyboard', async () => {
    const html = await built('<equation id="eq-14" cite="Skjermo 2007, (14)">a^2</equation>');
    expect(html).toMatch(/<div class="equation" id="eq-14"><div class="formula"[^>]* tabindex="0">/);
    expect(html).toContain('<span class="cite">Skjermo 2007, (14)</span>');
    expect(html).toContain('katex-display');
  });

  test('a wrong formula stops the build and says which', async () => {
    await expect(built('<tex>\\frac{a}</tex>')).rejects.toThrow(/<tex>\\frac\{a\}<\/tex>: KaTeX/);
  });

  test('cited lines stand there with their numbers and lead to the whole file', async () => {
    const cited: string[] = [];
    const html = await lessonHtml(
      '<source-lines file="src/core/grow/curve.ts" name="curveDeltas"></source-lines>',
      '/learn/weber-penn.html',
      (file) => cited.push(file),
    );
    const { from } = await linesOf('src/core/grow/curve.ts', sourceText('src/core/grow/curve.ts'), 'curveDeltas');
    expect(html).toContain(`href="../source/src/core/grow/curve.ts.html#L${from}"`);
    expect(html).toContain(`data-line="${from}"`);
    expect(cited).toEqual(['src/core/grow/curve.ts']);
    expect(sourcePage('src/core/grow/curve.ts')).toContain(`id="L${from}"`);
  });

  test.each([
    ['src/core/grow/curve.ts', 'curveDelta', /src\/core\/grow\/curve\.ts exports no 'curveDelta'/],
    ['src/core/grow/curves.ts', 'x', /no file 'src\/core\/grow\/curves\.ts'/],
    ['src/core/../../package.json', 'x', /no source file below/],
    ['shaders/branch/radius.glsl', 'taperRadi', /radius\.glsl has no 'taperRadi'/],
  ])('%s %s: what is not there stops the build', async (file, name, message) => {
    await expect(built(`<source-lines file="${file}" name="${name}"></source-lines>`)).rejects.toThrow(message);
  });

  test('the way from one lesson to the next follows the table', async () => {
    const html = lessonPage('<main class="lesson">\n<p>Far.</p>\n</main>\n', '/learn/range.html');
    expect(html).toContain('<title>Degradation at range · Windgrove lessons</title>');
    expect(html).toContain(
      '<p class="kicker">Lesson 6 · Weber &amp; Penn 1995</p><h1>Degradation at range</h1>\n<p>Far.</p>',
    );
    expect(html).toContain('href="./wind-models.html">Before: 5');
    expect(html).toContain('href="./how-fast.html">Next: 7');
    expect(html).toContain('src="/src/learn/range/main.ts"');
    expect((await built('<lesson-cards></lesson-cards>')).match(/<li>/g)).toHaveLength(LESSONS.length);
    expect(() => lessonPage('<h1>Far</h1><main class="lesson"></main>', '/learn/range.html')).toThrow(/<main/);
    expect(() => neighbours('no-such')).toThrow(/no lesson 'no-such'/);
    expect(LESSONS.map(({ number }) => number)).toEqual([1, 2, 3, 4, 5, 6, 7]);
  });
});

describe('lines of source', () => {
  const text =
    '/** One. */\nexport function one(): void {\n  if (1 < 2) return;\n}\nfunction two(): void {}\nexport class A {\n  /** M. */\n  m(): number {\n    return 1;\n  }\n}\n';
  const glsl =
    '// Says f.\nfloat f(float x);\n\n// Does f.\nfloat f(float x) {\n  if (x > 0.0) {\n    return x; // }\n  }\n  return 0.0;\n}\nfloat g(float x) { return x; }\n';

  test.each([
    ['one', 1, 4],
    ['A.m', 7, 10],
    ['A', 6, 11],
  ])('TypeScript: %s with the comment above it', async (name, from, to) => {
    expect(await linesOf('a.ts', text, name)).toEqual({ from, to });
  });

  test('TypeScript: what is not exported is not there', async () => {
    await expect(linesOf('a.ts', text, 'two')).rejects.toThrow(/a\.ts exports no 'two'/);
  });

  test.each([
    ['f', 4, 10],
    ['g', 11, 11],
  ])('GLSL: %s is its body, not the line that announces it', async (name, from, to) => {
    expect(await linesOf('a.glsl', glsl, name)).toEqual({ from, to });
  });

  test('signs of code are no markup', () => {
    expect(codeHtml(text, { from: 3, to: 3 })).toBe('<span data-line="3">  <b>if</b> (1 &lt; 2) <b>return</b>;</span>');
  });
});
