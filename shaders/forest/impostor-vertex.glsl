// One quad that stands for a tree: it faces the eye (in a shadow pass the light) and shows the three pictures that were taken nearest to
// where that is. Read by the standard, depth and distance materials alike. Four vertices a tree. Forest space: metres, z up.
#include /lib/trig.glsl
#include /stage/field.glsl
#include /forest/fade.glsl
#include /forest/laid.glsl
#include /forest/octahedral.glsl

// Where it stands | its size as a part of that of the picture's tree.
in vec4 farPlace;
// Angle that it is turned by, from x to y | layer of the atlas | how much of it has come, and of the tree that is nearer, 0..1.
in vec4 farLook;

// Views along a side of a layer | texels of a view | softness of the trees in this wind | mean force of it.
uniform vec4 farViews;
// A row a layer: LayerFacts of src/view/forest/impostor-atlas.ts.
uniform highp sampler2D farTable;

// Range of the noise in which the tree is drawn.
flat out vec2 vShare;
// Place on each of the three views, 0..1.
out vec4 vViewsAB;
out vec2 vViewC;
// On the quad, in halves of its height.
out vec2 vQuad;
// Row and column of each, their weights; how far a step of a metre towards the eye moves the place on each. Then the layer and its level;
// metres of depth to each side, the tree's own number.
flat out vec4 vCellsAB;
flat out vec4 vCellC;
flat out vec3 vWeights;
flat out vec4 vAsideAB;
flat out vec4 vAsideC;

struct FarVertex {
  vec3 position;
  // Of the tree in forest space; from its centre to the corner and unit vector to the eye, in tree space and metres of the picture's tree.
  vec2 turn;
  vec3 corner;
  vec3 eye;
  int layer;
  // How far a gust lays it over, 0..1.
  float laid;
};

vec4 farFact(int layer, int column) {
  return texelFetch(farTable, ivec2(column, layer), 0);
}

vec3 farTurned(vec2 turn, vec3 p) {
  return vec3(turn.x * p.x - turn.y * p.y, turn.x * p.y + turn.y * p.x, p.z);
}

vec2 farOnView(mat3 frame, vec3 p, vec2 half_) {
  return vec2(dot(frame[0], p), dot(frame[1], p)) / half_;
}

FarVertex farVertex() {
  FarVertex result;
  result.layer = int(farLook.y + 0.5);
  vec4 a = farFact(result.layer, 0);
  vec4 b = farFact(result.layer, 1);
  float size = farPlace.w;
  float pixels = treePixels(farPlace.xyz, b.y * size, forestEye, forestScale);
  vShare = treeShares(forestFade, pixels, farLook.zw);
  result.turn = vec2(cosTurns(farLook.x * 0.15915494), sinTurns(farLook.x * 0.15915494));
  vec3 centre = farPlace.xyz + size * farTurned(result.turn, a.xyz);
  // From the camera that draws: in a shadow pass that is the light's.
  mat3 view = mat3(modelViewMatrix);
  vec3 seen = projectionMatrix[2][3] == 0.0 ? vec3(0.0, 0.0, 1.0) * view : -(modelViewMatrix[3].xyz * view) - centre;
  vec3 d = vec3(result.turn.x * seen.x + result.turn.y * seen.y, result.turn.x * seen.y - result.turn.y * seen.x, seen.z);
  // From below it is shown as from beside: there are no pictures from under the ground.
  d.z = max(d.z, 0.0);
  d = normalize(d + vec3(1e-5, 0.0, 0.0));
  mat3 frame = viewFrame(d);
  vec2 half_ = vec2(a.w, b.x);
  vec2 side = vec2(gl_VertexID & 1, (gl_VertexID >> 1) & 1) * 2.0 - 1.0;
  vec3 corner = frame[0] * (side.x * half_.x) + frame[1] * (side.y * half_.y);
  mat3 views = nearestViews(d, farViews.x);
  mat3 frameA = viewFrame(viewDirection(views[0].xy, farViews.x));
  mat3 frameB = viewFrame(viewDirection(views[1].xy, farViews.x));
  mat3 frameC = viewFrame(viewDirection(views[2].xy, farViews.x));
  vViewsAB = 0.5 + 0.5 * vec4(farOnView(frameA, corner, half_), farOnView(frameB, corner, half_));
  vViewC = 0.5 + 0.5 * farOnView(frameC, corner, half_);
  vAsideAB = 0.5 * vec4(farOnView(frameA, d, half_), farOnView(frameB, d, half_));
  // How far the depth of a view reaches to each side of its middle; the gutter is no part of it.
  float reach = b.x * (1.0 - 3.0 / farViews.y);
  vAsideC = vec4(0.5 * farOnView(frameC, d, half_), reach, fract(dot(farPlace.xy, vec2(0.7548, 0.5698))));
  vQuad = side * vec2(half_.x / half_.y, 1.0);
  vCellsAB = vec4(views[0].xy, views[1].xy);
  vWeights = vec3(views[0].z, views[1].z, views[2].z);
  // A texel of the finest level for a pixel, or that of a coarser one.
  float pixelsOfView = 2.0 * b.x * size * forestScale / max(distance(forestEye, centre), 0.1);
  float lod = log2(farViews.y / max(pixelsOfView, 1e-3));
  vCellC = vec4(views[2].xy, float(result.layer), projectionMatrix[2][3] == 0.0 ? 1.0 : clamp(lod, 0.0, 4.0));
  vec3 place = centre + size * farTurned(result.turn, corner);
  // Leans as the crown does, with the square of the height.
  float up = clamp((place.z - farPlace.z) / max(b.y * size, 0.01), 0.0, 1.2);
  vec2 force = fieldForce(farPlace.xy);
  result.laid = crownLaid(length(force), farViews.w) * min(up, 1.0);
  // What is bent far gives way less (src/core/forest/crown-give.ts tries a force of a half).
  force /= max(1.0, 0.86 + 0.28 * length(force));
  place.xy += force * (b.z * farViews.z * up * up);
  result.position = vShare.x < vShare.y ? place : farPlace.xyz;
  result.corner = corner;
  result.eye = d;
  return result;
}
