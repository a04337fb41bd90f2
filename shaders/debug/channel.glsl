// Colours the tree by what engines get of its wind (src/core/io/channels.ts, `channelColour`).
#ifdef CHANNEL_VIEW
#include /lib/hue.glsl

// A texel a piece, as wide as the pose. Layer 0: of a colour red, green, blue; of the sway base, gain, start. Layer 1: z0, z1.
uniform highp sampler2DArray channelTexels;
// As CHANNELS of src/view/channel-look.ts numbers them.
uniform int channelKind;
// Least corner of the tree's box, and its size; metres.
uniform vec3 channelBox[2];

out vec3 vChannel;

vec3 channelOf(int piece, float z) {
  if (channelKind == 1) return vec3(0.0, z, 0.0);
  vec3 told = texelFetch(channelTexels, ivec3(texelOf(piece, poseLog2Width), 0), 0).xyz;
  if (channelKind > 0) return told;
  float s = told.z < 1.0 ? clamp((z - told.z) / (1.0 - told.z), 0.0, 1.0) : 1.0;
  return vec3(min(told.x + told.y * s * s, 1.0), 0.0, 0.0);
}

// Of a leaf: that of its place on the stem, but its own phase, and the foot of its stalk.
vec3 channelOfLeaf(int piece, float v, float phase, vec3 foot) {
  if (channelKind == 3) return hueColour(phase);
  if (channelKind == 4) return clamp((foot - channelBox[0]) / channelBox[1], 0.0, 1.0);
  vec2 span = texelFetch(channelTexels, ivec3(texelOf(piece, poseLog2Width), 1), 0).xy;
  return channelOf(piece, mix(span.x, span.y, v));
}
#endif
