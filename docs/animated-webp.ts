// Puts still WebP pictures together to a moving one. Source: the WebP container specification, chunks VP8X, ANIM and ANMF.

interface Chunk {
  readonly name: string;
  readonly data: Uint8Array;
}

/** The chunks of a RIFF file of the kind WEBP. Throws where it is something else. */
function chunksOf(file: Uint8Array): Chunk[] {
  const view = new DataView(file.buffer, file.byteOffset, file.byteLength);
  const name = (at: number): string => String.fromCharCode(...file.subarray(at, at + 4));
  if (name(0) !== 'RIFF' || name(8) !== 'WEBP') throw new Error('not a WebP picture');
  const chunks: Chunk[] = [];
  for (let at = 12; at + 8 <= file.length; ) {
    const size = view.getUint32(at + 4, true);
    chunks.push({ name: name(at), data: file.subarray(at + 8, at + 8 + size) });
    at += 8 + size + (size & 1);
  }
  return chunks;
}

function chunkBytes({ name, data }: Chunk): Uint8Array {
  const bytes = new Uint8Array(8 + data.length + (data.length & 1));
  bytes.set([...name].map((letter) => letter.charCodeAt(0)));
  new DataView(bytes.buffer).setUint32(4, data.length, true);
  bytes.set(data, 8);
  return bytes;
}

const joined = (parts: readonly Uint8Array[]): Uint8Array => new Uint8Array(Buffer.concat(parts));

/** An unsigned number in three bytes, the lowest first. */
const three = (value: number): number[] => [value & 255, (value >> 8) & 255, (value >> 16) & 255];

/**
 * A picture that shows `frames` (files of opaque WebP pictures, all of `width` x `height` pixels) one after the other, each for
 * `milliseconds`, over and over.
 */
export function animatedWebp(
  frames: readonly Uint8Array[],
  { width, height, milliseconds }: { width: number; height: number; milliseconds: number },
): Uint8Array {
  const animated = 0x02;
  const head = new Uint8Array([animated, 0, 0, 0, ...three(width - 1), ...three(height - 1)]);
  // Background white, loops for ever.
  const animation = new Uint8Array([255, 255, 255, 255, 0, 0]);
  const place = [...three(0), ...three(0), ...three(width - 1), ...three(height - 1), ...three(milliseconds)];
  // Every frame covers the whole picture: nothing of the last one needs to be blended or cleared.
  const noBlend = 0x02;
  const body = [
    chunkBytes({ name: 'VP8X', data: head }),
    chunkBytes({ name: 'ANIM', data: animation }),
    ...frames.map((file) => {
      const picture = chunksOf(file).filter(({ name }) => name === 'VP8 ' || name === 'VP8L');
      if (picture.length !== 1) throw new Error('a frame must be one opaque picture');
      return chunkBytes({ name: 'ANMF', data: joined([new Uint8Array([...place, noBlend]), chunkBytes(picture[0]!)]) });
    }),
  ];
  const content = joined([new TextEncoder().encode('WEBP'), ...body]);
  return chunkBytes({ name: 'RIFF', data: content });
}
