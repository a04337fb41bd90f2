// What a vertex shader under check found, one vertex a texel.
precision highp float;

flat in vec3 surfacePosition;
flat in vec3 surfaceNormal;
flat in vec3 surfaceAround;
flat in vec3 surfaceAlong;

layout(location = 0) out vec4 out0;
layout(location = 1) out vec4 out1;
layout(location = 2) out vec4 out2;
layout(location = 3) out vec4 out3;

void main() {
  out0 = vec4(surfacePosition, 0.0);
  out1 = vec4(surfaceNormal, 0.0);
  out2 = vec4(surfaceAround, 0.0);
  out3 = vec4(surfaceAlong, 0.0);
}
