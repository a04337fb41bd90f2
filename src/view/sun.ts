import { Box3, DirectionalLight, Matrix4, Vector3 } from 'three';

const corner = new Vector3();
const turned = new Matrix4();
const seen = new Box3();

/** Length of the longest shadow that is drawn, in heights of what throws it. */
const LONGEST = 9;

/** The sun: a directional light whose shadow map is fitted to what casts shadows. */
export class Sun extends DirectionalLight {
  /** From the scene to the sun, unit length. */
  readonly direction = new Vector3(0.8, 0.5, 0.28).normalize();

  /** Metres of the shadow map's texel. */
  texel = 0.01;
  #box = new Box3(new Vector3(-2, 0, -2), new Vector3(2, 6, 2));

  constructor(mapSize: number) {
    super();
    this.name = 'sun';
    this.castShadow = true;
    this.shadow.mapSize.setScalar(mapSize);
    this.shadow.radius = 1.6;
  }

  /** Texels a side of the shadow map. */
  set mapSize(texels: number) {
    const { shadow } = this;
    if (shadow.mapSize.x === texels) return;
    shadow.mapSize.setScalar(texels);
    shadow.map?.dispose();
    shadow.map = null;
    this.fit(this.#box);
  }

  /** Shines from another direction, unit length. */
  shineFrom(x: number, y: number, z: number): void {
    this.direction.set(x, y, z).normalize();
    this.fit(this.#box);
  }

  /** Fits the shadow's frustum to a box around the casters, y up; receivers below them, on the ground, are covered too. */
  fit(box: Box3): void {
    this.#box.copy(box);
    const centre = box.getCenter(new Vector3());
    const size = box.getSize(new Vector3()).length() || 1;
    this.target.position.copy(centre);
    this.position.copy(centre).addScaledVector(this.direction, size);
    this.updateMatrixWorld();
    this.target.updateMatrixWorld();
    turned.identity().lookAt(this.position, centre, this.up).setPosition(this.position).invert();
    const { camera } = this.shadow;
    seen.makeEmpty();
    for (let i = 0; i < 8; i++) {
      corner.set(i & 1 ? box.max.x : box.min.x, i & 2 ? box.max.y : box.min.y, i & 4 ? box.max.z : box.min.z);
      seen.expandByPoint(corner.applyMatrix4(turned));
    }
    // A long shadow ends where the ray from the highest corner meets the ground, or where nobody follows it any more.
    const height = Math.max(0, box.max.y);
    const reach = Math.min(height / Math.max(0.05, this.direction.y), LONGEST * height);
    camera.left = seen.min.x;
    camera.right = seen.max.x;
    camera.top = seen.max.y;
    camera.bottom = seen.min.y;
    camera.near = 0.01 * size;
    camera.far = -seen.min.z + reach;
    camera.updateProjectionMatrix();
    // Half a texel's slope of a leaf that lies aslant to the light; in metres for the normal, in depth for the rest.
    this.texel = Math.max(seen.max.x - seen.min.x, seen.max.y - seen.min.y) / this.shadow.mapSize.x;
    this.shadow.normalBias = this.texel * 1.6;
    this.shadow.bias = (-this.texel * 0.6) / (camera.far - camera.near);
    this.shadow.needsUpdate = true;
  }
}
