import channel from '../../shaders/debug/channel.glsl';
import { providePart } from './inject.ts';

const part = (name: string, text: string): void =>
  providePart(`channel_${name}`, `#ifdef CHANNEL_VIEW\n${text}\n#endif`);

/**
 * Gives the shaders of bark and leaf what they need to show a channel in place of their own colour: they have a pragma in each place. It comes
 * with the texels of the channels, which a page that only shows a tree never loads.
 */
export function provideChannels(): void {
  part('vertex', channel);
  part(
    'branch',
    `ivec2 channelTexel = texelOf(branchRange.x + gl_InstanceID * branchRange.z + int(normal.y), branchLog2Width);
vChannel = channelOf(int(texelFetch(branches, ivec3(channelTexel, BRANCH_SPAN), 0).x), here.along / texelFetch(branches, ivec3(channelTexel, BRANCH_STEM), 0).x);`,
  );
  part(
    'leaf',
    `LeafTexel channelLeaf = leafTexel(texelFetch(leaves, ivec3(texelOf(max(leafPlace(), 0), leafLog2Width), LEAF_LEAF), 0));
vec3 channelFoot = sectionAt(readPose(channelLeaf.piece, channelLeaf.odd), channelLeaf.v).centre;
vChannel = channelOfLeaf(channelLeaf.piece, channelLeaf.v, channelLeaf.phase, channelFoot);`,
  );
  part('fragment', 'in vec3 vChannel;');
  // Where the colour is known. Channels are numbers as a screen shows them; light falls on linear ones.
  part('diffuse', 'diffuseColor.rgb = pow(vChannel, vec3(2.2));');
}
