// Bends one unit grid along a piece (Skjermo 2006, section 3): read by the standard, depth and distance materials alike.
// position: cos theta | sin theta | v along the piece. normal: theta in turns | copy within the bundle | radius of the coarser grid there.
#include /branch/read-pose.glsl
#include /branch/section.glsl
#include /branch/radius.glsl
#include /branch/surface.glsl
#include /branch/collar.glsl
#pragma grove_tree
#ifdef PARTED
#include /branch/part.glsl
#endif
#ifdef MORPHED
#include /branch/morph.glsl
#if !defined(RIBBON) && !defined(PAPER_FORMS)
#include /branch/flatten.glsl
#endif
#endif

uniform highp sampler2DArray branches;
uniform int branchLog2Width;
// First place in the draw order, number of places, copies an instance.
uniform ivec3 branchRange;
#ifdef RIBBON
// Factor on the radius, which makes up for stems that are left out.
uniform float stemGrowth;
#endif
// taper | flare | lobes | depth of the lobes; fade of the lobes | bulges | their depth | collar
uniform vec4 stemShape[2];

struct BranchVertex {
  SurfacePoint surface;
  // Of the stem here: part of its length, metres from its base, its length, its radius, radius at its base, the parent's radius.
  float z;
  float along;
  float stemLength;
  float radius;
  float baseRadius;
  float parentRadius;
  float phase;
};

BranchVertex branchVertex() {
  BranchVertex result;
  int place = gl_InstanceID * branchRange.z + int(normal.y);
  bool none = place >= branchRange.y;
  ivec2 texel = texelOf(branchRange.x + place, branchLog2Width);
#ifdef GROVE
  vShare = vec2(0.0);
  if (!none) none = !enterTree(int(texelFetch(branches, ivec3(texel, BRANCH_JOINT), 0).w));
#endif
  if (none) {
    // The tail of the last bundle: every corner falls on one point, so nothing is drawn.
    SurfacePoint nowhere = SurfacePoint(vec3(0.0), vec3(0.0, 0.0, 1.0), vec3(1.0, 0.0, 0.0), vec3(0.0, 1.0, 0.0));
    return BranchVertex(nowhere, 0.0, 0.0, 1.0, 0.0, 1.0, 0.0, 0.0);
  }
  vec4 span = texelFetch(branches, ivec3(texel, BRANCH_SPAN), 0);
  vec4 stem = texelFetch(branches, ivec3(texel, BRANCH_STEM), 0);
  Pose pose = readPose(int(span.x), mod(stem.z, 2.0) > 0.5);
  float part = span.z - span.y;
  float v = position.z;
#ifdef PARTED
  v = partOf(v, place, span.yz);
#endif
#ifdef MORPHED
  v = morphedRow(v);
#endif
#ifdef FLARED
  // The flare falls to a hundredth over an eighth of the stem: crowd the rings of its first piece towards the ground.
  if (span.y == 0.0) v *= mix(1.0, v, 0.85);
#endif
#ifdef JOINED
  // What a joint turns and widens lies near the base: crowd the rings of a first piece there.
#ifdef MORPHED
  float crowd = gridMorph.w > 0.0 ? 0.5 - 0.5 * gridMorph.x : 0.5; // a ribbon's rows are even
#else
  const float crowd = 0.5;
#endif
  if (span.y == 0.0) v *= mix(1.0, v, crowd);
#endif
  float z = span.y + part * v;
#ifdef PLAIN_STEM
  // A taper of at most 1 is a cone, also by taperRadius, as long as a stem is longer than thick.
  float taper = stemShape[0].x;
  vec3 rho = vec3(span.w * (1.0 - taper * z), -span.w * taper, 0.0);
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
#if defined(MORPHED) && !defined(RIBBON)
  float drawnRadius = rho.x * morphedRadius(normal.z);
#else
  float drawnRadius = rho.x;
#endif
  float slope = rho.y * part;
#ifdef RIBBON
  // Two columns that face the eye: seen from afar a thin branch needs no more (Malheiros & Walter 2011, section 3.2).
  Section section = sectionAt(pose, v);
  vec4 seen = modelViewMatrix * vec4(section.centre, 1.0);
  vec3 toEye = projectionMatrix[2][3] == 0.0 ? vec3(0.0, 0.0, 1.0) : -seen.xyz;
  vec3 eye = normalize(toEye * mat3(modelViewMatrix));
  vec3 side = unitOr(cross(section.along, eye), section.t);
  vec3 facing = cross(side, section.along);
  vec3 outward = side * position.x;
  result.surface = SurfacePoint(
    section.centre + outward * (rho.x * stemGrowth),
    // 70 degrees to either side: interpolation then shades it as a cylinder without a vanishing normal (erratum E61).
    0.342 * facing + 0.94 * outward,
    side,
    section.along
  );
#else
  // The centre of a cap: its columns meet on the axis, and look along it.
  float rim = position.x == 0.0 && position.y == 0.0 ? 0.0 : 1.0;
#ifdef PAPER_FORMS
  // For teaching. A switch at compile time: software GL runs both sides of a branch.
  Handles handles = projectedHandlesOf(pose.curve, pose.across);
  result.surface = paperSurfacePoint(pose.curve, handles, v, position.x, position.y, rho.x * rim, slope, rho.z);
  if (rim == 0.0) result.surface.normal = tangentAt(pose.curve, handles, v);
#else
  // surfacePoint of branch/surface.glsl, from the section (equations.md 3.2).
  Section section = sectionAt(pose, v);
  vec3 radial = position.y * section.s + position.x * section.t;
  vec3 turn = position.x * section.s - position.y * section.t;
  float g = max(section.speed - rho.x * dot(section.second, radial) / section.speed, 0.01 * section.speed);
#ifdef PLAIN_STEM
  vec3 around = turn;
  vec3 n = g * radial - slope * section.along;
#else
  vec3 around = unitOr(turn + rho.z * radial, turn);
  vec3 n = g * radial - slope * section.along - g * rho.z * turn;
#endif
  result.surface = SurfacePoint(
    section.centre + drawnRadius * rim * radial,
    rim == 0.0 ? section.along : unitOr(n, radial),
    around,
    unitOr(g * section.along + slope * radial, section.along)
  );
#ifdef JOINED
  // Near the parent the surface turns over into the parent's, as where the wood has grown around both.
  vec4 joint = texelFetch(branches, ivec3(texel, BRANCH_JOINT), 0);
  if (dot(joint.xyz, joint.xyz) > 0.5) {
    vec3 first = unitOr(pose.curve.p1 - pose.curve.p0, section.along);
    vec3 axis = joint.x * first + joint.y * pose.across + joint.z * cross(first, pose.across);
    vec3 out_ = result.surface.position - pose.curve.p0;
    out_ -= axis * dot(out_, axis);
    float far = length(out_);
    float near = 1.0 - smoothstep(0.8 * stem.w, stem.w + 1.3 * span.w, far);
    result.surface.normal = unitOr(mix(result.surface.normal, out_ / max(far, 1e-6), 0.85 * near), result.surface.normal);
  }
#endif
#ifdef MORPHED
  if (gridMorph.w > 0.0) {
    vec4 seen = modelViewMatrix * vec4(section.centre, 1.0);
    vec3 toEye = (projectionMatrix[2][3] == 0.0 ? vec3(0.0, 0.0, 1.0) : -seen.xyz) * mat3(modelViewMatrix);
    result.surface = flattened(result.surface, section, normalize(toEye), radial * rim, rho.x, gridMorph.w);
  }
#endif
#endif
#endif
  result.z = z;
  result.along = along;
  result.stemLength = stem.x;
  result.radius = rho.x;
  result.baseRadius = span.w;
  result.parentRadius = stem.w;
  result.phase = stem.y;
  return result;
}
