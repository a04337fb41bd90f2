// The ground over which one gust blows now: a strip along its way, cut to the meadow. Tree space, z up. One instance a gust.
// position: along the way 0..1 | across -1..1.
#include /wind/gust.glsl

// How far gusts are shown, and how high above the ground; metres.
uniform vec2 frontReach;

// Seconds since the front passed here | metres off the gust's axis | place from the tree, metres (its length would not be linear).
out vec4 vFront;
// Peak | 1/width | rise | fall
flat out vec4 vGust;

void main() {
  vec4 push = windGusts[3 * gl_InstanceID];
  vec4 timing = windGusts[3 * gl_InstanceID + 1];
  float offset = windGusts[3 * gl_InstanceID + 2].x;
  float speed = 1.0 / max(timing.x, 1e-6);
  // Where the front is along its way, seen from the tree; behind it lies all that it still shakes.
  float front = timing.y * speed;
  float from = clamp(front - speed * (timing.z + timing.w), -frontReach.x, frontReach.x);
  float to = clamp(front, -frontReach.x, frontReach.x);
  float along = mix(from, to, position.x);
  float reach = push.w > 0.0 ? min(1.4 / push.w, frontReach.x) : frontReach.x;
  float across = position.y * reach - (push.w > 0.0 ? offset : 0.0);
  vec2 ground = push.xy * along + vec2(-push.y, push.x) * across;
  vFront = vec4(timing.y - along * timing.x, across + offset, ground);
  vGust = vec4(push.zw, timing.zw);
  gl_Position = projectionMatrix * modelViewMatrix * vec4(ground, frontReach.y, 1.0);
}
