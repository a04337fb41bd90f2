import { Accessor, type Buffer, type Document, type TypedArray } from '@gltf-transform/core';

const TYPES = {
  1: Accessor.Type.SCALAR,
  2: Accessor.Type.VEC2,
  3: Accessor.Type.VEC3,
  4: Accessor.Type.VEC4,
  16: Accessor.Type.MAT4,
} as const;

/** Numbers of a file, `size` a vertex or key. */
export type AccessorSize = keyof typeof TYPES;

/** Adds arrays to a document as accessors of its one buffer. */
export class Accessors {
  readonly #document: Document;
  readonly #buffer: Buffer;

  constructor(document: Document) {
    this.#document = document;
    this.#buffer = document.createBuffer();
  }

  add(array: TypedArray, size: AccessorSize, normalized = false, name = ''): Accessor {
    return this.#document
      .createAccessor(name, this.#buffer)
      .setType(TYPES[size])
      .setArray(array)
      .setNormalized(normalized);
  }
}
