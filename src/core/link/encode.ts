import { treeNameOf } from '../species/tree-name.ts';
import { ALL_LEVELS, type CameraPose, type LinkDocument, OVERLAYS, STEPS_PER_SECOND } from './document.ts';
import { editText, roundEdits } from './encode-edits.ts';
import { encodeWind } from './encode-wind.ts';
import { CAMERA_NUMBERS, LINK_NUMBERS } from './numbers.ts';
import { packLink } from './packed-link.ts';
import { roundWind } from './round-wind.ts';
import { kept, roundTo } from './rule.ts';
import { textToBase64 } from './text.ts';

/** Before the keys of the second wind. */
export const COMPARED = 'b.';

/** The nearest step of the clock to `seconds`, in seconds. */
export const roundTime = (seconds: number): number =>
  Math.round(roundTo(LINK_NUMBERS.t, seconds) * STEPS_PER_SECOND) / STEPS_PER_SECOND;

const cameraNumbers = (camera: CameraPose): number[] =>
  CAMERA_NUMBERS.map((rule, i) =>
    kept(rule, [camera.azimuth, camera.elevation, camera.distance, ...camera.target][i]!),
  );

/** The camera with the digits that a link keeps. */
export function roundCamera(camera: CameraPose): CameraPose {
  const [azimuth, elevation, distance, x, y, z] = cameraNumbers(camera) as [
    number,
    number,
    number,
    number,
    number,
    number,
  ];
  return { azimuth, elevation, distance, target: [x, y, z] };
}

/** The document with the digits that a link keeps: what `decodeLink(encodeLink(document))` gives back. */
export function roundDocument(document: LinkDocument): LinkDocument {
  const { compare } = document;
  return {
    ...document,
    edits: roundEdits(document.edits),
    treeName: document.treeName === null ? null : treeNameOf(document.treeName),
    seed: roundTo(LINK_NUMBERS.seed, document.seed),
    time: roundTime(document.time),
    rate: roundTo(LINK_NUMBERS.rate, document.rate),
    levelsShown: roundTo(LINK_NUMBERS.levels, document.levelsShown),
    camera: document.camera && roundCamera(document.camera),
    hour: document.hour === null ? null : roundTo(LINK_NUMBERS.hour, document.hour),
    probe: document.probe === null ? null : roundTo(LINK_NUMBERS.probe, document.probe),
    wind: roundWind(document.wind),
    compare: compare && { ...compare, at: roundTo(LINK_NUMBERS.at, compare.at), wind: roundWind(compare.wind) },
  };
}

/** Characters of the longest link that stays readable: programs that pass links on cut what is much longer. */
const LONGEST_READABLE = 1500;

/**
 * The document as `key=value` pairs for the part of an address behind `#`; one that would be too long to pass on, packed: `z=...`.
 *
 * Species, seed, time and waves always stand there, so that a link keeps its picture when the winds that ship are tuned; what
 * is as in a fresh document (all levels, shaded, playing, ...) is left out.
 */
export function encodeLink(document: LinkDocument): string {
  const d = roundDocument(document);
  const readable = linkOf(d, 'own');
  if (readable.length <= LONGEST_READABLE) return readable;
  const packed = `z=${packLink(linkOf(d, 'file'))}`;
  return packed.length < readable.length ? packed : readable;
}

/** `file` has the text of the reader's own species as it is, which packs better than `own`, its base64url. */
function linkOf(d: LinkDocument, own: 'own' | 'file'): string {
  const pairs: [string, string][] = [];
  const put = (key: string, value: string | number): void => void pairs.push([key, String(value)]);
  if (d.ownSpecies === null) put('s', d.species);
  else put(own, own === 'own' ? textToBase64(d.ownSpecies) : d.ownSpecies.replace(/\p{Surrogate}/gu, '\ufffd'));
  put('seed', d.seed);
  for (const [path, value] of Object.entries(d.edits)) put(path, editText(path, value));
  if (d.treeName !== null) put('called', d.treeName);
  put('t', roundTo(LINK_NUMBERS.t, d.time));
  if (d.paused) put('paused', 1);
  if (d.rate !== 1) put('rate', d.rate);
  if (d.camera) put('cam', cameraNumbers(d.camera).join());
  if (d.levelsShown < ALL_LEVELS) put('levels', d.levelsShown);
  if (!d.showLeaves) put('leaves', 0);
  if (d.view !== 'shaded') put('view', d.view);
  if (d.theme !== 'auto') put('theme', d.theme);
  if (d.season !== 'summer') put('season', d.season);
  if (d.stage !== 'meadow') put('stage', d.stage);
  if (d.hour !== null) put('hour', d.hour);
  for (const key of ['arrows', 'fronts', 'handle'] as const) {
    if (d.overlays[key] !== OVERLAYS[key]) put(key, d.overlays[key] ? 1 : 0);
  }
  if (d.probe !== null) put('probe', d.probe);
  if (!d.blowing) put('blow', 0);
  encodeWind(d.preset, d.wind, put);
  if (d.compare) {
    const { layout, at, preset, wind } = d.compare;
    put('compare', `${layout},${at}`);
    encodeWind(preset, wind, (key, value) => put(`${COMPARED}${key}`, value));
  }
  return pairs.map(([key, value]) => `${key}=${encodeURIComponent(value).replaceAll('%2C', ',')}`).join('&');
}
