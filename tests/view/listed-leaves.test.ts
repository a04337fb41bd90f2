import { Matrix4, OrthographicCamera, PerspectiveCamera, Vector3 } from 'three';
import { describe, expect, it } from 'vitest';
import { ListedLeaves, type ListWish } from '../../src/view/listed-leaves.ts';

/** A leaf each half metre along y, from 0 to 50 m. */
const points = Float32Array.from({ length: 300 }, (_, i) => (i % 3 === 1 ? Math.floor(i / 3) / 2 : 0));
const wish: ListWish = { points, count: 100, depth: 5, slack: 1, reach: 0, most: 100 };

/** At the origin, looking along y as a tree has it. */
function camera(y = 0): PerspectiveCamera {
  const eye = new PerspectiveCamera(30, 1, 0.1, 100);
  eye.position.set(0, y, 0);
  eye.up.set(0, 0, 1);
  eye.lookAt(new Vector3(0, y + 1, 0));
  eye.updateMatrixWorld();
  return eye;
}

const listed = ({ uniforms, count }: ListedLeaves): number[] =>
  Array.from(uniforms.leafPlaces.value!.image.data as Uint32Array).slice(0, count);

describe('listed leaves', () => {
  it('are all that are within the depth wherever the wind has them, and none that is far beyond', () => {
    const near = new ListedLeaves();
    expect(near.find(wish, camera(), new Matrix4())).toBe(5);
    const found = listed(near);
    // 5 m and the metre that each may have been moved by.
    for (let i = 0; i <= 12; i++) expect(found).toContain(i);
    expect(Math.max(...found)).toBeLessThan(16);
    expect(near.uniforms.leafRange.value.x).toBe(near.count);
  });

  it('are found again where the camera has gone on, and not for a step', () => {
    const near = new ListedLeaves();
    near.find(wish, camera(), new Matrix4());
    near.find(wish, camera(0.2), new Matrix4());
    expect(listed(near)).toContain(0);
    near.find(wish, camera(20), new Matrix4());
    expect(listed(near)).not.toContain(0);
    expect(listed(near)).toContain(42);
  });

  it('are those up to a lesser depth where there would be too many', () => {
    const near = new ListedLeaves();
    const depth = near.find({ ...wish, depth: 40, slack: 0.1, most: 20 }, camera(), new Matrix4());
    expect(near.count).toBeLessThanOrEqual(20);
    expect(near.count).toBeGreaterThan(8);
    expect(depth).toBeLessThan(10);
    for (let i = 0; i <= 2 * depth; i++) expect(listed(near)).toContain(i);
  });

  it('are shared between two lists: the nearest in one, as many as it may have, all others in the other', () => {
    const [all, fine] = [new ListedLeaves(), new ListedLeaves()];
    const any = { ...wish, depth: Number.POSITIVE_INFINITY };
    const places = (list: ListedLeaves): number[] => listed(list).sort((a, b) => a - b);
    all.find({ ...any, nearer: { list: fine, depth: 5, most: 100 } }, camera(), new Matrix4());
    expect(places(fine)).toEqual([0, 1, 2, 3, 4, 5, 6, 7, 8, 9]);
    expect(places(all)).toEqual(Array.from({ length: 90 }, (_, i) => 10 + i));
    all.find({ ...any, nearer: { list: fine, depth: 20, most: 3 } }, camera(), new Matrix4());
    expect(places(fine)).toEqual([0, 1, 2]);
    expect(all.count).toBe(97);
    all.find(any, camera(), new Matrix4());
    expect(all.count).toBe(100);
    // Half a metre behind the eye: a storm may bring it into view, which one in view does not make room for.
    all.find({ ...any, nearer: { list: fine, depth: 20, most: 3 } }, camera(0.5), new Matrix4());
    expect(places(fine)).toEqual([1, 2, 3]);
    expect(places(all)[0]).toBe(0);
  });

  it('are measured in the space of a tree that is scaled', () => {
    const near = new ListedLeaves();
    near.find(wish, camera(), new Matrix4().makeScale(2, 2, 2));
    expect(Math.max(...listed(near))).toBeLessThan(10);
  });

  it('are found again where the view becomes wider', () => {
    const beside: ListWish = { ...wish, points: Float32Array.of(0, 3, 0, 4, 3, 0), count: 2, slack: 0.1 };
    const near = new ListedLeaves();
    near.find(beside, camera(), new Matrix4());
    expect(listed(near)).toEqual([0]);
    const wide = camera();
    wide.aspect = 8;
    wide.updateProjectionMatrix();
    near.find(beside, wide, new Matrix4());
    expect(listed(near)).toEqual([0, 1]);
  });

  it('are those within the sides of the view, of a part of a larger picture too, and found again where the camera rolls', () => {
    const wide = camera();
    wide.aspect = 4;
    wide.updateProjectionMatrix();
    // 4 m off: 3 m above, which only a tall picture shows, and 3 m to the right.
    const around: ListWish = { ...wish, points: Float32Array.of(0, 4, 3, 3, 4, 0), count: 2, slack: 0.1 };
    const near = new ListedLeaves();
    near.find(around, wide, new Matrix4());
    expect(listed(near)).toEqual([1]);
    wide.up.set(1, 0, 0);
    wide.lookAt(new Vector3(0, 1, 0));
    wide.updateMatrixWorld();
    near.find(around, wide, new Matrix4());
    expect(listed(near)).toEqual([0]);
    const part = camera();
    part.setViewOffset(100, 100, 140, 0, 100, 100);
    near.find(around, part, new Matrix4());
    expect(listed(near)).toEqual([1]);
  });

  it('stay listed while a camera without perspective stands, which sees them at any depth', () => {
    const eye = new OrthographicCamera(-2, 2, 2, -2, 0.1, 100);
    eye.up.set(0, 0, 1);
    eye.lookAt(new Vector3(0, 1, 0));
    eye.updateMatrixWorld();
    const near = new ListedLeaves();
    const any = { ...wish, depth: Number.POSITIVE_INFINITY };
    expect(near.find(any, eye, new Matrix4())).toBe(Number.POSITIVE_INFINITY);
    expect(near.count).toBe(100);
    const texture = near.uniforms.leafPlaces.value!;
    const { version } = texture;
    near.find(any, eye, new Matrix4());
    expect(texture.version).toBe(version);
  });

  it.each([0, 3])('are none where more than the %i that may be hang within the room that wind takes', (most) => {
    const near = new ListedLeaves();
    expect(near.find({ ...wish, slack: 20, most }, camera(), new Matrix4())).toBe(0);
    expect(near.count).toBe(0);
  });
});
