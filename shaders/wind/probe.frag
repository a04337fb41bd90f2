#version 300 es
// Four targets at once, to try whether they keep what is drawn (src/gpu/capabilities.ts).
precision highp float;
layout(location = 0) out vec4 a;
layout(location = 1) out vec4 b;
layout(location = 2) out vec4 c;
layout(location = 3) out vec4 d;

void main() {
  a = vec4(0.0);
  b = vec4(1.0);
  c = vec4(2.0);
  // A number that neither half floats nor bytes hold: 1 + 2^-20 needs 20 bits of fraction, and -70000 is beyond half range.
  d = vec4(1.0 + exp2(-20.0), -70000.0, gl_FragCoord.x, 3.0);
}
