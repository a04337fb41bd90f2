#ifndef WIND_SPRING
#define WIND_SPRING
// spring: every stem is a damped oscillator about its bend at rest, two axes wide. One step of 1/60 s. Tree space, metres, seconds.
// A shader that includes this stands behind the layout: STATE_Q, STATE_BASE and STATE_END are the three targets.
// Twin: src/core/wind/spring.ts

// Steps a second.
const float SPRING_RATE = 60.0;

// The state of one piece: a texel of each of STATE_TARGETS.
struct Spring {
  vec4 q;
  vec4 base;
  vec4 end;
};

// What the bend of a piece strives for, along the columns L, T and S of its frame at rest: the wind's bend, less what the
// acceleration of its base (m/s^2) throws it back; that is at most 1. lever: SPRING_LOAD.x times the wind's inertia.
vec3 springTarget(mat3 frame, vec3 beta, vec3 acceleration, float lever) {
  vec2 thrown = lever * (acceleration * frame).yz;
  thrown /= max(1.0, length(thrown));
  return beta * frame - vec3(0.0, thrown);
}

// The state at time 0: at the target, not moving. force: |F| in metres.
Spring springStart(vec3 target, float force) {
  return Spring(vec4(target.yz, 0.0, 0.0), vec4(0.0, 0.0, 0.0, force), vec4(0.0, 0.0, 0.0, target.x));
}

// One step towards a target that stands still meanwhile, exactly. q: STATE_Q before; transition: SPRING_STEP; base: acceleration of
// the piece's base; reach: SPRING_LOAD.y.
Spring springStep(vec4 q, vec3 target, vec4 transition, mat3 frame, vec3 base, float reach, float force) {
  vec2 x = q.xy - target.yz;
  vec2 moved = transition.x * x + transition.y * q.zw;
  vec2 faster = transition.z * x + transition.w * q.zw;
  vec2 swung = faster * (SPRING_RATE * reach);
  return Spring(q + vec4(moved, faster), vec4(base, force), vec4(base + frame[1] * swung.x + frame[2] * swung.y, target.x));
}

// The state between two steps.
Spring mixSpring(Spring a, Spring b, float f) {
  return Spring(mix(a.q, b.q, f), mix(a.base, b.base, f), mix(a.end, b.end, f));
}

// The bend of a state along L, T and S, for framePush.
vec3 springBend(Spring s) {
  return vec3(s.end.w, s.q.xy);
}

// How hard the leaves are shaken, metres of force: by the wind, and by a tenth of a second of the branch's own way.
float springStir(Spring s, float third) {
  return s.base.w + 0.1 * third * length(s.q.zw);
}
#endif
