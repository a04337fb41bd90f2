import { BufferAttribute, InstancedBufferGeometry } from 'three';

/** Straight parts of a piece. */
const PARTS = 10;

/** Numbers of a piece: piece | odd | radius at its start | at its end. */
export const PIECE_NUMBERS = 4;

/** A ribbon that is drawn once for each piece: v along it | side -1..1. */
export function pieceRibbon(): InstancedBufferGeometry {
  const position: number[] = [];
  const index: number[] = [];
  for (let i = 0; i <= PARTS; i++) {
    position.push(i / PARTS, -1, 0, i / PARTS, 1, 0);
    if (i > 0) index.push(2 * i - 2, 2 * i, 2 * i - 1, 2 * i - 1, 2 * i, 2 * i + 1);
  }
  const geometry = new InstancedBufferGeometry();
  geometry.setAttribute('position', new BufferAttribute(new Float32Array(position), 3));
  geometry.setIndex(index);
  return geometry;
}
