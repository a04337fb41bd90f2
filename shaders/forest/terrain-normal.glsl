// The ground's normal in the space of the view. Blades stand up to the light, as groundNormal in stage/ground-normal.glsl has them; of a unit
// vector, and one at right angles to it, the length of the sum is known.
vec3 terrainNormal() {
  // Forest space is x, -z, y of the world.
  vec3 normal = mat3(viewMatrix) * vec3(terrainUp.xz, -terrainUp.y);
#if NUM_DIR_LIGHTS > 0
  vec3 light = directionalLights[0].direction;
  float facing = dot(light, normal);
  vec3 level = light - normal * facing;
  return (normal + groundTree.y * level) * inversesqrt(1.0 + groundTree.y * groundTree.y * (1.0 - facing * facing));
#else
  return normal;
#endif
}
