// Colour of a leaf: upper and lower face, its own hue, veins near by, and light that comes through from behind.
in vec4 vLeaf;

uniform vec3 leafColour;
uniform vec3 leafUnder;
uniform vec3 leafGlow;
uniform float leafVariation;
uniform vec4 levelTint;

vec3 leafThrough;

vec3 leafDiffuse(bool front) {
  float own = vLeaf.x;
  float value = 1.0 + leafVariation * (fract(own * 7.31) - 0.5) * 1.1;
  // Some leaves are younger and yellower, few are old and dull.
  float young = leafVariation * fract(own * 13.7);
  vec3 face = front ? leafColour : mix(leafColour, leafUnder, 0.35);
  vec3 c = mix(face, leafGlow, young * 0.8) * value;
#ifdef LEAF_VEINS
  float rib = 1.0 - smoothstep(0.0, 0.07, vLeaf.z);
  float side = abs(fract((vLeaf.w - 0.55 * vLeaf.z) * 7.0) - 0.5);
  float vein = (1.0 - smoothstep(0.0, 0.09, side)) * 0.5 * (1.0 - smoothstep(0.3, 1.0, vLeaf.z));
  c *= 1.0 - 0.10 * vein;
  c = mix(c, c * 1.35 + 0.02, max(rib, 0.35 * vein));
#endif
  leafThrough = mix(leafGlow, leafColour * 1.6, 0.4) * value;
  return mix(c, levelTint.rgb, levelTint.a);
}
