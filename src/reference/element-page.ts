import { contents, escaped } from './markup.ts';
import { plainMarkdown } from './plain-markdown.ts';
import { words } from './words.ts';

interface Typed {
  readonly type?: { readonly text: string };
}

/** A row of the manifest, whatever it describes. */
interface Entry extends Typed {
  readonly name?: string;
  readonly description?: string;
  readonly default?: string;
  readonly attribute?: string;
  readonly kind?: string;
  readonly privacy?: string;
  readonly static?: boolean;
  readonly inheritedFrom?: unknown;
  readonly parameters?: readonly (Typed & { readonly name: string; readonly optional?: boolean })[];
  readonly return?: Typed;
}

/** What of a custom-elements manifest the page needs. */
interface Declaration {
  readonly tagName?: string;
  readonly description?: string;
  readonly attributes?: readonly Entry[];
  readonly members?: readonly Entry[];
  readonly events?: readonly Entry[];
  readonly slots?: readonly Entry[];
  readonly cssParts?: readonly Entry[];
  readonly cssProperties?: readonly Entry[];
  readonly cssStates?: readonly Entry[];
}

export interface Manifest {
  readonly modules: readonly { readonly declarations?: readonly Declaration[] }[];
}

const said = words.element;
const code = (text: string | undefined): string => (text ? `<code>${escaped(text)}</code>` : '');
const sentence = (text = ''): string => plainMarkdown(text).replace(/^<p>([\s\S]*)<\/p>$/, '$1');

/** `toBlob(options?: Shot): Promise<Blob>` */
const signature = ({ name, parameters = [], return: returned }: Entry): string =>
  `${name}(${parameters.map((p) => `${p.name}${p.optional ? '?' : ''}${p.type ? `: ${p.type.text}` : ''}`).join(', ')})${
    returned?.type ? `: ${returned.type.text}` : ''
  }`;

function table(kind: string, entries: readonly Entry[], typed: boolean): string {
  const isMethod = kind === 'methods';
  const rows = entries.map((entry) => {
    const name = entry.name || said.theDefault;
    const id = `${kind}-${entry.name || 'default'}`;
    const cells = [
      `<th scope="row" id="${escaped(id)}"><a href="#${escaped(id)}">${isMethod ? code(signature(entry)) : entry.name ? code(name) : name}</a></th>`,
    ];
    if (typed) cells.push(`<td>${code(entry.type?.text)}</td>`, `<td>${code(entry.default)}</td>`);
    return `<tr>${cells.join('')}<td>${sentence(entry.description)}</td></tr>`;
  });
  const heads = [said.name, ...(typed ? [said.type, said.otherwise] : []), said.means];
  return `<div class="scroll" tabindex="0"><table><thead><tr>${heads.map((h) => `<th scope="col">${h}</th>`).join('')}</tr></thead><tbody>${rows.join('')}</tbody></table></div>`;
}

const isPublic = ({ privacy, static: isStatic, description, inheritedFrom }: Entry): boolean =>
  (privacy ?? 'public') === 'public' && !isStatic && !inheritedFrom && Boolean(description);

/** The page of `<wind-tree>`, from its manifest. */
export function elementPage(manifest: Manifest): string {
  const element = manifest.modules.flatMap((m) => m.declarations ?? []).find(({ tagName }) => tagName === 'wind-tree');
  if (!element) return `<p>${said.none}</p>`;
  const members = (element.members ?? []).filter(isPublic);
  const attributes = element.attributes ?? [];
  const chapters: readonly (readonly [kind: string, title: string, entries: readonly Entry[], typed: boolean])[] = [
    ['attributes', said.attributes, attributes, true],
    ['properties', said.properties, members.filter(({ kind, attribute }) => kind === 'field' && !attribute), true],
    ['methods', said.methods, members.filter(({ kind }) => kind === 'method'), false],
    ['events', said.events, element.events ?? [], false],
    ['slots', said.slots, element.slots ?? [], false],
    ['parts', said.parts, element.cssParts ?? [], false],
    ['css-properties', said.cssProperties, element.cssProperties ?? [], false],
    ['states', said.cssStates, element.cssStates ?? [], false],
  ];
  const shown = chapters.filter(([, , entries]) => entries.length > 0);
  return `${plainMarkdown(element.description ?? '')}
${contents(
  words.contents,
  shown.map(([kind, title]) => [kind, title] as const),
)}
${shown.map(([kind, title, entries, typed]) => `<section id="${kind}"><h2>${title}</h2>${table(kind, entries, typed)}</section>`).join('\n')}`;
}
