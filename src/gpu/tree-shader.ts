import { layoutGlsl } from '../core/pack/layout-glsl.ts';

// Before the layout: the default precision of int in a fragment shader holds only indices up to 32 767.
const PRECISION = `precision highp float;
precision highp int;
precision highp sampler2D;
precision highp sampler2DArray;
`;

/** A shader that reads a tree: full precision, the constants of the layout, then `source`. */
export const treeShader = (source: string): string => `${PRECISION}${layoutGlsl()}${source}`;
