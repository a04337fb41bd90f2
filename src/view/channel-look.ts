import { type DataArrayTexture, Vector3 } from 'three';
import type { ChannelView } from './picture/picture.ts';

/** Channels by the number that shaders/debug/channel.glsl knows them by. */
export const CHANNELS: readonly ChannelView[] = ['sway', 'coordinate', 'branch', 'phase', 'pivot'];

/** The uniforms of the view by channel. */
export function channelUniforms() {
  return {
    channelTexels: { value: null as DataArrayTexture | null },
    channelKind: { value: 0 },
    channelBox: { value: [new Vector3(), new Vector3(1, 1, 1)] },
  };
}

export type ChannelUniforms = ReturnType<typeof channelUniforms>;
