#ifndef WIND_RECORDED
#define WIND_RECORDED
// A measured wind, carried along by its mean. Metres, tree axes. Twin: src/core/wind/record-state.ts (fillRecord fills the uniforms)

// RGBA32F, 1024 wide, a texel a sample: force x, y of it and of the next one, in the world's axes.
uniform highp sampler2D windRecord;
// At the tree's place: whole sample | fraction of the way to the next | samples around | weight, 0..1.
uniform vec4 windRecordAt;
// Samples a metre downwind, as a vector | cosine and sine of the tree's yaw.
uniform vec4 windRecordTravel;

// Force of the record at xy, linear between samples: a point downwind hears what was heard upwind (Taylor 1938).
vec2 recordForce(vec2 xy) {
  float i = windRecordAt.y - dot(windRecordTravel.xy, xy);
  float whole = floor(i);
  float index = windRecordAt.x + whole;
  // Half a sample keeps the quotient off whole numbers, where a division that is rounded otherwise would be one off.
  int texel = int(index - windRecordAt.z * floor((index + 0.5) / windRecordAt.z));
  vec4 samples = texelFetch(windRecord, ivec2(texel & 1023, texel >> 10), 0);
  vec2 force = mix(samples.xy, samples.zw, i - whole) * windRecordAt.w;
  return vec2(dot(force, windRecordTravel.zw), dot(force, vec2(-windRecordTravel.w, windRecordTravel.z)));
}
#endif
