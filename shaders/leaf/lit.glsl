// Where light is worked out at the corners of leaves: a leaf is as good as plain, and there are more pixels that try to show it than it has corners.
// LEAF_LIT asks for it. Scenes with other lights than one sun and those of the sky, or with what is mirrored, are lit pixel by pixel.
#ifdef LEAF_LIT
#if !defined(CHANNEL_VIEW) && !defined(USE_ENVMAP) && !defined(USE_LIGHTMAP) && !defined(USE_LIGHT_PROBES) && !defined(USE_REVERSED_DEPTH_BUFFER) && !defined(FLAT_SHADED) && NUM_DIR_LIGHTS <= 1 && NUM_SUN_LIGHTS + NUM_POINT_LIGHTS + NUM_SPOT_LIGHTS + NUM_RECT_AREA_LIGHTS + NUM_LIGHT_PROBE_GRIDS == 0 && (!defined(USE_SHADOWMAP) || defined(SHADOWMAP_TYPE_PCF))
#define LEAF_AT_CORNERS
#endif
#endif
