// Bark: one texel gives colour, relief and gloss (src/view/bark-image.ts). The mip levels take the detail back with
// distance, so nothing sparkles.
in vec4 vBark;
in vec3 vAround;

uniform sampler2D barkMap;
uniform vec3 barkColour;
uniform vec3 barkDark;
uniform float barkRelief;
// rgb and how much of it covers the bark: the view by level.
uniform vec4 levelTint;

vec4 barkTexel;

vec3 barkDiffuse() {
  barkTexel = texture(barkMap, vBark.xy);
  // Twigs are younger: no furrows yet, and darker skin.
  barkTexel.x = mix(barkTexel.x, 0.55, vBark.z);
  vec3 bark = mix(barkColour, barkDark, barkTexel.x);
  return mix(bark, levelTint.rgb, levelTint.a);
}

// The normal tilted by the relief; slopes are stored as s / (1 + |s|).
vec3 barkNormal(vec3 surfaceNormal) {
  vec2 s = barkTexel.yz * 2.0 - 1.0;
  s = s / (1.05 - abs(s)) * barkRelief * (1.0 - vBark.z) * (1.0 - levelTint.a);
  vec3 around = normalize(vAround);
  return normalize(surfaceNormal - s.x * around - s.y * cross(surfaceNormal, around));
}

float barkRoughness(float roughness) {
  return mix(roughness, 1.0, 0.7 * barkTexel.x);
}

// Furrows are sheltered as well.
float barkAmbient() {
  return vBark.w * mix(1.0, 0.55, barkTexel.x * barkRelief);
}
