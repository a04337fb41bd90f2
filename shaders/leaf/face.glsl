uniform vec3 leafUnder;
uniform vec4 levelTint;

// Colour of what is seen of a leaf whose upper face has the colour c.
vec3 leafFace(vec3 c, bool front) {
#ifdef LEAF_ORGAN
  // Petals and their middle, scales and the gaps between them.
  c = mix(c, leafUnder, vLeaf.z);
#else
  if (!front) c = mix(c, leafUnder, 0.35 - 0.2 * vLeafTint.w);
  if (vLeaf.x < -0.5) c = mix(c, leafUnder, 0.5);
#endif
  return mix(c, levelTint.rgb, levelTint.a);
}
