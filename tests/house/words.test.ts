import { readFileSync } from 'node:fs';
import { describe, expect, it } from 'vitest';
import { inlineWords } from './template-words.ts';
import { filesUnder } from './tree-files.ts';

const sources = filesUnder('src/editor').filter((file) => file.endsWith('.ts') && !file.includes('/words/'));

describe('words', () => {
  it('stand in src/editor/words alone', () => {
    expect(sources.length).toBeGreaterThan(40);
    expect(sources.flatMap((file) => inlineWords(readFileSync(file, 'utf8'), file))).toEqual([]);
  });

  // `§{` stands for the beginning of an expression.
  const code = (sample: string): string => sample.replaceAll('§{', '${');

  it.each([
    ['a text', 'html`<p>Grow it</p>`'],
    ['a label', 'html`<button aria-label="Close">×</button>`'],
    ['a label with a value', 'html`<button aria-label="Close §{name}">×</button>`'],
    ['a tooltip from an expression', "html`<b title=§{on ? 'Wind on' : words.off}></b>`"],
    ['a text from an expression', "html`<p>§{words.a}§{none ? 'Nothing here' : words.b}</p>`"],
    ['a message', "actions.notify('error', 'It failed', [])"],
    ['a field', "numberField({ label: 'Length' })"],
  ])('are seen in %s', (_, sample) => {
    expect(inlineWords(code(sample), 'a.ts')).toHaveLength(1);
  });

  it.each([
    ['a class and an id', 'html`<p class="soft wide" id=§{`a-§{b}`}>§{words.a}</p>`'],
    ['a unit and a symbol', 'html`<span>m/s</span><b>S</b><i>5&nbsp;%</i>`'],
    ['what is compared', "html`<p title=§{kind === 'error' ? words.a : words.b}></p>`"],
    ['an event', "html`<p @click=§{() => go('somewhere else')}>§{words.a}</p>`"],
  ])('are not seen in %s', (_, sample) => {
    expect(inlineWords(code(sample), 'a.ts')).toEqual([]);
  });
});
