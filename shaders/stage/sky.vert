// A dome around the camera, at the far plane. The gradient is smooth, so the corners of a fine dome carry it, not the pixels.
#include /stage/sky.glsl

out vec3 vDirection;
out vec3 vSky;

void main() {
  vDirection = position;
  // Between the horizon and the next row of corners the skylines' band covers it.
  vSky = position.y < 0.001 ? farField(position) : skyColour(position);
  vec4 p = projectionMatrix * mat4(mat3(viewMatrix)) * vec4(position, 1.0);
  gl_Position = p.xyww;
}
