import { allowedValues } from '../core/file/allowed.ts';
import { defaultText, meaningOf } from '../core/file/describe.ts';
import type { Parameter } from '../core/file/parameter.ts';
import { escaped } from './markup.ts';
import { words } from './words.ts';

/** A tree with little of a parameter beside one with much of it. */
export interface PicturePair {
  /** Names of the files in help/, without what comes after the last hyphen. */
  readonly name: string;
  readonly low: PictureOf;
  readonly high: PictureOf;
}

export interface PictureOf {
  /** The value, as a reader sees it. */
  readonly value: string;
  /** The link that grows this tree in the editor: what stands behind `#`. */
  readonly link: string;
}

/** Where a parameter stands in a file, and as an anchor: `levels.downAngle`. */
export const pathOf = ({ group, key }: Parameter): string => (group === '' ? key : `${group}.${key}`);

const side = (label: string, name: string, which: 'low' | 'high', { value, link }: PictureOf): string =>
  `<figure><a href="../index.html#${escaped(link)}" title="${escaped(words.open(value))}"><img src="../help/${name}-${which}.webp" alt="${escaped(
    words.shows(label, value),
  )}" width="140" height="140" loading="lazy" decoding="async"></a><figcaption>${escaped(value)}</figcaption></figure>`;

const fact = (term: string, value: string): string => (value ? `<div><dt>${term}</dt><dd>${value}</dd></div>` : '');

/** A symbol of Weber & Penn as they set it: the level's number or letter in front is small. */
const paperText = ({ symbol, section }: Parameter): string => {
  const where = /^[\d.]+$/.test(section) ? `section ${section}` : section;
  return [symbol && `<i>${escaped(symbol)}</i>`, escaped(where)].filter(Boolean).join(', ');
};

function leftOut(parameter: Parameter, optional: boolean): string {
  if (!optional) return escaped(words.required);
  const text = defaultText(parameter);
  return text === '' ? escaped(words.absent) : `<code>${escaped(text)}</code>`;
}

/** Everything about one parameter: its name, meaning, facts, and two trees that differ in it. */
export function parameterEntry(parameter: Parameter, pictures: PicturePair | undefined): string {
  const { label } = parameter;
  const path = pathOf(parameter);
  const shown = pictures
    ? `<div class="pair">${side(label, pictures.name, 'low', pictures.low)}${side(label, pictures.name, 'high', pictures.high)}</div>`
    : '';
  return `<article class="parameter" id="${path}"><div><h3><a href="#${path}" aria-label="${escaped(words.anchor(label))}">${escaped(label)}</a></h3>
<p>${escaped(meaningOf(parameter))}</p>
<dl>${fact(words.inFile, `<code>${path}</code>`)}${fact(words.symbol, paperText(parameter))}${fact(
    words.allowed,
    escaped(allowedValues(parameter)),
  )}${fact(words.byDefault, leftOut(parameter, parameter.optional === true))}</dl></div>${shown}</article>`;
}
