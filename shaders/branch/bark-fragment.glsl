// Bark: one texel gives colour, relief and gloss (src/core/look/bark-image.ts). The mip levels take the detail back with
// distance, so nothing sparkles.
in vec4 vBark;
in vec3 vAround;

uniform sampler2D barkMap;
uniform vec3 barkColour;
uniform vec3 barkDark;
uniform vec3 barkTwig;
uniform float barkRelief;
// rgb and how much of it covers the bark: the view by level.
uniform vec4 levelTint;

#ifdef BARK_MARKED
uniform vec4 barkTile;
#endif

vec4 barkTexel;
// 1 where the relief shows in full.
float barkBare;

#ifdef BARK_OLD
in vec4 vGrowth;
// Tone | lichen | fine tufts | where moss takes hold (src/core/look/bark-growth.ts).
uniform sampler2D barkGrowth;
// rgb and how much of it there is.
uniform vec4 barkMoss;
uniform vec4 barkLichen;

// Clouds of tone over the tiles, which else repeat for all to see, and what grows on them.
vec3 barkGrown(vec3 bark, vec4 grown) {
  bark *= 1.0 + (grown.x - 0.5) * vec3(0.52, 0.46, 0.38);
  // Rain throws earth at the foot.
  bark *= mix(1.0, 0.72, vGrowth.w * vGrowth.w * smoothstep(0.2, 0.7, grown.w + 0.4 * vGrowth.w));
#ifdef BARK_GROWTH
  float fine = grown.z - 0.5;
  // Crusts sit on what stands out; each has a paler rim.
  float crust = grown.y - (1.0 - 0.8 * barkLichen.a) + 0.1 * fine + 0.12 * (barkTexel.w - 0.5);
  float lichen = barkLichen.a > 0.0 ? smoothstep(-0.03, 0.11, crust) * (1.0 - 0.85 * barkTexel.x) : 0.0;
  bark = mix(bark, barkLichen.rgb * (0.62 + 0.7 * fine + 0.25 * smoothstep(0.16, 0.04, crust)) + 0.25 * bark, 0.8 * lichen);
  float bed = vGrowth.z + 0.9 * (grown.w - 0.5) + 0.25 * fine + 0.2 * (barkTexel.x - 0.3) - 1.25 + 1.35 * barkMoss.a;
  float moss = barkMoss.a > 0.0 ? smoothstep(-0.06, 0.16, bed) : 0.0;
  bark = mix(bark, barkMoss.rgb * (0.72 + 1.1 * fine * (1.0 + bed) + 0.3 * smoothstep(0.0, 0.4, bed)), 0.95 * moss);
  barkTexel.x *= 1.0 - 0.6 * moss;
  barkBare *= 1.0 - 0.55 * moss;
#endif
  return bark;
}
#endif

#pragma bark_own

vec3 barkDiffuse() {
  barkTexel = texture(barkMap, vBark.xy);
  barkBare = 1.0 - vBark.z;
#ifdef BARK_OLD
  vec4 grown = texture(barkGrowth, vGrowth.xy);
#endif
#ifdef BARK_MARKED
  // Eyes and scars that come with every tile are left out here and there, most of them where a tile is large.
  float few = mix(0.46, 0.78, smoothstep(1.1, 2.0, barkTile.x));
  float left = smoothstep(few + 0.06, few - 0.06, grown.w) * smoothstep(0.34, 0.5, barkTexel.x);
  barkTexel.x = mix(barkTexel.x, 0.3, left);
  barkTexel.yz = mix(barkTexel.yz, vec2(0.5), left);
#endif
#ifdef BARK_OWN
  float own = barkOwnTexel();
#endif
  // Twigs are younger: no furrows yet, and a skin of their own.
  vec3 bark = mix(barkColour, barkDark, clamp(barkTexel.x, 0.0, 1.0));
#ifdef BARK_OWN
  bark = barkOwn(bark, own);
#endif
  bark = mix(bark, barkTwig, vBark.z);
  barkTexel.x = mix(barkTexel.x, 0.55, vBark.z);
#ifdef BARK_OLD
  bark = barkGrown(bark, grown);
#endif
  return mix(bark, levelTint.rgb, levelTint.a);
}

// The normal tilted by the relief; slopes are stored as s / (1 + |s|).
vec3 barkNormal(vec3 surfaceNormal) {
  vec2 s = barkTexel.yz * 2.0 - 1.0;
  s = s / (1.05 - abs(s)) * barkRelief * barkBare * (1.0 - levelTint.a);
  vec3 around = normalize(vAround);
  return normalize(surfaceNormal - s.x * around - s.y * cross(surfaceNormal, around));
}

// Cracks are duller, and so is what grows on bark.
float barkRoughness(float roughness) {
  return mix(mix(1.0, roughness, barkBare + vBark.z), 1.0, 0.7 * barkTexel.x);
}

// Furrows are sheltered as well.
float barkAmbient() {
  return vBark.w * mix(1.0, 0.55, barkTexel.x * barkRelief);
}
