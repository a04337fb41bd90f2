// Writes the rest pose into a set of targets: at the start, and after a lost context has emptied them.
precision highp float;
precision highp sampler2DArray;

uniform sampler2DArray restPose;

layout(location = 0) out vec4 poseP0;
layout(location = 1) out vec4 poseP1;
layout(location = 2) out vec4 poseP2;
layout(location = 3) out vec4 poseP3;

void main() {
  ivec2 texel = ivec2(gl_FragCoord.xy);
  poseP0 = texelFetch(restPose, ivec3(texel, 0), 0);
  poseP1 = texelFetch(restPose, ivec3(texel, 1), 0);
  poseP2 = texelFetch(restPose, ivec3(texel, 2), 0);
  poseP3 = texelFetch(restPose, ivec3(texel, 3), 0);
}
