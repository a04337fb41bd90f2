// Bends one unit grid along a piece (Skjermo 2006, section 3): read by the standard, depth and distance materials alike.
// position: cos theta | sin theta | v along the piece. normal: theta in turns | copy within the bundle | -.
#include /branch/read-pose.glsl
#include /branch/radius.glsl
#include /branch/surface.glsl
#include /branch/collar.glsl

uniform highp sampler2DArray branches;
uniform int branchLog2Width;
// First place in the draw order, number of places, copies an instance.
uniform ivec3 branchRange;
// taper | flare | lobes | depth of the lobes; fade of the lobes | bulges | their depth | collar
uniform vec4 stemShape[2];
// What the handles are carried along with: 1 asks for the paper's projection and section (teaching).
uniform float paperForms;

struct BranchVertex {
  SurfacePoint surface;
  // Of the stem here: metres from its base, its radius, radius at its base, its length, the parent's radius.
  float along;
  float radius;
  float baseRadius;
  float parentRadius;
  float phase;
};

BranchVertex branchVertex() {
  BranchVertex result;
  int place = gl_InstanceID * branchRange.z + int(normal.y);
  if (place >= branchRange.y) {
    // The tail of the last bundle: every corner falls on one point, so nothing is drawn.
    SurfacePoint nowhere = SurfacePoint(vec3(0.0), vec3(0.0, 0.0, 1.0), vec3(1.0, 0.0, 0.0), vec3(0.0, 1.0, 0.0));
    return BranchVertex(nowhere, 0.0, 0.0, 1.0, 0.0, 0.0);
  }
  ivec2 texel = texelOf(branchRange.x + place, branchLog2Width);
  vec4 span = texelFetch(branches, ivec3(texel, BRANCH_SPAN), 0);
  vec4 stem = texelFetch(branches, ivec3(texel, BRANCH_STEM), 0);
  Pose pose = readPose(int(span.x), mod(stem.z, 2.0) > 0.5);
  float part = span.z - span.y;
  float v = position.z;
#ifdef FLARED
  // The flare falls to a hundredth over an eighth of the stem: crowd the rings of its first piece towards the ground.
  if (span.y == 0.0) v *= mix(1.0, v, 0.85);
#endif
  float z = span.y + part * v;
#ifdef PLAIN_STEM
  vec2 profile = taperRadius(z, stemShape[0].x, span.w, stem.x);
  vec3 rho = vec3(profile, 0.0);
#else
  Shape shape = Shape(
    stemShape[0].x, stemShape[0].y, stemShape[0].z, stemShape[0].w, stemShape[1].x, stemShape[1].y, stemShape[1].z
  );
  vec3 rho = stemRadius(shape, span.w, stem.x, z, normal.x);
#endif
  float along = z * stem.x;
  vec2 swell = collar(along, rho.x, stem.w, stemShape[1].w);
  rho.y = rho.y * swell.x + rho.x * swell.y * stem.x;
  rho.x *= swell.x;
  float slope = rho.y * part;
  Handles handles = handlesOf(pose.curve, pose.across);
#ifdef RIBBON
  // Two columns that face the eye: seen from afar a thin branch needs no more (Malheiros & Walter 2011, section 3.2).
  mat3 frame = sectionFrame(pose.curve, handles, v);
  vec3 centre = bezierPoint(pose.curve, v);
  vec4 seen = modelViewMatrix * vec4(centre, 1.0);
  vec3 toEye = projectionMatrix[2][3] == 0.0 ? vec3(0.0, 0.0, 1.0) : -seen.xyz;
  vec3 eye = normalize(toEye * mat3(modelViewMatrix));
  vec3 side = unitOr(cross(frame[0], eye), frame[1]);
  vec3 facing = cross(side, frame[0]);
  vec3 across_ = side * position.x;
  result.surface = SurfacePoint(
    centre + across_ * rho.x,
    // 70 degrees to either side: interpolation then shades it as a cylinder without a vanishing normal (erratum E61).
    0.342 * facing + 0.94 * across_,
    side,
    frame[0]
  );
#else
  // The centre of a cap: its columns meet on the axis, and look along it.
  float rim = position.x == 0.0 && position.y == 0.0 ? 0.0 : 1.0;
  if (paperForms > 0.5) {
    result.surface = paperSurfacePoint(
      pose.curve, projectedHandlesOf(pose.curve, pose.across), v, position.x, position.y, rho.x * rim, slope, rho.z
    );
  } else {
    result.surface = surfacePoint(pose.curve, handles, v, position.x, position.y, rho.x * rim, slope, rho.z);
  }
  if (rim == 0.0) result.surface.normal = tangentAt(pose.curve, handles, v);
#endif
  result.along = along;
  result.radius = rho.x;
  result.baseRadius = span.w;
  result.parentRadius = stem.w;
  result.phase = stem.y;
  return result;
}
