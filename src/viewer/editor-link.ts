/** Keys of a link of the editor that mean the same as an attribute of the element. */
const SAME = { species: 's', seed: 'seed', wind: 'wind', season: 'season' } as const;
const STAGES: Readonly<Record<string, string>> = { park: 'park', golden: 'golden', studio: 'studio' };

const isId = (text: string): boolean => /^[a-z0-9-]+$/.test(text);

/** The link of the editor that comes nearest to what the attributes show; a tree of a file has none, but its editor. */
export function editorLink(attributes: ReadonlyMap<string, string>): string {
  const pairs = new URLSearchParams();
  if (attributes.has('src')) return '';
  for (const [attribute, key] of Object.entries(SAME)) {
    const value = attributes.get(attribute);
    if (value !== undefined && isId(value)) pairs.set(key, value);
  }
  const stage = STAGES[attributes.get('environment') ?? ''];
  if (stage) pairs.set('stage', stage);
  return pairs.toString();
}
