/** The link of an editor's document: what the address holds, both ways. */
export { type DecodeOptions, decodeLink, type LinkFault } from './decode.ts';
export * from './document.ts';
export { encodeLink, roundCamera, roundDocument, roundTime } from './encode.ts';
