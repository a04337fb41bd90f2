// Copies a state of the springs, texel by texel: into a checkpoint, and back.
precision highp float;

uniform highp sampler2D springFirst[4];

layout(location = 0) out vec4 stateQ;
layout(location = 1) out vec4 stateBase;
layout(location = 2) out vec4 stateEnd;
layout(location = 3) out vec4 stateLean;

void main() {
  ivec2 texel = ivec2(gl_FragCoord.xy);
  stateQ = texelFetch(springFirst[0], texel, 0);
  stateBase = texelFetch(springFirst[1], texel, 0);
  stateEnd = texelFetch(springFirst[2], texel, 0);
  stateLean = texelFetch(springFirst[3], texel, 0);
}
