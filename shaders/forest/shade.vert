// The shadow of one tree on the ground, from above: an ellipse, and the crown's own outline, as quads of a picture of the ground.
in vec2 corner;
// Middle x, y; half the long axis x, y; forest space, metres.
in vec4 ellipse;
// Half the short axis, metres; how much of the light is taken in the middle, of the sun and of the sky.
in vec3 strength;

uniform float shadeScale;

out vec2 vCorner;
out vec2 vTaken;

void main() {
  vec2 along = ellipse.zw;
  vec2 across = normalize(vec2(-along.y, along.x) + vec2(1e-9, 0.0)) * strength.x;
  vec2 xy = ellipse.xy + corner.x * along + corner.y * across;
  vCorner = corner;
  vTaken = strength.yz;
  gl_Position = vec4(xy * shadeScale, 0.0, 1.0);
}
