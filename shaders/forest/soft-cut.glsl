// In place of three's test of alpha: what is about as opaque as the test asks for is drawn in part. Stands in a fragment's main.
#ifdef ALPHA_TO_COVERAGE
diffuseColor.a = 0.5 + (diffuseColor.a - alphaTest) / SOFT_EDGE;
if (diffuseColor.a < 0.1) discard;
#else
// Not the noise by which classes share a tree: what fades would lose its densest texels, or its thinnest.
if (diffuseColor.a + SOFT_EDGE * (ditherAt(gl_FragCoord.yx) - 0.5) < alphaTest) discard;
#endif
