#version 300 es
// One triangle over the whole target, to try whether a context draws what it is told (src/gpu/capabilities.ts).
void main() {
  gl_Position = vec4(vec2[3](vec2(-1.0), vec2(3.0, -1.0), vec2(-1.0, 3.0))[gl_VertexID], 0.0, 1.0);
}
