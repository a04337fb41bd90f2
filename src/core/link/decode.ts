import { nearest } from '../file/nearest.ts';
import { SEASONS } from '../species/season.ts';
import { treeNameOf } from '../species/tree-name.ts';
import { decodeEdits } from './decode-edits.ts';
import { decodeWind, type Winds } from './decode-wind.ts';
import {
  type CameraPose,
  type Comparison,
  LAYOUTS,
  type LinkDocument,
  STAGES,
  THEMES,
  VIEW_MODES,
} from './document.ts';
import { COMPARED, roundDocument, roundTime } from './encode.ts';
import { CAMERA_NUMBERS, LINK_NUMBERS } from './numbers.ts';
import { unpackLink } from './packed-link.ts';
import { type LinkFault, LinkReader } from './reader.ts';
import { allowed, readNumber } from './rule.ts';
import { textFromBase64 } from './text.ts';

export interface DecodeOptions {
  /** What is used where the link says nothing, or nonsense. */
  readonly defaults: LinkDocument;
  /** Ids of the species that ship. */
  readonly species: readonly string[];
  /** Winds that ship, by id. */
  readonly winds: Winds;
}

/**
 * Reads what `encodeLink` wrote, or a person typed: each value that is wrong gives a fault and its default, the rest applies.
 *
 * Never throws. Keys that no link has are faults too: most often they are a slip of the pen.
 */
export function decodeLink(link: string, options: DecodeOptions): { document: LinkDocument; faults: LinkFault[] } {
  const { defaults, species, winds } = options;
  const reader = readerOf(link);
  const own = reader.read('own', null, 'a species file as base64url', (text) => textFromBase64(text) ?? undefined);
  const file = reader.read('file', own, 'a species file', (text) => text || undefined);
  const { preset, wind } = decodeWind(reader, winds, defaults);
  const { overlays } = defaults;
  const document = roundDocument({
    species: reader.choice('s', defaults.species, species),
    ownSpecies: file,
    edits: decodeEdits(reader),
    treeName: reader.read('called', null, 'a name', (text) => treeNameOf(text) ?? undefined),
    seed: reader.linkNumber('seed', defaults.seed),
    time: roundTime(reader.linkNumber('t', defaults.time)),
    paused: reader.flag('paused', defaults.paused),
    rate: reader.linkNumber('rate', defaults.rate),
    camera: camera(reader, defaults.camera),
    levelsShown: reader.linkNumber('levels', defaults.levelsShown),
    showLeaves: reader.flag('leaves', defaults.showLeaves),
    view: reader.choice('view', defaults.view, VIEW_MODES),
    theme: reader.choice('theme', defaults.theme, THEMES),
    season: reader.choice('season', defaults.season, SEASONS),
    stage: reader.choice('stage', defaults.stage, STAGES),
    hour: reader.read('hour', defaults.hour, allowed(LINK_NUMBERS.hour), (text) => readNumber(LINK_NUMBERS.hour, text)),
    overlays: {
      arrows: reader.flag('arrows', overlays.arrows),
      fronts: reader.flag('fronts', overlays.fronts),
      handle: reader.flag('handle', overlays.handle),
    },
    probe: reader.read('probe', defaults.probe, allowed(LINK_NUMBERS.probe), (text) =>
      readNumber(LINK_NUMBERS.probe, text),
    ),
    blowing: reader.flag('blow', defaults.blowing),
    preset,
    wind,
    compare: compare(reader, winds, { preset, wind }) ?? defaults.compare,
  });
  unknownKeys(reader);
  return { document, faults: reader.faults };
}

/** The values of a link; of a packed one those within, and what was typed beside them goes before. */
function readerOf(link: string): LinkReader {
  const typed = new Map(new URLSearchParams(link.replace(/^[#?]/, '')));
  const packed = typed.get('z');
  const within = packed === undefined ? '' : unpackLink(packed);
  typed.delete('z');
  const reader = new LinkReader(new Map([...new URLSearchParams(within ?? ''), ...typed]));
  reader.known.add('z');
  if (within === undefined) reader.fault('z', packed!, 'a packed link, whole');
  return reader;
}

/** Keys for which the one that was meant is looked for: a link can hold a megabyte of nonsense. */
const LOOKED_FOR = 20;

/** A fault for each key that no link has. */
function unknownKeys(reader: LinkReader): void {
  const known = [...reader.known];
  let count = 0;
  for (const [key, value] of reader.values) {
    const near = count++ < LOOKED_FOR ? nearest(key, known) : undefined;
    reader.fault(key, value, near ? `${near}, if that was meant` : 'nothing of this name');
  }
}

function camera(reader: LinkReader, fallback: CameraPose | null): CameraPose | null {
  const text = reader.take('cam');
  const numbers = text === undefined ? null : reader.list('cam', text, CAMERA_NUMBERS);
  if (!numbers) return text === undefined ? fallback : null;
  const [azimuth, elevation, distance, x, y, z] = numbers as [number, number, number, number, number, number];
  return { azimuth, elevation, distance, target: [x, y, z] };
}

/** `split,0.5` and a wind under keys of its own; where those say nothing, the first one's. */
function compare(reader: LinkReader, winds: Winds, first: { preset: string; wind: Comparison['wind'] }) {
  const found = reader.wordAndNumbers('compare', LAYOUTS, [LINK_NUMBERS.at], [0.5]);
  if (!found) return null;
  return { layout: found.word, at: found.numbers[0]!, ...decodeWind(reader.within(COMPARED), winds, first) };
}
