// The branch deformer as it is drawn, its vertices written to texels instead of the screen. In front stands the layout.
// position and normal: src/view's unit grid (shaders/branch/vertex.glsl). slot: the texel of the vertex.
in vec3 position;
in vec3 normal;
in vec2 slot;

uniform mat4 modelViewMatrix;
uniform mat4 projectionMatrix;

#include /branch/vertex.glsl

flat out vec3 surfacePosition;
flat out vec3 surfaceNormal;
flat out vec3 surfaceAround;
flat out vec3 surfaceAlong;

void main() {
  BranchVertex here = branchVertex();
  surfacePosition = here.surface.position;
  surfaceNormal = here.surface.normal;
  surfaceAround = here.surface.around;
  surfaceAlong = here.surface.along;
  gl_Position = vec4(slot, 0.0, 1.0);
  gl_PointSize = 1.0;
}
