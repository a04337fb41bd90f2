import { DataArrayTexture, FloatType, RGBAFormat } from 'three';
import { channelColour, stemChannels } from '../core/io/channels.ts';
import { MECHANICS, MECHANICS_SIZE, TEXEL } from '../core/pack/layout.ts';
import type { PackedTree } from '../core/pack/packed.ts';
import type { StemTable } from '../core/pack/stem-table.ts';
import type { Species } from '../core/species/species.ts';
import { provideChannels } from './channel-shader.ts';
import type { ChannelView } from './picture/picture.ts';

/** What the shaders need of a channel, a texel a piece: its colour, or what the sway along its stem follows from; and its part of the stem. */
export function channelTexels(
  { pieces, pieceCount, mechanics, bounds }: PackedTree,
  stems: StemTable,
  { wind }: Species,
  channel: ChannelView,
): DataArrayTexture {
  provideChannels();
  const { width, height } = pieces;
  const plane = width * height * TEXEL;
  const data = new Float32Array(2 * plane);
  const channels = stemChannels(stems, wind.stiffness);
  for (let i = 0; i < pieceCount; i++) {
    const stem = stems.stemOfPiece[i] as number;
    const told =
      channel === 'sway'
        ? [channels.swayBase[stem] as number, channels.swayGain[stem] as number, channels.start[stem] as number]
        : channelColour(channels, channel, stem, 0, bounds);
    data.set(told, TEXEL * i);
    for (const [k, end] of [MECHANICS.Z0, MECHANICS.Z1].entries()) {
      data[plane + TEXEL * i + k] = mechanics[MECHANICS_SIZE * i + end] as number;
    }
  }
  const texture = new DataArrayTexture(data, width, height, 2);
  texture.format = RGBAFormat;
  texture.type = FloatType;
  texture.name = `channel ${channel}`;
  texture.needsUpdate = true;
  return texture;
}
