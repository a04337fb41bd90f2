in vec3 vMark;
out vec4 fragment;

uniform vec3 inkColour;
uniform vec3 paperColour;
uniform float overlayAlpha;
uniform vec2 envelopeLook;

void main() {
  // What is before the tree is drawn, what is behind it hinted at; both gather towards the rim, as with glass.
  float front = smoothstep(-0.15, 0.25, vMark.z);
  float rim = 1.0 - abs(vMark.z);
  rim *= rim;
  float alpha;
  vec3 colour = paperColour;
  if (vMark.y < 0.5) {
    alpha = mix(0.02, 0.05, front) + 0.22 * rim * rim;
  } else {
    float away = abs(vMark.x);
    float wide = vMark.y > 1.5 ? 0.35 : 0.0;
    float line = 1.0 - smoothstep(0.25 + wide, 1.0 + wide, away);
    float halo = 1.0 - smoothstep(0.8 + wide, 2.3 + wide, away);
    float strength = mix(0.2, mix(0.55, 0.9, rim), front) * (vMark.y > 1.5 ? 1.25 : 1.0);
    colour = mix(paperColour, inkColour, line);
    alpha = max(line * 0.75, halo * 0.4) * strength;
  }
  fragment = vec4(colour, min(alpha, 1.0) * envelopeLook.x * overlayAlpha);
}
