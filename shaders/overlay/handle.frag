in vec4 vMark;
out vec4 fragment;

uniform vec3 forceColour;
uniform vec3 paperColour;
uniform vec4 handleWind;
uniform float overlayAlpha;
// 1 while the reader holds it or points at it.
uniform float handleHeld;

void main() {
  float kind = vMark.z;
  vec3 colour = forceColour;
  float alpha;
  if (kind > 3.75) {
    // The knob: paper with a rim of the force's blue; around it a halo, which glows at first and while it is held.
    float r = length(vMark.xy) * vMark.w;
    float one = vMark.w / 22.0;
    float disc = 1.0 - smoothstep(9.5 * one - 0.6, 9.5 * one + 0.6, r);
    float core = 1.0 - smoothstep(6.5 * one - 0.6, 6.5 * one + 0.6, r);
    float dot_ = 1.0 - smoothstep(2.4 * one - 0.6, 2.4 * one + 0.6, r);
    float glow = max(handleWind.w, 0.7 * handleHeld);
    float halo = glow * 0.55 * (1.0 - smoothstep(9.0 * one, 21.0 * one, r));
    colour = mix(forceColour, paperColour, core * (1.0 - dot_));
    alpha = max(disc, halo);
  } else {
    float feather = vMark.w + 1.0;
    float across = abs(vMark.x) * feather;
    alpha = kind > 2.5 ? 1.0 : 1.0 - smoothstep(vMark.w - 0.4, vMark.w + 0.8, across);
    alpha *= kind < 1.5 ? mix(0.5, 0.85, max(handleHeld, handleWind.w)) : 1.0;
  }
  fragment = vec4(colour, alpha * overlayAlpha);
}
