import { parseIndex } from '../core/file/shipped-index.ts';
import { decodeLink } from '../core/link/decode.ts';
import { ALL_LEVELS, type LinkDocument, OVERLAYS, type StageId, type ViewMode } from '../core/link/document.ts';
import type { LinkFault } from '../core/link/reader.ts';
import { roundWind } from '../core/link/round-wind.ts';
import { viewerLacks } from '../core/link/viewer-parts.ts';
import { editSpecies } from '../core/species/edits.ts';
import { parseSpecies } from '../core/species/parse.ts';
import type { Species } from '../core/species/species.ts';
import { STILL, type Wind } from '../core/wind/wind.ts';
import type { ElementDebug, ElementEnvironment } from '../element/attributes.ts';
import { loadSpecies, loadText, loadWind } from '../view/load.ts';
import { words } from './words.ts';

/** What the element shows for a link of the editor. */
export interface ShownByLink {
  readonly species: Species;
  readonly wind: Wind;
  readonly document: LinkDocument;
  readonly environment: ElementEnvironment;
  readonly debug: ElementDebug;
  /** Names of what the link has and the element has not. */
  readonly leftOut: readonly string[];
  readonly faults: readonly LinkFault[];
}

/** The wind of a link that names none. */
const USUAL_WIND = 'breeze';

const ENVIRONMENT_OF: Readonly<Record<StageId, ElementEnvironment>> = {
  meadow: 'sky',
  park: 'park',
  golden: 'golden',
  studio: 'studio',
};

const DEBUG_OF: Readonly<Record<ViewMode, ElementDebug>> = {
  shaded: 'none',
  wireframe: 'mesh',
  control: 'skeleton',
  levels: 'levels',
};

/** How the element shows what a link draws over its tree or in its place: one thing at a time. */
const debugOf = ({ view, overlays }: LinkDocument): ElementDebug =>
  view === 'shaded' && overlays.arrows ? 'field' : DEBUG_OF[view];

const listOf = async (path: string) => parseIndex(JSON.parse(await loadText(path))).entries ?? [];

/** Every wind that ships, by id, as links round it; one that does not come is missing. */
async function shippedWinds(): Promise<Record<string, Wind>> {
  const entries = await listOf('winds/index.json');
  const found = await Promise.allSettled(
    entries.map(async ({ id, file }) => [id, roundWind(await loadWind(`winds/${file}`))] as const),
  );
  return Object.fromEntries(found.flatMap((one) => (one.status === 'fulfilled' ? [one.value] : [])));
}

const usual = (wind: Wind): LinkDocument => ({
  species: 'quaking-aspen',
  ownSpecies: null,
  edits: {},
  treeName: null,
  seed: 1,
  time: 0,
  paused: false,
  rate: 1,
  camera: null,
  levelsShown: ALL_LEVELS,
  showLeaves: true,
  view: 'shaded',
  theme: 'auto',
  season: 'summer',
  stage: 'meadow',
  hour: null,
  overlays: OVERLAYS,
  probe: null,
  blowing: true,
  preset: USUAL_WIND,
  wind,
  compare: null,
});

/**
 * The tree and the wind that a link of the editor means: its species with the edits in it, its wind as it was mixed.
 *
 * Files are read beside the page. Throws LoadError where the species cannot be had, an Error where one of the reader's own is wrong.
 */
export async function shownByLink(link: string): Promise<ShownByLink> {
  const [list, winds] = await Promise.all([listOf('species/index.json'), shippedWinds()]);
  const options = { defaults: usual(winds[USUAL_WIND] ?? STILL), species: list.map(({ id }) => id), winds };
  const { document, faults } = decodeLink(link, options);
  const { ownSpecies, edits, treeName, blowing, wind } = document;
  const base = ownSpecies === null ? await shipped(list, document.species) : read(ownSpecies);
  const edited = editSpecies(base, edits);
  return {
    species: treeName === null ? edited : { ...edited, name: treeName },
    wind: blowing ? wind : { ...wind, strength: 0 },
    document,
    environment: ENVIRONMENT_OF[document.stage],
    debug: debugOf(document),
    leftOut: viewerLacks(document).map((part) => words.parts[part]),
    faults,
  };
}

const shipped = (list: Awaited<ReturnType<typeof listOf>>, id: string): Promise<Species> =>
  loadSpecies(`species/${list.find((entry) => entry.id === id)?.file ?? `${id}.json`}`);

function read(text: string): Species {
  const { species, faults } = parseSpecies(text);
  if (species) return species;
  throw new Error(faults.map(({ path, found, allowed }) => `${path}: found ${found}; allowed: ${allowed}.`).join(' '));
}
