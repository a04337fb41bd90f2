import { anchorOf, escaped } from './markup.ts';

/** What is done with the address of a link or picture. */
export type Readdress = (address: string) => string;

const KEPT = '\u0000';

/** Code, links, pictures, strong and emphasis within a line. */
function inline(text: string, readdress: Readdress): string {
  const codes: string[] = [];
  const plain = escaped(text).replace(/`([^`]+)`/g, (_, code: string) => {
    codes.push(`<code>${code}</code>`);
    return `${KEPT}${codes.length - 1}${KEPT}`;
  });
  return plain
    .replace(
      /!\[([^\]]*)\]\(([^)\s]+)\)/g,
      (_, alt: string, to: string) => `<img src="${readdress(to)}" alt="${alt}" loading="lazy">`,
    )
    .replace(/\[([^\]]+)\]\(([^)\s]+)\)/g, (_, label: string, to: string) => `<a href="${readdress(to)}">${label}</a>`)
    .replace(/\*\*([^*]+)\*\*/g, '<strong>$1</strong>')
    .replace(/(?<![\w*])\*([^*\s][^*]*)\*(?!\w)/g, '<em>$1</em>')
    .replace(new RegExp(`${KEPT}(\\d+)${KEPT}`, 'g'), (_, i: string) => codes[Number(i)]!);
}

const cellsOf = (line: string): string[] =>
  line
    .replace(/^\|\s*|\s*\|$/g, '')
    .split(/(?<!\\)\|/)
    .map((cell) => cell.trim().replaceAll('\\|', '|'));

function table(lines: readonly string[], readdress: Readdress): string {
  const [head, rule, ...rows] = lines.map(cellsOf) as [string[], string[], ...string[][]];
  const numbers = rule.map((cell) => (cell.endsWith(':') ? ' class="number"' : ''));
  const row = (cells: readonly string[], tag: 'th' | 'td'): string =>
    `<tr>${cells
      .map(
        (cell, i) =>
          `<${cell === '' ? 'td' : tag}${tag === 'th' && cell !== '' ? ' scope="col"' : ''}${numbers[i] ?? ''}>${inline(cell, readdress)}</${cell === '' ? 'td' : tag}>`,
      )
      .join('')}</tr>`;
  const heads = head.some(Boolean) ? `<thead>${row(head, 'th')}</thead>` : '';
  return `<div class="scroll" tabindex="0"><table>${heads}<tbody>${rows.map((r) => row(r, 'td')).join('')}</tbody></table></div>`;
}

/** Items of a list; a line that is indented goes on with the item before it. */
const list = (lines: readonly string[], readdress: Readdress): string => {
  const ordered = /^\d/.test(lines[0]!);
  const items: string[] = [];
  for (const line of lines) {
    if (/^(?:[-*]|\d+\.) /.test(line)) items.push(line.replace(/^(?:[-*]|\d+\.) /, ''));
    else items.push(`${items.pop() ?? ''} ${line.trim()}`);
  }
  const tag = ordered ? 'ol' : 'ul';
  return `<${tag}>${items.map((item) => `<li>${inline(item, readdress)}</li>`).join('')}</${tag}>`;
};

function block(lines: readonly string[], readdress: Readdress): string {
  const first = lines[0]!;
  const heading = /^(#{1,4}) (.*)$/.exec(first);
  if (heading) {
    const level = heading[1]!.length;
    const title = inline(heading[2]!, readdress);
    const rest = lines.length > 1 ? block(lines.slice(1), readdress) : '';
    return `<h${level} id="${anchorOf(title)}">${title}</h${level}>${rest}`;
  }
  if (first.startsWith('<!--')) return lines.length > 1 ? block(lines.slice(1), readdress) : '';
  if (first.startsWith('|')) return table(lines, readdress);
  if (/^(?:[-*]|\d+\.) /.test(first)) return list(lines, readdress);
  return `<p>${inline(lines.join(' '), readdress)}</p>`;
}

/**
 * The Markdown that docs/ is written in, as HTML: headings with anchors, paragraphs, lists of one level, tables, code, links, pictures.
 *
 * Text is never markup: what stands in angle brackets is shown.
 */
export function plainMarkdown(text: string, readdress: Readdress = (address) => address): string {
  const parts = text.replaceAll('\r\n', '\n').split(/^```(\w*)\n([\s\S]*?)^```$/m);
  const html: string[] = [];
  for (let i = 0; i < parts.length; i += 3) {
    const blocks = parts[i]!.split(/\n\s*\n/).map((b) => b.split('\n').filter((line) => line.trim() !== ''));
    html.push(...blocks.filter((lines) => lines.length > 0).map((lines) => block(lines, readdress)));
    if (i + 2 < parts.length) html.push(`<pre tabindex="0"><code>${escaped(parts[i + 2]!)}</code></pre>`);
  }
  return html.join('\n');
}
