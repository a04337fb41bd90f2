// Control polygons and section frames of the pieces as lines; see src/view/control-lines.ts.
#include /branch/read-pose.glsl
#include /lib/frames.glsl

uniform highp sampler2DArray branches;
uniform int branchLog2Width;
// Last place in the draw order of each level.
uniform vec4 levelEnd;
uniform vec3 levelColours[4];
// Length of the frame's arrows in metres.
uniform float frameSize;

out vec4 colour;

void main() {
  ivec2 texel = texelOf(gl_InstanceID, branchLog2Width);
  vec4 span = texelFetch(branches, ivec3(texel, BRANCH_SPAN), 0);
  vec4 stem = texelFetch(branches, ivec3(texel, BRANCH_STEM), 0);
  Pose pose = readPose(int(span.x), mod(stem.z, 2.0) > 0.5);
  float place = float(gl_InstanceID);
  int level = place < levelEnd.x ? 0 : place < levelEnd.y ? 1 : place < levelEnd.z ? 2 : 3;
  vec3 p;
  if (position.x == 0.0) {
    p = position.y == 0.0 ? pose.curve.p0 : position.y == 1.0 ? pose.curve.p1 : position.y == 2.0 ? pose.curve.p2 : pose.curve.p3;
    colour = vec4(levelColours[level], 1.0);
  } else {
    mat3 frame = sectionFrame(pose.curve, handlesOf(pose.curve, pose.across), position.y);
    float size = min(frameSize, 0.2 * stem.x);
    p = bezierPoint(pose.curve, position.y) + (position.x == 1.0 ? frame[1] : frame[2]) * size * position.z;
    // T^ in the blue and S^ in the green of the interface.
    colour = vec4(position.x == 1.0 ? vec3(0.014, 0.159, 0.831) : vec3(0.010, 0.191, 0.051), 0.75);
  }
  gl_Position = projectionMatrix * modelViewMatrix * vec4(p, 1.0);
}
