// Blades stand up: a low sun, at which the ground hardly looks, still lights them.
vec3 groundNormal(vec3 normal) {
#if NUM_DIR_LIGHTS > 0
  vec3 light = directionalLights[0].direction;
  vec3 level = light - normal * dot(light, normal);
  return normalize(normal + groundTree.y * level);
#else
  return normal;
#endif
}
