// Places one leaf on its piece and lets it tremble. Read by the standard, depth and distance materials alike.
// position, normal: the unit leaf. blade: distance from the midrib | along the blade | copy within the bundle | how near to the margin.
#include /branch/section.glsl
#include /lib/hash.glsl
#include /lib/quaternion.glsl
#include /leaf/swing.glsl
#include /leaf/texel.glsl
#pragma grove_tree

in vec4 blade;

uniform highp usampler2DArray leaves;
uniform int leafLog2Width;
// Leaves to draw, copies an instance.
uniform ivec2 leafRange;
// Metres that one unit across and one along the blade stand for; larger where they make up for leaves that are left out.
uniform vec2 leafSize;
// Widest angle in radians | time in sixteenths of a beat, wrapped to 0..1
uniform vec2 leafFlutter;
// How far an organ hangs down whichever way its twig points, 0..1.
uniform float leafHang;
// Direction towards which it blows at the tree, tree axes; shorter than 1 where it hardly does.
uniform vec2 leafWind;
#ifdef LEAF_LISTED
// Places of the leaves to draw, 256 a row (src/view/listed-leaves.ts).
uniform highp usampler2D leafPlaces;
#endif
#ifdef LEAF_CUT
// Least and most depth, in the camera's space, at which leaves are drawn by this mesh: others are drawn finer or coarser by another.
uniform vec2 leafCut;
#endif
#ifdef LEAF_PARTED
// Leaves drawn as blades | as points, the one at the border as a fraction each | area of a blade of length and width 1.
uniform vec3 leafPart;
#endif

struct LeafVertex {
  vec3 position;
  vec3 normal;
  // Hash of the leaf, 0..1: colour.
  float own;
};

// a turned about z, then about x, by angles given by their sines, within a right angle.
vec3 swung(vec3 a, vec2 sines, vec2 cosines) {
  a.xy = vec2(cosines.x * a.x - sines.x * a.y, sines.x * a.x + cosines.x * a.y);
  a.yz = vec2(cosines.y * a.y - sines.y * a.z, sines.y * a.y + cosines.y * a.z);
  return a;
}

#ifdef LEAF_CUT
// Is a leaf of this size at a place of the tree drawn by this mesh, and may the picture show it?
bool leafShown(vec3 centre, vec2 size) {
  vec4 seen = modelViewMatrix * vec4(centre, 1.0);
  // A leaf and its stalk, leant over, as a ball; a little more room than it needs at the sides of the view.
  float reach = 1.6 * max(size.x, size.y) * length(modelViewMatrix[0].xyz);
  vec4 at = projectionMatrix * seen;
  vec2 room = at.w + reach + reach * vec2(projectionMatrix[0][0], projectionMatrix[1][1]);
  return -seen.z >= leafCut.x && -seen.z < leafCut.y && all(lessThan(abs(at.xy), room));
}
#endif

// Place of this copy's leaf in their draw order; -1: there is none.
int leafPlace() {
  int copy = gl_InstanceID * leafRange.y + int(blade.z);
  if (copy >= leafRange.x) return -1;
#ifdef LEAF_LISTED
  return int(texelFetch(leafPlaces, ivec2(copy & 255, copy >> 8), 0).x);
#else
  return copy;
#endif
}

LeafVertex leafVertex() {
  int place = leafPlace();
#ifdef GROVE
  vShare = vec2(0.0);
#endif
  if (place < 0) return LeafVertex(vec3(0.0), vec3(0.0, 0.0, 1.0), 0.0);
  ivec2 texel = texelOf(place, leafLog2Width);
  uvec4 bits = texelFetch(leaves, ivec3(texel, LEAF_LEAF), 0);
#ifdef GROVE
  if (!enterTree(leafTree(bits))) return LeafVertex(vec3(0.0), vec3(0.0, 0.0, 1.0), 0.0);
#endif
  LeafTexel leaf = leafTexel(bits);
  Pose pose = readPose(leaf.piece, leaf.odd);
  float phase = leaf.phase;
  float own = hashUnit(hashPcg(uint(phase * 65535.0 + 0.5)));
  Section section = sectionAt(pose, leaf.v);
  vec2 size = leafSize;
#if defined(GROVE) && !defined(LEAF_ORGAN)
  size *= treeTexel(TREE_CROWN).w;
#endif
#ifdef LEAF_CUT
  // Every corner falls on one point, so nothing is drawn.
  if (!leafShown(section.centre, size)) return LeafVertex(vec3(0.0), vec3(0.0, 0.0, 1.0), 0.0);
#endif
  mat3 frame = mat3(section.along, section.t, section.s);
  vec3 p = position * vec3(size, size.y);
#if defined(LEAF_PARTED) && !defined(LEAF_POINT)
  p *= clamp(leafPart.x - float(place), 0.0, 1.0);
#endif
  vec3 n = normal;
  LeafSwing swing = leafSwing(pose.stir, own, phase, leafFlutter.x, leafFlutter.y);
  vec2 sines = swing.sines;
  vec2 cosines = sqrt(1.0 - sines * sines);
  p = swung(p, sines, cosines);
  n = swung(n, sines, cosines);
  p = frame * rotateByQuaternion(leaf.orientation, p);
  n = frame * rotateByQuaternion(leaf.orientation, n);
  // Blades lean downwind, from the foot of the stalk on, which stays where it grew.
  vec3 along = frame * rotateByQuaternion(leaf.orientation, vec3(0.0, 0.0, 1.0));
#ifdef LEAF_ORGAN
  // An organ is round: which side of it shows does not matter.
  vec3 across = frame * rotateByQuaternion(leaf.orientation, vec3(1.0, 0.0, 0.0));
  along = normalize(mix(along, vec3(0.001, 0.0, -1.0), leafHang));
  across = normalize(across - along * dot(across, along) + vec3(0.01, 0.013, 0.0));
  across = normalize(across - along * dot(across, along));
  mat3 hung = mat3(across, cross(along, across), along);
  p = hung * swung(position * size.y, sines, cosines);
  n = hung * swung(normal, sines, cosines);
#endif
  vec3 leant = leanTowards(along, leafWind, swing.lean);
  return LeafVertex(section.centre + turnAlong(p, along, leant), turnAlong(n, along, leant), own);
}
