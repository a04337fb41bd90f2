#ifndef DEBUG_CHECK
#define DEBUG_CHECK
// One sample a texel: its inputs are the layers of `inputs`, its results go to four targets.
precision highp float;
precision highp int;
precision highp sampler2D;
precision highp sampler2DArray;

uniform sampler2DArray inputs;

layout(location = 0) out vec4 out0;
layout(location = 1) out vec4 out1;
layout(location = 2) out vec4 out2;
layout(location = 3) out vec4 out3;

// Four numbers of this sample's input.
vec4 given(int layer) {
  return texelFetch(inputs, ivec3(ivec2(gl_FragCoord.xy), layer), 0);
}
#endif
