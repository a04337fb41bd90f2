// How far the relief of the bark moves the surface outward where one is near: in the shadow maps' programs as in the picture's.
// barkDepth: metres | mip level whose texels are as far apart as the vertices.
uniform sampler2D barkMap;
uniform vec2 barkDepth;

float barkRise(BranchVertex b, float turns) {
  // The last column stands where the first does.
  float height = textureLod(barkMap, barkWrap(b, fract(turns)), barkDepth.y).w;
  return barkDepth.x * (height - 0.55) * smoothstep(0.02, 0.1, b.radius);
}
