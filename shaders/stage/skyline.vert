// A ring around the camera, a hair before the far plane: the dome behind it is not drawn there.
#include /stage/sky.glsl

out vec3 vDirection;
out vec3 vSky;

void main() {
  vDirection = position;
  vSky = skyColour(normalize(position));
  vec4 p = projectionMatrix * mat4(mat3(viewMatrix)) * vec4(position, 1.0);
  gl_Position = vec4(p.xy, p.w * 0.99999, p.w);
}
