/** The link of an editor's document: what the address holds, both ways. */
export { type DecodeOptions, decodeLink } from './decode.ts';
export * from './document.ts';
export { encodeLink, roundCamera, roundDocument, roundTime } from './encode.ts';
export { isLinkKey } from './keys.ts';
export type { LinkFault } from './reader.ts';
export { roundWind } from './round-wind.ts';
