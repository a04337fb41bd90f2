/** The names of the channels in the order in which a file has them: by alphabet, which puts alpha first. */
const CHANNELS = ['A', 'B', 'G', 'R'] as const;
const PLACE = { R: 0, G: 1, B: 2, A: 3 } as const;
const HALF = 1;

/** A little-endian writer of a file whose length is known. */
class Writer {
  readonly bytes: Uint8Array<ArrayBuffer>;
  private readonly view: DataView;
  at = 0;

  constructor(size: number) {
    this.bytes = new Uint8Array(size);
    this.view = new DataView(this.bytes.buffer);
  }

  byte(value: number): void {
    this.view.setUint8(this.at, value);
    this.at += 1;
  }

  int(value: number): void {
    this.view.setInt32(this.at, value, true);
    this.at += 4;
  }

  float(value: number): void {
    this.view.setFloat32(this.at, value, true);
    this.at += 4;
  }

  short(value: number): void {
    this.view.setUint16(this.at, value, true);
    this.at += 2;
  }

  text(value: string): void {
    for (let i = 0; i < value.length; i++) this.byte(value.charCodeAt(i));
    this.byte(0);
  }

  attribute(name: string, type: string, size: number): void {
    this.text(name);
    this.text(type);
    this.int(size);
  }
}

/**
 * An OpenEXR image of four half-precision channels, uncompressed, in one part of scan lines.
 *
 * `bits`: `Uint16Array`, 4 width height, the bits of red, green, blue and alpha of each texel, rows from the top. They arrive as they are:
 * alpha may hold bits that stand for a whole number. Source: the file layout of OpenEXR, version 2.
 */
export function writeExr(width: number, height: number, bits: Uint16Array): Uint8Array<ArrayBuffer> {
  const line = 2 * CHANNELS.length * width;
  const out = new Writer(head(new Writer(4096), width, height) + height * (8 + 8 + line));
  const start = head(out, width, height);
  for (let y = 0; y < height; y++) {
    const at = start + 8 * height + y * (8 + line);
    // Offsets are 64 bits wide; no image of ours is beyond 32.
    out.int(at);
    out.int(0);
  }
  for (let y = 0; y < height; y++) {
    out.int(y);
    out.int(line);
    for (const channel of CHANNELS)
      for (let x = 0; x < width; x++) out.short(bits[4 * (y * width + x) + PLACE[channel]]!);
  }
  return out.bytes;
}

/** Writes the head of the file; returns where it ends. */
function head(out: Writer, width: number, height: number): number {
  out.int(20000630);
  out.int(2);
  out.attribute('channels', 'chlist', 18 * CHANNELS.length + 1);
  for (const channel of CHANNELS) {
    out.text(channel);
    out.int(HALF);
    out.int(0);
    out.int(1);
    out.int(1);
  }
  out.byte(0);
  out.attribute('compression', 'compression', 1);
  out.byte(0);
  for (const window of ['dataWindow', 'displayWindow']) {
    out.attribute(window, 'box2i', 16);
    for (const edge of [0, 0, width - 1, height - 1]) out.int(edge);
  }
  out.attribute('lineOrder', 'lineOrder', 1);
  out.byte(0);
  out.attribute('pixelAspectRatio', 'float', 4);
  out.float(1);
  out.attribute('screenWindowCenter', 'v2f', 8);
  out.float(0);
  out.float(0);
  out.attribute('screenWindowWidth', 'float', 4);
  out.float(1);
  out.byte(0);
  return out.at;
}
