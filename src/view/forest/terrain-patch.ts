import { BufferAttribute, type InstancedBufferAttribute, InstancedBufferGeometry } from 'three';

/**
 * A square of `cells` x `cells` cells with a skirt around it, for the vertex shader to lay out: x, y in 0..1, z 1 on the skirt.
 *
 * `places`: of each patch drawn, its low corner and side.
 */
export function terrainPatch(cells: number, places: InstancedBufferAttribute): InstancedBufferGeometry {
  const side = cells + 1;
  const position: number[] = [];
  const index: number[] = [];
  for (let j = 0; j < side; j++) for (let i = 0; i < side; i++) position.push(i / cells, j / cells, 0);
  for (let j = 0; j < cells; j++) {
    for (let i = 0; i < cells; i++) {
      const a = j * side + i;
      const c = a + side;
      // The diagonal turns from cell to cell, so that no direction shows.
      if ((i + j) % 2) index.push(a, a + 1, c + 1, a, c + 1, c);
      else index.push(a, a + 1, c, a + 1, c + 1, c);
    }
  }
  // Around the rim, anticlockwise from above.
  const rim: number[] = [];
  for (let i = 0; i < cells; i++) rim.push(i);
  for (let j = 0; j < cells; j++) rim.push(j * side + cells);
  for (let i = cells; i > 0; i--) rim.push(cells * side + i);
  for (let j = cells; j > 0; j--) rim.push(j * side);
  const skirt = position.length / 3;
  for (const at of rim) position.push(position[3 * at] as number, position[3 * at + 1] as number, 1);
  rim.forEach((at, k) => {
    const next = (k + 1) % rim.length;
    const [top, after, low, lowAfter] = [at, rim[next] as number, skirt + k, skirt + next];
    index.push(top, low, after, after, low, lowAfter);
  });
  const geometry = new InstancedBufferGeometry();
  geometry.setAttribute('position', new BufferAttribute(new Float32Array(position), 3));
  geometry.setAttribute('patchPlace', places);
  geometry.setIndex(index);
  geometry.instanceCount = 0;
  return geometry;
}
