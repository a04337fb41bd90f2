import { formMesh, formTriangles, type LeafMesh } from './form-mesh.ts';
import type { LeafGrain } from './leaf-outline.ts';
import { leafForm } from './leaf-shapes.ts';
import type { LeafSpec } from './leaf-spec.ts';

export type { LeafMesh } from './form-mesh.ts';
export type { LeafGrain } from './leaf-outline.ts';
export type { LeafSpec } from './leaf-spec.ts';

/** The mesh of one leaf, repeated `bundle` times. Throws RangeError for an unknown shape. */
export const leafMesh = (spec: LeafSpec, grain: LeafGrain, bundle: number): LeafMesh =>
  formMesh(leafForm(spec), spec, grain, bundle);

/** Triangles of one leaf. Throws RangeError for an unknown shape. */
export const leafTriangles = (spec: LeafSpec, grain: LeafGrain): number => formTriangles(leafForm(spec), spec, grain);
