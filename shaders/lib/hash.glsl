#ifndef LIB_HASH
#define LIB_HASH
// Integer noise, bit for bit the same in both languages. Twin: src/core/math/hash.ts

// One step of the PCG hash (Jarzynski & Olano 2020): any unsigned integer to another.
uint hashPcg(uint value) {
  uint state = value * 747796405u + 2891336453u;
  uint word = ((state >> ((state >> 28u) + 4u)) ^ state) * 277803737u;
  return (word >> 22u) ^ word;
}

// An unsigned integer to [0, 1): its upper 24 bits, exact in a float.
float hashUnit(uint hash) {
  return float(hash >> 8u) * (1.0 / 16777216.0);
}
#endif
