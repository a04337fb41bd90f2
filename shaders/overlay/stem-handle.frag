in vec4 vMark;
out vec4 fragment;

uniform vec3 inkColour;
uniform vec3 paperColour;
uniform vec3 stemColour;
uniform float overlayAlpha;

// Distance from a chevron that points along +x, its point at `tip`.
float chevron(vec2 p, float tip) {
  p.y = abs(p.y);
  vec2 q = p - vec2(tip, 0.0);
  vec2 way = vec2(-0.7071, 0.7071);
  float along = clamp(dot(q, way), 0.0, 6.0);
  return length(q - way * along);
}

void main() {
  float held = smoothstep(1.0, 2.0, vMark.w);
  float hover = smoothstep(0.0, 1.0, vMark.w);
  if (vMark.z > 2.5) {
    float away = abs(vMark.y);
    float line = 1.0 - smoothstep(0.6, 1.4, away);
    float halo = 1.0 - smoothstep(2.2, 3.4, away);
    fragment = vec4(mix(paperColour, inkColour, line), max(line, 0.75 * halo) * overlayAlpha);
    return;
  }
  float knob = length(vMark.xy) - mix(7.0, 8.5, hover);
  // Which way it goes: a chevron at either side.
  float ways = chevron(vec2(abs(vMark.x), vMark.y), mix(17.5, 19.5, hover)) - 1.1;
  float mark = min(knob, ways);
  float halo = 1.0 - smoothstep(1.4, 2.8, mark);
  float ink = 1.0 - smoothstep(-0.6, 0.6, mark);
  // The knob is paper within a ring of ink; its heart has the level's colour.
  float face = 1.0 - smoothstep(-2.6, -1.6, knob);
  float heart = 1.0 - smoothstep(-0.6, 0.6, length(vMark.xy) - mix(3.2, mix(5.0, 7.0, held), hover));
  vec3 colour = mix(paperColour, inkColour, ink);
  colour = mix(colour, mix(paperColour, stemColour, heart), face);
  fragment = vec4(colour, max(ink, 0.85 * halo) * overlayAlpha);
}
