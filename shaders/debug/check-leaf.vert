// The leaf shader as it is drawn, its vertices written to texels instead of the screen. In front stands the layout.
// position and normal: the unit leaf (shaders/leaf/vertex.glsl). slot: the texel of the vertex.
in vec3 position;
in vec3 normal;
in vec2 slot;

#include /leaf/vertex.glsl

flat out vec3 surfacePosition;
flat out vec3 surfaceNormal;
flat out vec3 surfaceAround;
flat out vec3 surfaceAlong;

void main() {
  LeafVertex here = leafVertex();
  surfacePosition = here.position;
  surfaceNormal = here.normal;
  surfaceAround = vec3(here.own);
  surfaceAlong = vec3(0.0);
  gl_Position = vec4(slot, 0.0, 1.0);
  gl_PointSize = 1.0;
}
