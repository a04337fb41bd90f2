import type { PackedTree } from '../core/pack/packed.ts';
import type { KitTree } from '../view/kit-tree.ts';
import type { TextureImages, TextureLayer } from '../view/picture/picture.ts';
import { textureImages } from '../view/picture/texture-images.ts';

type Renderer = Parameters<KitTree['readBack']>[0];

/** What was read of a tree, as of which time. */
interface Read {
  time: number;
  reads: boolean;
  tiles: readonly { readonly id: string; readonly image: OffscreenCanvas }[];
}

/** Parts of the picture: height of the strip at most, and room about a tile. */
const HIGH = 0.25;
const ROOM = 0.012;

/** The first three numbers of a texel as red, green and blue, each from the least to the most that there is; texels that no piece has are clear. */
function tile({ data }: TextureLayer, { width, height, pieceCount }: TextureImages): OffscreenCanvas {
  const image = new ImageData(width, height);
  for (let channel = 0; channel < 3; channel++) {
    let least = Number.POSITIVE_INFINITY;
    let most = Number.NEGATIVE_INFINITY;
    for (let i = 0; i < pieceCount; i++) {
      const value = data[4 * i + channel] as number;
      least = Math.min(least, value);
      most = Math.max(most, value);
    }
    const scale = 255 / Math.max(most - least, 1e-9);
    for (let i = 0; i < pieceCount; i++)
      image.data[4 * i + channel] = ((data[4 * i + channel] as number) - least) * scale;
  }
  for (let i = 0; i < pieceCount; i++) image.data[4 * i + 3] = 255;
  const canvas = new OffscreenCanvas(width, height);
  canvas.getContext('2d')?.putImageData(image, 0, 0);
  return canvas;
}

/** The textures that the wind pass keeps of a tree, a tile each, along the top of its picture, the controls being below: every texel is a piece of a branch. */
export class DebugState {
  readonly #read = new WeakMap<KitTree, Read>();

  /** Draws what was read last into a picture of `tree` as of `time`; where that is of another time it is read anew, and `come` is called. */
  draw(
    renderer: Renderer,
    tree: KitTree,
    packed: PackedTree,
    time: number,
    canvas: HTMLCanvasElement,
    come: () => void,
  ): void {
    const read = this.#read.get(tree) ?? { time: Number.NaN, reads: false, tiles: [] };
    this.#read.set(tree, read);
    if (read.time !== time && !read.reads) void this.#take(renderer, tree, packed, time, read).then(come);
    const context = canvas.getContext('2d');
    if (!context || read.tiles.length === 0) return;
    const { width, height } = canvas;
    const room = ROOM * width;
    const first = read.tiles[0]!.image;
    const wide = Math.min((width - room) / read.tiles.length - room, (HIGH * height * first.width) / first.height);
    const high = (wide * first.height) / first.width;
    context.globalCompositeOperation = 'source-over';
    context.imageSmoothingEnabled = false;
    context.font = `${Math.max(9, Math.round(height / 40))}px monospace`;
    read.tiles.forEach(({ id, image }, i) => {
      const [x, y] = [room + i * (wide + room), room];
      context.fillStyle = '#111';
      context.fillRect(x - 1, y - 1, wide + 2, high + 2);
      context.drawImage(image, x, y, wide, high);
      context.fillStyle = '#fff';
      // Where it has room: a picture may be as small as a stamp.
      if (context.measureText(id).width + 6 < wide) context.fillText(id, x + 3, y + high - 4);
    });
  }

  async #take(renderer: Renderer, tree: KitTree, packed: PackedTree, time: number, read: Read): Promise<void> {
    read.reads = true;
    // A lost context gives nothing; the next picture asks again.
    const back = await tree.readBack(renderer).catch(() => null);
    read.reads = false;
    if (!back) return;
    const images = textureImages(packed, back.pose, back.state);
    Object.assign(read, { time, tiles: images.layers.map((layer) => ({ id: layer.id, image: tile(layer, images) })) });
  }
}
