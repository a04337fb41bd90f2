/** What of an element is another when some of its properties are. */
const PROPERTIES = {
  /** The tree itself. */
  tree: ['species', 'src', 'seed', 'speciesData'],
  /** The wind that is loaded. */
  wind: ['wind', 'windData'],
  /** What is made of that wind. */
  air: ['windSpeed', 'windDirection', 'gust', 'model'],
  /** How it is looked at. */
  look: ['detail', 'environment', 'hour', 'ground', 'shadow', 'levels', 'leaves', 'season', 'maxPixelRatio', 'debug'],
} as const;

type Changes = Readonly<Record<keyof typeof PROPERTIES, boolean>>;

/** What properties that have changed ask to be done again. */
export function changesOf(changed: ReadonlyMap<PropertyKey, unknown>): Changes {
  const any = (kind: keyof typeof PROPERTIES): boolean => PROPERTIES[kind].some((key) => changed.has(key));
  return { tree: any('tree'), wind: any('wind'), air: any('air'), look: any('look') };
}
